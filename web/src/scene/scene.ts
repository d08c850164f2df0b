// The 3D view: path, tool, part and boxes; it draws only when something has changed.
import {
  AmbientLight,
  Box3,
  BufferAttribute,
  BufferGeometry,
  ColorManagement,
  DirectionalLight,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  Plane,
  Raycaster,
  Scene as Stage,
  Vector2,
  Vector3,
  Vector4,
} from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { Eye } from "./camera";
import { Canvas } from "./canvas";
import { dark, light, type Ranges, type Theme } from "./colours";
import { Controls } from "./controls";
import { bounded, box_lines, goes_beyond } from "./boxes";
import { axes, empty, lit_points, put_tool, tool_mesh } from "./marks";
import { distance_between } from "./measure";
import { part_material, part_mesh } from "./part_view";
import { carry_of } from "./carry";
import { PathView } from "./path_view";
import type { TurnedSection } from "./section";
import { quarter_planes, section_view } from "./turned_view";
import { pick, type Hit } from "./pick";
import type { OfPathFrame, PartFrame } from "../protocol/frames";
import type { Joint } from "../protocol/types";
import {
  type Anchor,
  type ColourBy,
  type Point,
  type SceneBounds,
  type SceneBox,
  type SceneEvents,
  type SceneFilter,
  type SceneMode,
  type SceneVertex,
  type ToolShape,
  type View,
  type ViewName,
} from "./types";

export * from "./types";

ColorManagement.enabled = false; // before the first colour is created

const most_thick = 4000; // segments: a thick line costs some ten times as much as a thin one
const still = 180; // ms without a change, after which the picture is drawn finely
const slice = 10; // ms of a picture in which lines are built; the rest is built in the next ones
const refit_every = 200; // ms between updates of the extents while a path is arriving

export class Scene {
  private canvas: Canvas;
  private stage = new Stage();
  private eye = new Eye();
  private path = new PathView();
  private boxes = new Group();
  private machine = new Group(); // limits and zones; machine coordinates
  private tool = new Group();
  private part = new Group();
  private origin = new Group();
  private way = new Group(); // that the machine will follow
  private ruler = new Group();
  private lamp = new DirectionalLight(0xffffff, 1.6);
  private lit = new LineSegments2(
    new LineSegmentsGeometry(),
    new LineMaterial({ linewidth: 2.5, depthTest: false, transparent: true }),
  );
  private lit_thin = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ depthTest: false, transparent: true }),
  );
  private theme: Theme = document.documentElement.dataset.theme === "dark" ? dark : light;
  private planes: Plane[] = [];
  private shapes: ToolShape[] = [];
  private shown_boxes: SceneBox[] = [];
  private bounds: SceneBounds | null = null;
  private reach = new Box3(); // of the machine's limits and zones as they are drawn, from the zero
  private part_shown: PartFrame | null = null;
  private turned: TurnedSection | null = null; // sections of the shown part, if it is turned
  private half = false; // a turned part is shown in half section
  private lit_line: [number, number] | null = null;
  private tool_drawn = "";
  private mode: SceneMode = "orbit";
  private ends: Anchor[] = [];
  private asked = 0;
  private pointer: [number, number] | null = null;
  private counted: [number, number] = [0, 0];
  private samples = new Mesh(new BufferGeometry(), part_material([])); // keeps the shader of a part
  private width = 1;
  private height = 1;
  private old = false; // the path is of a program that is running again
  private fine = false; // nothing has changed for a while
  private fitted_at = 0;
  private own_view = false; // the user has rotated, moved or zoomed since the last fit
  private joints: Joint[] = []; // that rotate the part
  private is_lathe = false;
  private machine_at: { at: Point; tool: number } | null = null; // of a machine that is on

  constructor(
    private host: HTMLElement,
    private events: SceneEvents,
  ) {
    this.canvas = new Canvas();
    const canvas = this.canvas.element;
    canvas.tabIndex = 0;
    host.append(canvas);
    for (const o of [this.lit, this.lit_thin]) {
      o.renderOrder = 2;
      o.frustumCulled = false;
      o.visible = false;
    }
    this.stage.add(
      this.path.group,
      this.boxes,
      this.machine,
      this.tool,
      this.part,
      this.origin,
      this.way,
      this.ruler,
      this.lit,
      this.lit_thin,
      new AmbientLight(0xffffff, 1.6),
      this.lamp,
    );
    new Controls(canvas, this.eye, {
      changed: () => {
        this.own_view = true;
        this.touch();
      },
      click: (x, y) => this.click(x, y),
      pivot: (x, y) => {
        const h = this.pick(x, y);
        return h && new Vector3(...h.place).applyMatrix4(this.eye.carry);
      },
      hover: (x, y) => {
        this.pointer = [x, y];
        this.ask();
      },
      leave: () => {
        this.pointer = null;
        this.events.hover(null, 0, 0);
      },
    });
    new ResizeObserver(() => this.resize()).observe(host);
    canvas.addEventListener("webglcontextrestored", () => this.touch());
    this.setTheme(this.theme === dark);
    this.canvas.prepare(this.stage, this.eye.camera, [
      ...this.path.samples(),
      tool_mesh(undefined, 1, this.theme),
      axes(1),
      this.samples,
    ]);
    this.resize();
  }

  /// The first piece of a new run's path replaces the old path, so that the view does not go blank.
  addPath(frame: OfPathFrame): void {
    if (this.old) this.clearPath();
    if (!this.path.add(frame)) return;
    this.touch();
    if (performance.now() - this.fitted_at > refit_every) this.refit();
  }
  clearPath(which?: number): void {
    this.old = false;
    this.path.clear(which);
    if (which === undefined) {
      this.highlight(0, 0);
      this.measure_from([]);
    }
    this.path.change();
    this.touch();
  }
  replacePath(): void {
    this.old = true;
  }
  /// Call after the last piece.
  endPath(): void {
    if (this.old) this.clearPath();
    this.path.change();
    this.draw_machine();
    this.refit();
  }

  setZero(zero: Point): void {
    this.path.set_zero(zero);
    this.draw_machine();
    this.setPart(this.part_shown);
    this.relight();
    this.setInstant(this.path.instant);
  }

  setColour(by: ColourBy): void {
    this.path.set_colour(by);
    this.touch();
  }
  setFilter(f: SceneFilter): void {
    this.path.set_filter(f);
    this.draw_machine();
    this.setInstant(this.path.instant);
  }
  setProjection(flat: boolean): void {
    this.eye.flat = flat;
    this.touch();
  }
  setMode(mode: SceneMode): void {
    this.mode = mode;
    this.measure_from([]);
  }
  setTools(shapes: ToolShape[]): void {
    this.shapes = shapes;
    this.tool_drawn = "";
    this.setInstant(this.path.instant);
  }

  setTheme(is_dark: boolean): void {
    this.theme = is_dark ? dark : light;
    this.canvas.renderer.setClearColor(this.theme.ground);
    this.path.set_theme(this.theme);
    for (const o of [this.lit, this.lit_thin])
      (o.material as LineMaterial | LineBasicMaterial).color.set(this.theme.bright);
    this.tool_drawn = "";
    this.draw_machine();
    this.setBoxes(this.shown_boxes);
    this.setPart(this.part_shown);
    this.setInstant(this.path.instant);
  }

  /// The joints that rotate the part; the path is still drawn in the part's frame.
  setJoints(joints: Joint[]): void {
    this.joints = joints;
    this.setInstant(this.path.instant);
  }

  setInstant(at: number): void {
    this.path.instant = at;
    const place = this.machine_at ? { ...this.machine_at, lean: null, positions: null } : this.path.place(at);
    this.eye.set_carry(
      this.path.turns_part && place?.positions ? carry_of(this.joints, place.positions, this.path.zero) : new Matrix4(),
    );
    this.tool.visible = Boolean(place);
    if (place) {
      this.draw_tool(place.tool);
      put_tool(this.tool, this.from_zero(place.at), place.lean);
    }
    this.touch();
  }

  /// Shows the tool at a machine's position, machine coordinates of the tip; null: at the slider's instant.
  showMachine(machine: { at: Point; tool: number } | null): void {
    if (!machine && !this.machine_at) return;
    this.machine_at = machine;
    const left = this.drawn_at + 2 * this.canvas.took - performance.now(); // half of the time is left to the page, however slow pictures are
    if (left <= 0) this.setInstant(this.path.instant);
    else
      this.follows ??= setTimeout(() => {
        this.follows = undefined;
        this.setInstant(this.path.instant);
      }, left);
  }

  /// No picture is started for that long: the effect of a key is shown first.
  hush(ms: number): void {
    this.hushed_until = performance.now() + ms;
  }

  /// Shows a path that will be executed, machine coordinates of the tip; its end is marked.
  showWay(tips: Point[]): void {
    empty(this.way);
    const at = tips.map((p) => this.from_zero(p));
    for (let i = 1; i < at.length; i++) this.way.add(thick([...at[i - 1]!, ...at[i]!], 3, this.theme.bright));
    if (at.length) this.way.add(thick([...at[at.length - 1]!, ...at[at.length - 1]!], 10, this.theme.bright));
    this.touch();
  }

  /// Position of the tool's tip at an instant, from the picture's zero; null if there is no path.
  positionAt(at: number): Point | null {
    const place = this.path.place(at);
    return place && this.from_zero(place.at);
  }

  highlight(line: number, file: number): void {
    if (line === (this.lit_line?.[0] ?? 0) && file === (this.lit_line?.[1] ?? 0)) return;
    this.lit_line = line > 0 ? [line, file] : null;
    this.relight();
  }

  /// Limits and zones of the machine, in the coordinates of the path's frames.
  setBounds(bounds: SceneBounds | null): void {
    this.bounds = bounds;
    this.draw_machine();
  }

  private draw_machine(): void {
    empty(this.machine);
    this.reach.makeEmpty();
    const z = new Vector3(...this.path.zero),
      all = this.extent(false).translate(z),
      path = this.path.extent(false).translate(z);
    const draw = (box: SceneBox): void => {
      this.machine.add(box_lines(box, this.theme));
      this.reach.union(new Box3(new Vector3(...box.box[0]), new Vector3(...box.box[1])).translate(z.clone().negate()));
    };
    if (this.path.shows_bounds && this.bounds) {
      const { limits, zones } = this.bounds;
      if (limits.some((side) => side.some((v) => v !== null)))
        draw({
          name: "",
          kind: "limits",
          box: bounded(limits, all),
          over: !this.joints.length && goes_beyond(path, limits),
        });
      for (const zone of zones) draw({ name: String(zone.number), kind: "zone", box: bounded(zone.box, all) });
    }
    this.machine.matrixAutoUpdate = false; // it stays where it is while the part rotates
    this.touch();
  }

  setBoxes(boxes: SceneBox[]): void {
    this.shown_boxes = boxes;
    empty(this.boxes);
    for (const b of boxes) this.boxes.add(box_lines(b, this.theme));
    this.refit();
  }

  setPart(part: PartFrame | null): void {
    this.part_shown = part;
    if (!part) this.turned = null;
    this.draw_part();
  }

  /// The sections of the part that was shown last; null: it is not turned.
  setTurned(turned: TurnedSection | null): void {
    this.turned = turned;
    this.draw_part();
  }

  private draw_part(): void {
    empty(this.part);
    const { part_shown: part, turned } = this,
      quarter = this.half && turned !== null;
    if (this.half) this.planes = quarter ? quarter_planes() : [];
    if (part) this.part.add(part_mesh(part, this.path.zero, this.theme, this.planes, quarter));
    if (part && turned && quarter) this.part.add(section_view(turned, this.path.zero[2], this.theme, this.planes));
    this.touch();
  }

  /// Cuts the part at `at` of an axis; `flip` removes the other side. The path stays whole.
  setSection(axis: 0 | 1 | 2 | null, at: number, flip: boolean): void {
    if (this.half) {
      this.half = false;
      this.planes = [];
      this.draw_part();
    }
    const sign = flip ? 1 : -1;
    this.planes.length = 0; // the part's material holds this same list
    if (axis !== null) this.planes.push(new Plane(new Vector3().setComponent(axis, sign), -sign * at));
    this.touch();
  }
  /// Shows a turned part in half section: cut open above the axis, from outside below it.
  setHalf(): void {
    if (this.half) return;
    this.half = true;
    this.draw_part();
  }

  view(name: ViewName | string): void {
    if (name !== "fit") this.eye.look(name);
    this.own_view = false;
    this.refit();
  }

  /// Shows a lathe's part as lathes do: the front view has X up and Z to the right.
  setLathe(on: boolean): void {
    if (on === this.is_lathe) return;
    this.is_lathe = on;
    this.eye.set_lathe(on);
    this.view(on ? "front" : "iso");
  }

  /// Shows everything from that side.
  look_from(towards: Point): void {
    this.eye.look_from(towards);
    this.view("fit");
  }

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

  private from_zero(p: Point): Point {
    const z = this.path.zero;
    return [p[0] - z[0], p[1] - z[1], p[2] - z[2]];
  }

  /// The blank often arrives after the path: the view is fitted to it too, unless the user has chosen another view.
  private refit(): void {
    this.fitted_at = performance.now();
    const box = this.extent(true);
    if (!this.own_view && !box.isEmpty()) this.eye.fit(box.min.toArray() as Point, box.max.toArray() as Point);
    this.touch();
  }

  private extent(cut: boolean): Box3 {
    const box = this.path.extent(cut);
    for (const b of this.shown_boxes) box.union(new Box3(new Vector3(...b.box[0]), new Vector3(...b.box[1])));
    for (const o of this.part.children) box.expandByObject(o);
    return box;
  }

  private draw_tool(number: number): void {
    const box = this.path.extent(true),
      cone = Math.min(20, Math.max(2, 0.08 * box.min.distanceTo(box.max))),
      wanted = `${number}:${cone}`;
    if (this.tool_drawn === wanted) return;
    this.tool_drawn = wanted;
    empty(this.tool);
    this.tool.add(
      tool_mesh(
        this.shapes.find((s) => s.number === number),
        cone,
        this.theme,
      ),
    );
    empty(this.origin);
    this.origin.add(axes(cone * 1.5));
  }

  private relight(): void {
    const points = this.lit_line ? lit_points(this.path.drawn, ...this.lit_line, this.path.zero) : new Float32Array();
    const count = points.length / 6;
    this.lit.visible = count > 0 && count <= most_thick;
    this.lit_thin.visible = count > most_thick;
    for (const o of [this.lit, this.lit_thin]) o.geometry.dispose();
    if (this.lit.visible) this.lit.geometry = new LineSegmentsGeometry().setPositions(points);
    if (this.lit_thin.visible)
      this.lit_thin.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(points, 3));
    this.touch();
  }

  private pick(x: number, y: number): Hit | null {
    return pick(this.path.drawn, this.eye, x, y, this.width, this.height, this.path.zero);
  }

  /// The point of the part's visible surface at this position.
  private surface(x: number, y: number): { place: Point; normal: Point } | null {
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * x) / this.width - 1, 1 - (2 * y) / this.height), this.eye.camera);
    const hit = ray.intersectObject(this.part, true)[0];
    if (!hit?.face) return null;
    const normal = hit.face.normal.clone();
    if (normal.dot(ray.ray.direction) > 0) normal.negate();
    return { place: hit.point.toArray() as Point, normal: normal.toArray() as Point };
  }

  private click(x: number, y: number): void {
    if (this.mode === "touch") {
      const at = this.surface(x, y);
      if (at) this.events.touched(at.place, at.normal);
      return;
    }
    const hit = this.pick(x, y);
    if (this.mode === "orbit") return this.events.pick(hit?.vertex ?? null);
    if (hit) this.measure_from(this.ends.length === 1 ? [this.ends[0]!, hit.anchor] : [hit.anchor]);
  }

  private measure_from(ends: Anchor[]): void {
    this.ends = ends;
    empty(this.ruler);
    const [a, b] = ends,
      distance = a && b ? distance_between(a, b) : null;
    for (const e of ends) this.ruler.add(thick([...e.place, ...e.place], 8, this.theme.bright));
    if (distance) this.ruler.add(thick([...distance.from, ...distance.to], 2.5, this.theme.bright));
    this.events.measured({ ends, distance });
    this.touch();
  }

  private resize(): void {
    this.width = Math.max(1, this.host.clientWidth);
    this.height = Math.max(1, this.host.clientHeight);
    this.canvas.size(this.width, this.height);
    this.eye.size(this.width, this.height);
    this.render(false);
  }

  private dirty = false;
  private rest: ReturnType<typeof setTimeout> | undefined;
  private touch(): void {
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
  private drawn_at = 0;
  private follows: ReturnType<typeof setTimeout> | undefined;
  private hushed_until = 0;
  private waits: ReturnType<typeof setTimeout> | undefined;
  private ask(): void {
    const left = this.hushed_until - performance.now();
    if (left > 0)
      this.waits ??= setTimeout(() => {
        this.waits = undefined;
        this.ask();
      }, left);
    else this.asked ||= requestAnimationFrame(() => this.frame());
  }

  private frame(): void {
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
  private render(fine: boolean, until = performance.now() + slice): void {
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

  private seen(): View {
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

function thick(points: number[], width: number, colour: number): LineSegments2 {
  const line = new LineSegments2(
    new LineSegmentsGeometry().setPositions(points),
    new LineMaterial({ linewidth: width, depthTest: false, color: colour }),
  );
  line.renderOrder = 3;
  return line;
}
