// Touching the part with a probe at a clicked position: along the axis that its surface faces, on an approach that
// keeps clear of the surface.
import type { Axes, Panel, WayPoint } from "../protocol/types";

type Point = readonly [number, number, number];
export const touch_axes = ["X", "Y", "Z"] as const;
export type TouchAxis = (typeof touch_axes)[number];

/// Lengths in mm, feed in mm/min. `clearance`: work coordinate of Z at which the approach crosses; `away`: distance
/// from the surface where the motion at `feed` starts; `radius` of the ball.
export interface TouchRules {
  clearance: number;
  away: number;
  feed: number;
  radius: number;
}
/// `sense`: the direction along the axis that the surface faces; `at`: work coordinate of the surface.
export interface Touch {
  axis: TouchAxis;
  sense: 1 | -1;
  at: number;
  way: WayPoint[];
}

const enough = 0.7; // least component of the normal along the axis: with less a touch would slip off

/// `place`, `normal`: of the surface, in the view's coordinates; `zero` of the picture. Null: no axis can touch there
/// (from below, or at an angle).
export function touch_at(
  place: Point,
  normal: Point,
  zero: Point,
  p: Pick<Panel, "position" | "machine" | "zero">,
  rules: TouchRules,
): Touch | null {
  const k = [0, 1, 2].reduce((best, i) => (Math.abs(normal[i]!) > Math.abs(normal[best]!) ? i : best), 0),
    axis = touch_axes[k]!,
    sense = normal[k]! > 0 ? 1 : -1;
  if (Math.abs(normal[k]!) < enough || (axis === "Z" && sense < 0)) return null;
  const work: Axes = {},
    beside: Axes = {};
  touch_axes.forEach((a, i) => {
    work[a] = place[i]! + zero[i]! - (p.zero[a] ?? 0);
    beside[a] = (p.machine[a] ?? 0) - (p.position[a] ?? 0);
  });
  const to = (at: Axes): Axes =>
    Object.fromEntries(Object.entries(at).map(([a, v]) => [a, Math.round(1e6 * (v + beside[a]!)) / 1e6]));
  const rapid = (at: Axes): WayPoint => ({ rapid: true, to: to(at), feed: 0 }),
    slow = (at: Axes): WayPoint => ({ rapid: false, to: to(at), feed: rules.feed });
  const stop = work[axis]! + (axis === "Z" ? 0 : sense * rules.radius),
    before = stop + sense * rules.away,
    low = axis === "Z" ? before : work["Z"]! - rules.radius;
  const way: WayPoint[] = [];
  if ((p.position["Z"] ?? 0) < rules.clearance) way.push(rapid({ Z: rules.clearance }));
  way.push(rapid({ X: work["X"]!, Y: work["Y"]!, ...(axis === "Z" ? {} : { [axis]: before }) }));
  way.push(
    axis === "Z" ? rapid({ Z: Math.min(before, Math.max(rules.clearance, p.position["Z"] ?? 0)) }) : slow({ Z: low }),
  );
  way.push(
    slow({ [axis]: stop }),
    rapid({ [axis]: before }),
    rapid({ Z: Math.max(rules.clearance, axis === "Z" ? before : low) }),
  );
  return { axis, sense, at: Math.round(1e6 * work[axis]!) / 1e6, way };
}
