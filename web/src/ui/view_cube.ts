// The cube in the corner of the view: it rotates with the view; a click on a face or a corner looks from there.
import type { Point, View, ViewName } from "../scene/types";
import { on_language, t, type TextKey } from "../texts/texts";
import { fill, svg } from "./dom";

interface Face {
  view: ViewName;
  normal: Point;
  right: Point;
  up: Point;
}
const faces: Face[] = [
  { view: "top", normal: [0, 0, 1], right: [1, 0, 0], up: [0, 1, 0] },
  { view: "bottom", normal: [0, 0, -1], right: [1, 0, 0], up: [0, -1, 0] },
  { view: "front", normal: [0, -1, 0], right: [1, 0, 0], up: [0, 0, 1] },
  { view: "back", normal: [0, 1, 0], right: [-1, 0, 0], up: [0, 0, 1] },
  { view: "right", normal: [1, 0, 0], right: [0, 1, 0], up: [0, 0, 1] },
  { view: "left", normal: [-1, 0, 0], right: [0, -1, 0], up: [0, 0, 1] },
];
const half = 27,
  middle = 48,
  edge_on = 0.05; // of a picture 96 wide
const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const sum = (a: Point, b: Point, c: Point, k: number, l: number): Point => [
  a[0] + k * b[0] + l * c[0],
  a[1] + k * b[1] + l * c[1],
  a[2] + k * b[2] + l * c[2],
];

export class ViewCube {
  readonly element = svg("svg", { class: "view-cube", viewBox: "0 0 96 96", role: "group" });
  private last: View | null = null;
  private drawn = "";

  constructor(
    private look: (view: ViewName) => void,
    private look_from: (towards: Point) => void,
  ) {
    on_language(() => {
      this.drawn = "";
      if (this.last) this.turn(this.last);
    });
  }

  turn(view: View): void {
    this.last = view;
    const key = [...view.right, ...view.up].map((v) => v.toFixed(3)).join();
    if (key === this.drawn) return;
    this.drawn = key;
    const shown = faces.map((f) => ({
      view: f.view,
      normal: view.turned(f.normal),
      right: view.turned(f.right),
      up: view.turned(f.up),
    }));
    const at = (p: Point): string =>
      `${(middle + half * dot(p, view.right)).toFixed(2)},${(middle - half * dot(p, view.up)).toFixed(2)}`;
    fill(
      this.element,
      ...axes(view),
      ...shown.filter((f) => dot(f.normal, view.towards) > edge_on).map((f) => this.face(f, view, at)),
      ...this.corners(view),
    );
    this.element.setAttribute("aria-label", t("views"));
  }

  private face(f: Face, view: View, at: (p: Point) => string): SVGElement {
    const corners = [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ]
      .map(([k, l]) => at(sum(f.normal, f.right, f.up, k!, l!)))
      .join(" ");
    const [a, b, c, d] = [dot(f.right, view.right), -dot(f.right, view.up), -dot(f.up, view.right), dot(f.up, view.up)];
    const name = t(`view_${f.view}`),
      size = Math.min(15, (2 * half - 6) / (0.72 * name.length)); // so that the longest word stays on its face
    return svg(
      "g",
      {
        class: "cube-face",
        onclick: () => this.look(f.view),
        role: "button",
        "aria-label": t(`view_${f.view}_long` as TextKey),
      },
      svg("title", null, t(`view_${f.view}_long` as TextKey)),
      svg("polygon", { points: corners }),
      svg(
        "text",
        {
          transform: `matrix(${[a, b, c, d].map((v) => v.toFixed(4)).join()},${at(f.normal)})`,
          "font-size": size.toFixed(1),
          "text-anchor": "middle",
          dy: "0.35em",
        },
        name,
      ),
    );
  }

  private corners(view: View): SVGElement[] {
    const out: SVGElement[] = [];
    for (const x of [-1, 1])
      for (const y of [-1, 1])
        for (const z of [-1, 1]) {
          const p: Point = [x, y, z];
          if (faces.filter((f) => dot(f.normal, p) > 0).some((f) => dot(f.normal, view.towards) > edge_on))
            out.push(
              svg(
                "circle",
                {
                  class: "cube-corner",
                  cx: middle + half * dot(p, view.right),
                  cy: middle - half * dot(p, view.up),
                  r: 5.5,
                  onclick: () => this.look_from(p),
                  role: "button",
                  "aria-label": t("view_iso_long"),
                },
                svg("title", null, t("view_iso_long")),
              ),
            );
        }
    return out;
  }
}

/// The axes from the cube's lower corner: X red, Y green, Z blue, as usual.
function axes(view: View): SVGElement[] {
  const reach = 1.62;
  return (["X", "Y", "Z"] as const).map((name, k) => {
    const end: Point = [-1, -1, -1];
    end[k] = reach;
    const from = `${middle - half * dot([1, 1, 1], view.right)}`,
      y = `${middle + half * dot([1, 1, 1], view.up)}`;
    const x2 = middle + half * dot(end, view.right),
      y2 = middle - half * dot(end, view.up);
    return svg(
      "g",
      { class: `cube-axis axis-${name}` },
      svg("line", { x1: from, y1: y, x2, y2 }),
      svg("text", { x: x2, y: y2, dy: "0.35em", "text-anchor": "middle" }, name),
    );
  });
}
