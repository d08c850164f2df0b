// Ways to the zero of the part and of the machine, as motions by hand.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import type { Axes, WayPoint } from "../protocol/types";

const rapid = (to: Axes): WayPoint => ({ rapid: true, feed: 0, to });

/// Moves along work coordinates, one motion after the other.
export async function lead(operator: Operator, way: Axes[]): Promise<void> {
  const p = operator.panel;
  if (!p) return;
  const on_machine = ([axis, v]: [string, number]): [string, number] => [
    axis,
    v + (p.machine[axis] ?? 0) - (p.position[axis] ?? 0),
  ];
  await operator.ask("lead", {
    way: way.map((to) => rapid(Object.fromEntries(Object.entries(to).map(on_machine)))),
  });
}

/// Up over everything on the path first, if there is a Z, then the other axes to 0 of the work offset.
export async function go_to_zero(operator: Operator, app: App): Promise<void> {
  const p = operator.panel,
    top = app.opened?.file === operator.name ? app.done?.extents.all?.[1][2] : undefined,
    zero = app.done?.zero[2] ?? 0,
    others = Object.fromEntries(operator.axes.filter((a) => a !== "Z").map((a) => [a, 0]));
  if (!p) return;
  const shift = (p.machine["Z"] ?? 0) - (p.position["Z"] ?? 0),
    over = Math.max(p.position["Z"] ?? 0, top === undefined ? 0 : top + zero - shift);
  await lead(operator, "Z" in p.position ? [{ Z: over }, others] : [others]);
}

/// To 0 of the machine's coordinates: Z first.
export async function go_home(operator: Operator): Promise<void> {
  const { axes } = operator,
    zero = (of: string[]): WayPoint => rapid(Object.fromEntries(of.map((a) => [a, 0]))),
    way = axes.includes("Z") ? [zero(["Z"]), zero(axes.filter((a) => a !== "Z"))] : [zero(axes)];
  await operator.ask("lead", { way: way.filter((w) => Object.keys(w.to).length) });
}
