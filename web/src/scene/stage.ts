// The stage of the 3D view: its groups, the eye, and when a picture is drawn: only when something has changed.
import {
  Box3,
  BufferGeometry,
  ColorManagement,
  DirectionalLight,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  Plane,
  Scene as Stage,
  Vector3,
  Vector4,
} from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { Eye } from "./camera";
import { Canvas } from "./canvas";
import { dark, light, type Ranges, type Theme } from "./colours";
import { part_material } from "./part_view";
import { PathView } from "./path_view";
import type { TurnedSection } from "./section";
import type { Hit } from "./pick";
import type { PartFrame } from "../protocol/frames";
import type { Joint } from "../protocol/types";
import {
  type Anchor,
  type Point,
  type SceneBounds,
  type SceneBox,
  type SceneEvents,
  type SceneMode,
  type SceneVertex,
  type ToolShape,
  type View,
} from "./types";

ColorManagement.enabled = false; // before the first colour is created

const still = 180; // ms without a change, after which the picture is drawn finely
const slice = 10; // ms of a picture in which lines are built; the rest is built in the next ones

export abstract class SceneStage {
  protected canvas: Canvas;
  protected stage = new Stage();
  protected eye = new Eye();
  protected path = new PathView();
  protected boxes = new Group();
  protected machine = new Group(); // limits and zones; machine coordinates
  protected tool = new Group();
  protected part = new Group();
  protected origin = new Group();
  protected way = new Group(); // that the machine will follow
  protected ruler = new Group();
  protected lamp = new DirectionalLight(0xffffff, 1.6);
  protected lit = new LineSegments2(
    new LineSegmentsGeometry(),
    new LineMaterial({ linewidth: 2.5, depthTest: false, transparent: true }),
  );
  protected lit_thin = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ depthTest: false, transparent: true }),
  );
  protected theme: Theme = document.documentElement.dataset.theme === "dark" ? dark : light;
  protected planes: Plane[] = [];
  protected shapes: ToolShape[] = [];
  protected shown_boxes: SceneBox[] = [];
  protected bounds: SceneBounds | null = null;
  protected reach = new Box3(); // of the machine's limits and zones as they are drawn, from the zero
  protected part_shown: PartFrame | null = null;
  protected turned: TurnedSection | null = null; // sections of the shown part, if it is turned
  protected half = false; // a turned part is shown in half section
  protected lit_line: [number, number] | null = null;
  protected tool_drawn = "";
  protected mode: SceneMode = "orbit";
  protected ends: Anchor[] = [];
  protected asked = 0;
  protected pointer: [number, number] | null = null;
  protected counted: [number, number] = [0, 0];
  protected samples = new Mesh(new BufferGeometry(), part_material([])); // keeps the shader of a part
  protected width = 1;
  protected height = 1;
  protected old = false; // the path is of a program that is running again
  protected fine = false; // nothing has changed for a while
  protected fitted_at = 0;
  protected own_view = false; // the user has rotated, moved or zoomed since the last fit
  protected joints: Joint[] = []; // that rotate the part
  protected is_lathe = false;
  protected machine_at: { at: Point; tool: number } | null = null; // of a machine that is on

  constructor(
    private host: HTMLElement,
    protected events: SceneEvents,
  ) {
    this.canvas = new Canvas();
  }

  protected abstract pick(x: number, y: number): Hit | null;

  /// The ranges of the colour ramps; depth from the picture's zero.
  ranges(): Ranges {
    const { ranges: r, zero } = this.path;
    return { ...r, depth: [r.depth[0] - zero[2], r.depth[1] - zero[2]] };
  }
  /// Kinds of motion that the path has.
  kinds(): number[] {
    return [...this.path.kinds].sort((a, b) => a - b);
  }

  redraw(): void {
    this.touch();
  }
  thinned(): { drawn: number; all: number } {
    return { drawn: this.counted[0], all: this.counted[1] };
  }

  picture(): Promise<Blob> {
    this.render(true, Infinity); // whole; the canvas keeps its picture only until this task ends
    return new Promise((yes, no) =>
      this.canvas.element.toBlob((b) => (b ? yes(b) : no(new Error("no picture"))), "image/png"),
    );
  }

  protected from_zero(p: Point): Point {
    const z = this.path.zero;
    return [p[0] - z[0], p[1] - z[1], p[2] - z[2]];
  }

  /// The blank often arrives after the path: the view is fitted to it too, unless the user has chosen another view.
  protected refit(): void {
    this.fitted_at = performance.now();
    const box = this.extent(true);
    if (!this.own_view && !box.isEmpty()) this.eye.fit(box.min.toArray() as Point, box.max.toArray() as Point);
    this.touch();
  }

  protected extent(cut: boolean): Box3 {
    const box = this.path.extent(cut);
    for (const b of this.shown_boxes) box.union(new Box3(new Vector3(...b.box[0]), new Vector3(...b.box[1])));
    for (const o of this.part.children) box.expandByObject(o);
    return box;
  }

  protected resize(): void {
    this.width = Math.max(1, this.host.clientWidth);
    this.height = Math.max(1, this.host.clientHeight);
    this.canvas.size(this.width, this.height);
    this.eye.size(this.width, this.height);
    this.refit(); // unless the user has chosen another view
    this.render(false);
  }

  protected dirty = false;
  protected rest: ReturnType<typeof setTimeout> | undefined;
  protected touch(): void {
    this.dirty = true;
    this.ask();
    clearTimeout(this.rest);
    this.rest = setTimeout(
      () => {
        this.fine = true;
        this.dirty = true;
        this.ask();
      },
      still + 5 * this.canvas.took,
    ); // a key may be pressed as soon as the picture is complete
    this.fine = false;
  }
  protected drawn_at = 0;
  protected follows: ReturnType<typeof setTimeout> | undefined;
  protected hushed_until = 0;
  protected waits: ReturnType<typeof setTimeout> | undefined;
  protected ask(): void {
    const left = this.hushed_until - performance.now();
    if (left > 0)
      this.waits ??= setTimeout(() => {
        this.waits = undefined;
        this.ask();
      }, left);
    else this.asked ||= requestAnimationFrame(() => this.frame());
  }

  protected frame(): void {
    this.asked = 0;
    if (performance.now() < this.hushed_until) return this.ask();
    if (this.dirty) this.render(this.fine);
    if (!this.pointer) return;
    const [x, y] = this.pointer,
      v: SceneVertex | null = this.pick(x, y)?.vertex ?? null;
    this.pointer = null;
    this.events.hover(v, x, y);
  }

  /// `until`: lines are built until this time in ms of performance.now(), the rest in the next pictures.
  protected render(fine: boolean, until = performance.now() + slice): void {
    this.dirty = false;
    const all = this.extent(false);
    if (this.tool.visible) all.expandByPoint(this.tool.position).expandByScalar(150); // room for the holder above the path
    if (!all.isEmpty()) this.eye.around(all.min.toArray() as Point, all.max.toArray() as Point, this.reach);
    this.eye.update();
    this.lamp.position
      .copy(this.eye.towards)
      .addScaledVector(this.eye.right, 0.4)
      .addScaledVector(this.eye.up, 0.6)
      .transformDirection(this.eye.carry_back); // over the viewer's shoulder
    this.machine.matrix.makeTranslation(new Vector3(...this.path.zero).negate()).premultiply(this.eye.carry_back);
    this.machine.matrixWorldNeedsUpdate = true;
    const {
      drawn,
      all: count,
      finished,
      cost,
    } = this.path.refresh(this.eye, this.canvas.budget(fine), this.canvas.pixels, until);
    if (!finished) {
      this.dirty = true;
      this.ask();
      if (fine) return;
    } // the old lines are shown until all of the finer lines exist
    this.drawn_at = performance.now();
    this.canvas.draw(this.stage, this.eye.camera, fine && finished, cost);
    this.events.turned(this.seen());
    if (drawn === this.counted[0] && count === this.counted[1]) return;
    this.counted = [drawn, count];
    this.events.thinned(drawn, count);
  }

  protected seen(): View {
    const { camera } = this.eye,
      m = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse),
      p = new Vector4();
    const place = ([x, y, z]: Point): [number, number] | null => {
      p.set(x, y, z, 1).applyMatrix4(m);
      return p.w > 0 ? [(p.x / p.w + 1) * 0.5 * this.width, (1 - p.y / p.w) * 0.5 * this.height] : null;
    };
    const axis = (v: Vector3): Point => v.toArray() as Point;
    return {
      right: axis(this.eye.right),
      up: axis(this.eye.up),
      towards: axis(this.eye.towards),
      turned: (p: Point) => axis(new Vector3(...p).applyQuaternion(this.eye.turned)),
      place,
    };
  }
}
