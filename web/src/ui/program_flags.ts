// What the view shows over the path: the marks of a program that has been run, and its sizes at the edges.
import type { App } from "../model/app";
import { diameter_sign, is_diameter, no_diameters, widest, type Diameters } from "../model/diameters";
import { figure_places } from "../scene/boxes";
import type { Scene } from "../scene/scene";
import type { Point, View } from "../scene/types";
import { length_told } from "./figures";
import { Flags, flags_of } from "./flags";

export const diameters_of = (app: App): Diameters => app.done?.diameters ?? no_diameters;
/// X, Y, Z of the program; a lathe may have no Y.
export const axes_of = (app: App): string[] =>
  ["X", "Y", "Z"].filter((a) => !app.done?.axes?.length || app.done.axes.includes(a));

export class ProgramFlags {
  private flags: Flags;
  private box: [Point, Point] | null = null; // extents, whose figures are at its edges

  private drawn = ""; // the figures

  constructor(private app: App) {
    this.flags = new Flags((time) => app.seek(time));
  }
  get element(): HTMLElement {
    return this.flags.element;
  }

  /// Places the marks of the program that has been run.
  mark(scene: Scene | null): void {
    const { app } = this,
      box = app.done?.extents.cutting;
    this.box = box ? (box as [Point, Point]) : null;
    this.flags.set(
      "marks",
      scene && app.done ? flags_of(app.marks, app.done.seconds, (at) => scene.positionAt(at)) : [],
    );
    if (box) return;
    this.flags.set("figures", []);
    this.drawn = "";
  }

  /// Follows the view, in a pane of that size in px.
  place(view: View, width: number, height: number): void {
    const { box } = this,
      axes = axes_of(this.app);
    if (box) {
      const figures = figure_places(box, (p) => view.place(p)?.[1] ?? -Infinity)
          .map((at, k) => ({ kind: "figure" as const, at, text: this.told(box, k) }))
          .filter((_, k) => axes.includes("XYZ"[k]!)),
        drawn = JSON.stringify(figures);
      if (drawn !== this.drawn) this.flags.set("figures", figures);
      this.drawn = drawn;
    }
    this.flags.place(view, width, height);
  }

  /// Along an axis in diameter programming the greatest diameter, else the size.
  private told(box: [Point, Point], k: number): string {
    const is_wide = is_diameter("XYZ"[k]!, diameters_of(this.app));
    return is_wide
      ? `${diameter_sign} ${length_told(widest(box[0][k]!, box[1][k]!))}`
      : length_told(box[1][k]! - box[0][k]!);
  }
}
