// Reads the blank as `--stock` writes it: box:X0,Y0,Z0,X1,Y1,Z1 or cylinder:0,0,Z0,Z1,D,BORE; anything else stays as it is.
import type { Box } from "../protocol/types";

export function box_of(stock: string): Box | null {
  const m = /^box:(.*)$/.exec(stock.trim());
  const n = m?.[1]!.split(",").map(Number);
  if (!n || n.length !== 6 || n.some((v) => !Number.isFinite(v))) return null;
  return [n.slice(0, 3), n.slice(3)];
}

export const stock_of = (box: Box): string => `box:${[...box[0], ...box[1]].join(",")}`;
export const proper = (box: Box): boolean => box[0].every((v, i) => v < box[1][i]!);

/// A bar or a tube about the axis Z, mm.
export interface Cylinder {
  from: number;
  to: number;
  diameter: number;
  bore: number;
}
export function cylinder_of(stock: string): Cylinder | null {
  const m = /^cylinder:(.*)$/.exec(stock.trim());
  const n = m?.[1]!.split(",").map(Number);
  if (!n || (n.length !== 5 && n.length !== 6) || n.some((v) => !Number.isFinite(v)) || n[0] !== 0 || n[1] !== 0)
    return null;
  return { from: n[2]!, to: n[3]!, diameter: n[4]!, bore: n[5] ?? 0 };
}
export const stock_of_cylinder = (c: Cylinder): string =>
  `cylinder:0,0,${c.from},${c.to},${c.diameter}${c.bore ? `,${c.bore}` : ""}`;

/// Returns the box around the blank; null if the text does not tell it.
export function extent_of(stock: string): Box | null {
  const c = cylinder_of(stock),
    r = c ? c.diameter / 2 : 0;
  return c
    ? [
        [-r, -r, c.from],
        [r, r, c.to],
      ]
    : box_of(stock);
}
