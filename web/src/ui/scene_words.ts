// What is under the mouse in the view, and what was measured, in words.
import { type Diameters } from "../model/diameters";
import { feed_unit, length_unit } from "../model/units";
import { spline } from "../protocol/frames";
import type { Measured, Point, SceneVertex } from "../scene/scene";
import { t, type TextKey } from "../texts/texts";
import { coordinate, feed, length, length_told, point_told } from "./figures";

/// `how`: what to do while nothing is measured; `axes`: those that the program has.
export function measured_told({ ends, distance }: Measured, how: string, diameters: Diameters, axes: string[]): string {
  const [a, b] = ends;
  if (!a) return how;
  const named = (e: typeof a): string =>
    `${t(`anchor_${e.kind}`)}${e.radius ? ` R ${length(e.radius)}` : ""} (${t("line_n", { line: e.line })})`;
  const at = (p: Point): string => `${point_told(p, diameters, axes)} ${length_unit()}`;
  if (!b || !distance) return `${named(a)}: ${at(a.place)}\n${t("measure_next")}`;
  const d = distance.delta.map(Math.abs) as Point;
  const parts = `${point_told(d, diameters, axes, "Δ")} ${length_unit()}`;
  const angle = distance.angle === null ? "" : `   ∠ ${coordinate(distance.angle)}°`;
  return `${named(a)} – ${named(b)}\n${t("distance")} ${length_told(distance.distance)}   ${parts}${angle}`;
}

/// Line, kind, size, place and feed of a motion.
export function motion_told(v: SceneVertex, diameters: Diameters, axes: string[]): string {
  const kind = t(`motion_${Math.min(spline, v.kind)}` as TextKey);
  const radius = v.radius ? ` · R ${length(v.radius)}` : "",
    long = v.length ? ` · L ${length(v.length)}` : "";
  return [
    `${t("line_n", { line: v.line })} · ${kind}${radius}${long} · T${v.tool}`,
    `${point_told(v.at, diameters, axes)} ${length_unit()}`,
    `${v.feed ? `F ${feed(v.feed, 1)} · ` : ""}V ${feed(v.speed)} ${feed_unit()}`,
  ].join("\n");
}
