// Lengths and feeds as the page shows them: in the unit of the program, or in the one that is chosen. The session gives
// mm and degrees always.
import { t, write_anew } from "../texts/texts";

export type Unit = "mm" | "inch";
const mm_per_inch = 25.4;
let of_program: Unit = "mm",
  chosen: Unit | null = null,
  file = "";

export const unit = (): Unit => chosen ?? of_program;

/// The unit in which the program that has been run is written; what was chosen for another program is forgotten.
export function take_program_unit(of: string, its: Unit): void {
  const before = unit();
  if (of !== file) chosen = null;
  file = of;
  of_program = its;
  if (unit() !== before) write_anew();
}

/// For the program that is open.
export function choose_unit(wanted: Unit): void {
  const before = unit();
  chosen = wanted;
  if (unit() !== before) write_anew();
}

/// Of mm or mm/min.
export const in_unit = (mm: number): number => (unit() === "inch" ? mm / mm_per_inch : mm);
/// A thousandth of a millimetre is four places of an inch.
export const places = (): number => (unit() === "inch" ? 4 : 3);

export const length_unit = (): string => t(unit() === "inch" ? "inch" : "mm");
export const feed_unit = (): string => t(unit() === "inch" ? "inch_min" : "mm_min");
export const volume_unit = (): string => t(unit() === "inch" ? "inch3" : "mm3");
/// Of mm³.
export const volume = (mm3: number): number => (unit() === "inch" ? mm3 / mm_per_inch ** 3 : mm3);

/// An axis whose positions are degrees, by its letter.
export const turns = (axis: string): boolean => /^[ABC]\d*$/.test(axis);
export const axis_unit = (axis: string): string => (turns(axis) ? "°" : length_unit());
