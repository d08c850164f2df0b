// Draws a tool: its outlines mirrored about the axis, as SVG built element by element.
import type { Outline, Shape } from "../model/tool_shape";
import type { Insert } from "../protocol/types";
import { svg } from "./dom";

export function tool_picture(shape: Shape, name: string, width = 60, height = 120): SVGSVGElement {
  if (shape.inserts?.length) return insert_picture(shape.inserts, name, width, height);
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

/// An insert as it stands on the lathe: X up, Z to the right; the programmed point is marked.
function insert_picture(inserts: readonly Insert[], name: string, width: number, height: number): SVGSVGElement {
  const all = inserts.filter((i) => i.part !== "holder").flatMap((i) => i.outline),
    least = [Math.min(0, ...all.map(([x]) => x)), Math.min(0, ...all.map(([, z]) => z))] as const,
    most = [Math.max(0, ...all.map(([x]) => x)), Math.max(0, ...all.map(([, z]) => z))] as const;
  const scale = Math.min((width - 6) / Math.max(1, most[1] - least[1]), (height - 6) / Math.max(1, most[0] - least[0]));
  const at = (x: number, z: number): [number, number] => [
    3 + (z - least[1]) * scale,
    height - 3 - (x - least[0]) * scale,
  ];
  const e = svg("svg", {
    viewBox: `0 0 ${width} ${height}`,
    width,
    height,
    role: "img",
    "aria-label": name,
    class: "tool-picture",
  });
  for (const part of ["holder", "shank", "cutting"] as const)
    for (const i of inserts)
      if (i.part === part)
        e.append(
          svg("polygon", {
            points: i.outline
              .map(([x, z]) =>
                at(x, z)
                  .map((v) => v.toFixed(2))
                  .join(),
              )
              .join(" "),
            class: `tool-${part}`,
          }),
        );
  const [cx, cy] = at(0, 0);
  e.append(svg("circle", { cx, cy, r: 2, class: "tool-point" }));
  return e;
}
