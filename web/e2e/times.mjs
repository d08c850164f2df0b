// What the measuring scripts print of their times.
export function told_times(name, times) {
  const sorted = [...times].sort((a, b) => a - b),
    at = (part) => sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))].toFixed(1);
  console.log(
    `${name.padEnd(24)} median ${at(0.5)}, nine of ten ${at(0.9)}, least ${at(0)}, greatest ${at(1)} ms, of ${sorted.length}`,
  );
}
