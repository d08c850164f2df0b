// Small drawings of what the fields of a block mean.
import { svg } from "../ui/dom";
import type { BlocksKind } from "./blocks_form";

const line = (points: string, kind = "cut"): SVGElement => svg("polyline", { points, class: `sketch-${kind}` });
const dot = (x: number, y: number): SVGElement => svg("circle", { cx: x, cy: y, r: 3, class: "sketch-dot" });
const word = (x: number, y: number, text: string): SVGElement => svg("text", { x, y, class: "sketch-text" }, text);

/// 220 by 90 units.
export function sketch(kind: BlocksKind): SVGElement {
  const parts: Record<BlocksKind, SVGElement[]> = {
    cycle: [
      line("10,58 90,58 90,80 130,80 130,58 210,58"),
      line("110,12 110,38", "rapid"),
      line("110,38 110,80", "feed"),
      word(118, 20, "XY"),
      line("70,38 150,38", "level"),
      word(154, 42, "R"),
      word(116, 78, "Z"),
    ],
    arc: [
      svg("path", { d: "M 40 75 A 75 75 0 0 1 180 75", class: "sketch-feed" }),
      dot(40, 75),
      dot(110, 23),
      dot(180, 75),
      word(20, 80, "1"),
      word(106, 16, "2"),
      word(188, 80, "3"),
    ],
    corner: [
      line("40,80 40,15 180,15", "level"),
      svg("path", { d: "M 40 80 V 45 A 30 30 0 0 1 70 15 H 180", class: "sketch-feed" }),
      dot(40, 80),
      dot(40, 15),
      dot(180, 15),
      word(20, 84, "1"),
      word(22, 14, "2"),
      word(188, 19, "3"),
    ],
  };
  return svg("svg", { viewBox: "0 0 220 90", class: "sketch", "aria-hidden": "true" }, ...parts[kind]);
}
