// The 3D view: path, tool, part and boxes; it draws only when something has changed.
import { AmbientLight, Box3, BufferAttribute, BufferGeometry, ColorManagement, DirectionalLight, Group, LinearSRGBColorSpace, LineBasicMaterial, LineSegments, Plane, Scene as Stage, Vector3, WebGLRenderer } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { Eye } from "./camera";
import { dark, light, type Theme } from "./colours";
import { Controls } from "./controls";
import { axes, box_lines, empty, lit_points, put_tool, tool_mesh } from "./marks";
import { part_mesh } from "./part_view";
import { PathView } from "./path_view";
import { pick, type Hit } from "./pick";
import { NoWebGl, type ColourBy, type Point, type SceneBox, type SceneEvents, type SceneFilter, type SceneVertex, type ToolShape, type ViewName } from "./types";

export * from "./types";

ColorManagement.enabled = false; // before the first colour is made

const most_thick = 4000; // segments: a thick line costs some ten times as much as a thin one

export class Scene {
  private renderer: WebGLRenderer;
  private stage = new Stage();
  private eye = new Eye();
  private path = new PathView();
  private boxes = new Group();
  private tool = new Group();
  private part = new Group();
  private origin = new Group();
  private ruler = new Group();
  private lamp = new DirectionalLight(0xffffff, 1.6);
  private lit = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({ linewidth: 2.5, depthTest: false, transparent: true }));
  private lit_thin = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ depthTest: false, transparent: true }));
  private theme: Theme = document.documentElement.dataset.theme === "dark" ? dark : light;
  private planes: Plane[] = [];
  private shapes: ToolShape[] = [];
  private shown_boxes: SceneBox[] = [];
  private part_frame: ArrayBuffer | null = null;
  private lit_line: [number, number] | null = null;
  private tool_drawn = "";
  private mode: "orbit" | "measure" = "orbit";
  private ends: Point[] = [];
  private asked = 0;
  private pointer: [number, number] | null = null;
  private counted: [number, number] = [0, 0];
  private width = 1;
  private height = 1;
  private own_view = false;          // the user has turned, moved or zoomed since the last fit

  constructor(private host: HTMLElement, private events: SceneEvents) {
    this.renderer = make_renderer();
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    host.append(canvas);
    for (const o of [this.lit, this.lit_thin]) { o.renderOrder = 2; o.frustumCulled = false; o.visible = false; }
    this.stage.add(this.path.group, this.boxes, this.tool, this.part, this.origin, this.ruler, this.lit, this.lit_thin, new AmbientLight(0xffffff, 1.6), this.lamp);
    new Controls(canvas, this.eye, {
      changed: () => { this.own_view = true; this.touch(); }, click: (x, y) => this.click(x, y), pivot: (x, y) => { const h = this.pick(x, y); return h && new Vector3(...h.place); },
      hover: (x, y) => { this.pointer = [x, y]; this.ask(); }, leave: () => { this.pointer = null; this.events.hover(null, 0, 0); },
    });
    new ResizeObserver(() => this.resize()).observe(host);
    canvas.addEventListener("webglcontextrestored", () => this.touch());
    this.setTheme(this.theme === dark);
    this.resize();
  }

  addPath(frame: ArrayBuffer): void { if (this.path.add(frame)) this.touch(); }
  clearPath(which?: number): void { this.path.clear(which); if (which === undefined) { this.highlight(0, 0); this.measure_from([]); } this.path.change(); this.touch(); }

  setZero(zero: Point): void {
    this.path.set_zero(zero);
    this.setPart(this.part_frame);
    this.relight();
    this.setInstant(this.path.instant);
  }

  setColour(by: ColourBy): void { this.path.set_colour(by); this.touch(); }
  setFilter(f: SceneFilter): void { this.path.set_filter(f); this.touch(); }
  setProjection(flat: boolean): void { this.eye.flat = flat; this.touch(); }
  setMode(mode: "orbit" | "measure"): void { this.mode = mode; this.measure_from([]); }
  setTools(shapes: ToolShape[]): void { this.shapes = shapes; this.tool_drawn = ""; this.setInstant(this.path.instant); }

  setTheme(is_dark: boolean): void {
    this.theme = is_dark ? dark : light;
    this.renderer.setClearColor(this.theme.ground);
    this.path.set_theme(this.theme);
    for (const o of [this.lit, this.lit_thin]) (o.material as LineMaterial | LineBasicMaterial).color.set(this.theme.bright);
    this.tool_drawn = "";
    this.setBoxes(this.shown_boxes);
    this.setPart(this.part_frame);
    this.setInstant(this.path.instant);
  }

  setInstant(at: number): void {
    this.path.instant = at;
    const place = this.path.place(at);
    this.tool.visible = Boolean(place);
    if (place) {
      this.draw_tool(place.tool);
      put_tool(this.tool, this.from_zero(place.at), place.lean);
    }
    this.touch();
  }

  /// Where the tool's tip is at an instant, from the picture's zero; null where there is no path.
  positionAt(at: number): Point | null {
    const place = this.path.place(at);
    return place && this.from_zero(place.at);
  }

  highlight(line: number, file: number): void {
    if (line === (this.lit_line?.[0] ?? 0) && file === (this.lit_line?.[1] ?? 0)) return;
    this.lit_line = line > 0 ? [line, file] : null;
    this.relight();
  }

  setBoxes(boxes: SceneBox[]): void {
    this.shown_boxes = boxes;
    empty(this.boxes);
    for (const b of boxes) this.boxes.add(box_lines(b, this.theme));
    this.refit();
  }

  setPart(frame: ArrayBuffer | null): void {
    this.part_frame = frame;
    empty(this.part);
    const mesh = frame && part_mesh(frame, this.path.zero, this.theme, this.planes);
    if (mesh) this.part.add(mesh);
    this.touch();
  }

  /// Cuts the part at `at` of an axis; `flip` takes away the other side. The path stays whole.
  setSection(axis: 0 | 1 | 2 | null, at: number, flip: boolean): void {
    const sign = flip ? 1 : -1;
    this.planes.length = 0; // the part's material holds this very list
    if (axis !== null) this.planes.push(new Plane(new Vector3().setComponent(axis, sign), -sign * at));
    this.touch();
  }

  view(name: ViewName | string): void {
    if (name !== "fit") this.eye.look(name);
    this.own_view = false;
    this.refit();
  }

  thinned(): { drawn: number; all: number } { return { drawn: this.counted[0], all: this.counted[1] }; }

  picture(): Promise<Blob> {
    this.render(); // the canvas keeps its picture only until this task ends
    return new Promise((yes, no) => this.renderer.domElement.toBlob((b) => (b ? yes(b) : no(new Error("no picture"))), "image/png"));
  }

  private from_zero(p: Point): Point { const z = this.path.zero; return [p[0] - z[0], p[1] - z[1], p[2] - z[2]]; }

  /// The blank often comes after the path: it is brought into the picture too, unless the user has chosen another one.
  private refit(): void {
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
    const box = this.path.extent(true), cone = Math.min(20, Math.max(2, 0.08 * box.min.distanceTo(box.max))), wanted = `${number}:${cone}`;
    if (this.tool_drawn === wanted) return;
    this.tool_drawn = wanted;
    empty(this.tool);
    this.tool.add(tool_mesh(this.shapes.find((s) => s.number === number), cone, this.theme));
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
    if (this.lit_thin.visible) this.lit_thin.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(points, 3));
    this.touch();
  }

  private pick(x: number, y: number): Hit | null { return pick(this.path.drawn, this.eye, x, y, this.width, this.height, this.path.zero); }

  private click(x: number, y: number): void {
    const hit = this.pick(x, y);
    if (this.mode === "orbit") return this.events.pick(hit?.vertex ?? null);
    if (hit) this.measure_from(this.ends.length === 1 ? [this.ends[0]!, hit.place] : [hit.place]);
  }

  private measure_from(ends: Point[]): void {
    this.ends = ends;
    empty(this.ruler);
    const [a, b] = ends;
    if (a) {
      const line = new LineSegments2(new LineSegmentsGeometry().setPositions([...a, ...(b ?? a)]), new LineMaterial({ linewidth: b ? 2.5 : 8, depthTest: false, color: this.theme.bright }));
      line.renderOrder = 3;
      this.ruler.add(line);
    }
    const delta = (a && b ? [b[0] - a[0], b[1] - a[1], b[2] - a[2]] : null) as Point | null;
    this.events.measured(delta && { distance: Math.hypot(...delta), delta });
    this.touch();
  }

  private resize(): void {
    this.width = Math.max(1, this.host.clientWidth);
    this.height = Math.max(1, this.host.clientHeight);
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(this.width, this.height);
    this.eye.size(this.width, this.height);
    this.render();
  }

  private dirty = false;
  private touch(): void { this.dirty = true; this.ask(); }
  private ask(): void { this.asked ||= requestAnimationFrame(() => this.frame()); }

  private frame(): void {
    this.asked = 0;
    if (this.dirty) this.render();
    if (!this.pointer) return;
    const [x, y] = this.pointer, v: SceneVertex | null = this.pick(x, y)?.vertex ?? null;
    this.pointer = null;
    this.events.hover(v, x, y);
  }

  private render(): void {
    this.dirty = false;
    const all = this.extent(false).union(this.path.extent(true));
    if (this.tool.visible) all.expandByPoint(this.tool.position).expandByScalar(150); // the holder stands over the path
    if (!all.isEmpty()) this.eye.around(all.min.toArray() as Point, all.max.toArray() as Point);
    this.eye.update();
    this.lamp.position.copy(this.eye.towards).addScaledVector(this.eye.right, 0.4).addScaledVector(this.eye.up, 0.6); // over the viewer's shoulder
    const { drawn, all: count } = this.path.refresh(this.eye);
    this.renderer.render(this.stage, this.eye.camera);
    if (drawn === this.counted[0] && count === this.counted[1]) return;
    this.counted = [drawn, count];
    this.events.thinned(drawn, count);
  }
}

function make_renderer(): WebGLRenderer {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("webgl2", { antialias: true });
  if (!context) throw new NoWebGl("this browser gives no WebGL");
  const renderer = new WebGLRenderer({ canvas, context, antialias: true });
  renderer.localClippingEnabled = true;
  renderer.outputColorSpace = LinearSRGBColorSpace; // colours go to the screen as they stand in the theme
  return renderer;
}
