// What the 3D view shows besides the path: the tool, the machine, boxes, the part, the highlighted line.
import { Box3, BufferAttribute, BufferGeometry, LineBasicMaterial, Matrix4, Plane, Vector3 } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { SceneStage } from "./stage";
import { dark, light } from "./colours";
import { bounded, box_lines, goes_beyond } from "./boxes";
import { axes, empty, fade, thick, lit_points, put_tool, tool_mesh } from "./marks";
import { part_mesh } from "./part_view";
import { carry_of } from "./carry";
import type { TurnedSection } from "./section";
import { quarter_planes, section_view } from "./turned_view";
import type { PartFrame } from "../protocol/frames";
import type { Joint } from "../protocol/types";
import { type ColourBy, type Point, type SceneBounds, type SceneBox, type SceneFilter } from "./types";

const most_thick = 4000; // segments: a thick line costs some ten times as much as a thin one

export abstract class SceneObjects extends SceneStage {
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

  protected draw_machine(): void {
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

  protected draw_part(): void {
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

  protected draw_tool(number: number): void {
    const box = this.path.extent(true),
      cone = Math.min(20, Math.max(2, 0.08 * box.min.distanceTo(box.max))),
      unplayed = !this.machine_at && this.path.instant <= 0, // before the first motion it must not hide the part
      wanted = `${number}:${cone}:${unplayed}`;
    if (this.tool_drawn === wanted) return;
    this.tool_drawn = wanted;
    empty(this.tool);
    const mesh = tool_mesh(
      this.shapes.find((s) => s.number === number),
      cone,
      this.theme,
    );
    if (unplayed) fade(mesh);
    this.tool.add(mesh);
    empty(this.origin);
    this.origin.add(axes(cone * 1.5));
  }

  protected relight(): void {
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
}
