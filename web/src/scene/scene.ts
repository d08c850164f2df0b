// The 3D view: path, tool, part and boxes; it draws only when something has changed.
import { AmbientLight, Raycaster, Vector2, Vector3 } from "three";
import { SceneObjects } from "./objects";
import { dark } from "./colours";
import { Controls } from "./controls";
import { axes, empty, thick, tool_mesh } from "./marks";
import { distance_between } from "./measure";
import { pick, type Hit } from "./pick";
import type { OfPathFrame } from "../protocol/frames";
import { type Anchor, type Point, type SceneEvents, type SceneMode, type ToolShape, type ViewName } from "./types";
export * from "./types";

const refit_every = 200; // ms between updates of the extents while a path is arriving

export class Scene extends SceneObjects {
  constructor(host: HTMLElement, events: SceneEvents) {
    super(host, events);
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

  protected pick(x: number, y: number): Hit | null {
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
}
