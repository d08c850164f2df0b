// How figures are written: the same everywhere on the page.
export function coordinate(v: number | undefined | null): string {
  if (v === undefined || v === null || !Number.isFinite(v)) return "–";
  const s = v.toFixed(3);
  return s === "-0.000" ? "0.000" : s;
}

export function short(v: number | undefined | null, digits = 0): string {
  if (v === undefined || v === null || !Number.isFinite(v)) return "–";
  return grouped(Number(v.toFixed(digits)));
}

/// 12345.5 as 12 345.5 with narrow spaces, as both languages read it.
export function grouped(v: number): string {
  const [whole, rest] = String(v).split(".");
  const w = whole!.replace(/\B(?=(\d{3})+(?!\d))/g, "\u202f");
  return rest === undefined ? w : `${w}.${rest}`;
}

/// h:mm:ss, or m:ss.t below an hour.
export function clock(seconds: number | undefined | null): string {
  if (seconds === undefined || seconds === null || !Number.isFinite(seconds)) return "–";
  const tenths = Math.round(Math.max(0, seconds) * 10),
    s = Math.floor(tenths / 10);
  const two = (n: number): string => String(n).padStart(2, "0");
  if (s >= 3600) return `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`;
  return `${Math.floor(s / 60)}:${two(s % 60)}.${tenths % 10}`;
}

export function bytes(n: number): string {
  if (n < 1000) return `${n} B`;
  return n < 1e6 ? `${(n / 1e3).toFixed(1)} kB` : `${(n / 1e6).toFixed(1)} MB`;
}
