// Formats of figures: the same everywhere on the page.
import { axis_name, factor, no_diameters, type Diameters } from "../model/diameters";
import { in_unit, length_unit, places, turns, unit, volume, volume_unit } from "../model/units";

export function coordinate(v: number | undefined | null): string {
  if (v === undefined || v === null || !Number.isFinite(v)) return "–";
  const s = v.toFixed(3);
  return s === "-0.000" ? "0.000" : s;
}

/// Formats mm in the shown unit, without its name.
export function length(mm: number | undefined | null): string {
  if (mm === undefined || mm === null || !Number.isFinite(mm)) return "–";
  const s = in_unit(mm).toFixed(places());
  return Number(s) === 0 ? s.replace("-", "") : s;
}
/// The same with its name.
export const length_told = (mm: number | undefined | null): string => `${length(mm)} ${length_unit()}`;

/// Formats a position: degrees of a rotary axis stay as they are, an axis of `of` is shown as a diameter.
export const axis_value = (axis: string, v: number | undefined | null, of: Diameters = no_diameters): string =>
  turns(axis) ? coordinate(v) : length(typeof v === "number" ? factor(axis, of) * v : v);

/// Formats a point of the view: its axes by their names, with the sign of a diameter.
export const point_told = (
  p: readonly number[],
  of: Diameters,
  axes: readonly string[] = ["X", "Y", "Z"],
  sign = "",
): string => axes.map((a) => `${sign}${axis_name(a, of)} ${axis_value(a, p["XYZ".indexOf(a)], of)}`).join("  ");

/// Formats mm/min, without the unit's name.
export function feed(mm_min: number | undefined | null, digits = 0): string {
  if (mm_min === undefined || mm_min === null) return "–";
  return short(in_unit(mm_min), digits + (unit() === "inch" ? 1 : 0));
}

/// Formats m/min of a surface speed, as feet per minute where inches are shown.
export const surface_figure = (m_min: number): string => short(unit() === "inch" ? m_min / m_per_foot : m_min, 1);
const m_per_foot = 0.3048;

/// Formats mm³.
export const volume_figure = (mm3: number | undefined | null): string =>
  mm3 === undefined || mm3 === null ? "–" : short(volume(mm3), unit() === "inch" ? 4 : 1);
export const volume_told = (mm3: number | undefined | null): string => `${volume_figure(mm3)} ${volume_unit()}`;

export function short(v: number | undefined | null, digits = 0): string {
  if (v === undefined || v === null || !Number.isFinite(v)) return "–";
  return grouped(Number(v.toFixed(digits)));
}

/// Writes 12345.5 as 12 345.5 with narrow spaces, as both languages do.
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
