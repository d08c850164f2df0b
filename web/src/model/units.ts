// Lengths and feeds as the page shows them: in the unit of the program, or in the chosen one. The session always sends
// mm and degrees.
import { t, write_anew } from "../texts/texts";

export type Unit = "mm" | "inch";
const mm_per_inch = 25.4;
let of_program: Unit = "mm",
  chosen: Unit | null = null,
  file = "";

export const unit = (): Unit => chosen ?? of_program;

/// Sets the unit of the program that has been run; a choice for another program is forgotten.
export function take_program_unit(of: string, its: Unit): void {
  const before = unit();
  if (of !== file) chosen = null;
  file = of;
  of_program = its;
  if (unit() !== before) write_anew();
}

/// Chooses the unit for the open program.
export function choose_unit(wanted: Unit): void {
  const before = unit();
  chosen = wanted;
  if (unit() !== before) write_anew();
}

/// Converts mm or mm/min to the shown unit.
export const in_unit = (mm: number): number => (unit() === "inch" ? mm / mm_per_inch : mm);
/// A thousandth of a millimetre needs four decimals of an inch.
export const places = (): number => (unit() === "inch" ? 4 : 3);

export const length_unit = (): string => t(unit() === "inch" ? "inch" : "mm");
export const feed_unit = (): string => t(unit() === "inch" ? "inch_min" : "mm_min");
/// Of a feed per revolution of the spindle.
export const turn_unit = (): string => t(unit() === "inch" ? "inch_turn" : "mm_turn");
export const surface_unit = (): string => t(unit() === "inch" ? "foot_min" : "m_min");
export const volume_unit = (): string => t(unit() === "inch" ? "inch3" : "mm3");
/// Converts mm³ to the shown unit.
export const volume = (mm3: number): number => (unit() === "inch" ? mm3 / mm_per_inch ** 3 : mm3);

/// True for the letter of an axis whose positions are degrees.
export const turns = (axis: string): boolean => /^[ABC]\d*$/.test(axis);
export const axis_unit = (axis: string): string => (turns(axis) ? "°" : length_unit());
