// Limits of the overrides that an operator sets, in percent.
export type Share = "override" | "rapid" | "spindle";

/// Feeds go up to 150 %, up to 200 % by a setting.
export const most_feed = (wide: boolean): number => (wide ? 200 : 150);

/// Returns the nearest allowed override.
export function bounded_override(name: Share, percent: number, most_of_feed: number): number {
  const [least, most] = name === "override" ? [0, most_of_feed] : name === "rapid" ? [0, 100] : [50, 120];
  return Math.min(most, Math.max(least, Math.round(percent)));
}
