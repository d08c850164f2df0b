// Draws a tool: its outlines mirrored about the axis, as SVG built element by element.
import type { Outline, Shape } from "../model/tool_shape";
import { svg } from "./dom";

export function tool_picture(shape: Shape, name: string, width = 60, height = 120): SVGSVGElement {
  const parts: [string, Outline][] = [
    ["holder", shape.holder],
    ["shank", shape.shank],
    ["cutting", shape.cutting],
  ];
  const all = parts.flatMap(([, o]) => o);
  const wide = Math.max(1, ...all.map(([d]) => d)),
    high = Math.max(1, ...all.map(([, z]) => z));
  const scale = Math.min((width - 4) / wide, (height - 4) / high);
  const at = (d: number, z: number): string =>
    `${(width / 2 + (d / 2) * scale).toFixed(2)},${(height - 2 - z * scale).toFixed(2)}`;
  const e = svg("svg", {
    viewBox: `0 0 ${width} ${height}`,
    width,
    height,
    role: "img",
    "aria-label": name,
    class: "tool-picture",
  });
  for (const [part, o] of parts) {
    if (o.length < 2) continue;
    const points = [...o.map(([d, z]) => at(d, z)), ...[...o].reverse().map(([d, z]) => at(-d, z))];
    e.append(svg("polygon", { points: points.join(" "), class: `tool-${part}` }));
  }
  e.append(svg("line", { x1: width / 2, x2: width / 2, y1: 0, y2: height, class: "tool-axis" }));
  return e;
}
