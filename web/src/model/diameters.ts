// Axes in diameter programming: the session sends true lengths, the page shows them as the program writes them, with the
// sign Ø, so that nobody takes a radius for a diameter.
import { turns } from "./units";

export const diameter_sign = "Ø";

/// The axes whose positions are shown as diameters.
export type Diameters = readonly string[];
export const no_diameters: Diameters = [];

export const is_diameter = (axis: string, of: Diameters): boolean => !turns(axis) && of.includes(axis);

/// Returns the factor from the true length to the shown one.
export const factor = (axis: string, of: Diameters): 1 | 2 => (is_diameter(axis, of) ? 2 : 1);

/// Returns the axis with the sign of a diameter where it is one.
export const axis_name = (axis: string, of: Diameters): string =>
  is_diameter(axis, of) ? `${axis} ${diameter_sign}` : axis;

/// Returns the greatest diameter of a range along X, true lengths.
export const widest = (from: number, to: number): number => 2 * Math.max(Math.abs(from), Math.abs(to));
