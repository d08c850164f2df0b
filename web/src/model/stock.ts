// Reads the blank as `--stock` writes it: box:X0,Y0,Z0,X1,Y1,Z1; anything else stays as it is.
import type { Box } from "../protocol/types";

export function box_of(stock: string): Box | null {
  const m = /^box:(.*)$/.exec(stock.trim());
  const n = m?.[1]!.split(",").map(Number);
  if (!n || n.length !== 6 || n.some((v) => !Number.isFinite(v))) return null;
  return [n.slice(0, 3), n.slice(3)];
}

export const stock_of = (box: Box): string => `box:${[...box[0], ...box[1]].join(",")}`;
export const proper = (box: Box): boolean => box[0].every((v, i) => v < box[1][i]!);
