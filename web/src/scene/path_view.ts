// The pieces of the path as lines on the screen: which are in view, how finely, and rebuilt only where that changed.
import { Box3, BufferAttribute, BufferGeometry, Frustum, Group, LineBasicMaterial, LineSegments, Matrix4, Vector3 } from "three";
import { light, ranges_of, type Ranges, type Theme } from "./colours";
import type { Eye } from "./camera";
import { decode_leans, decode_path, type Piece } from "./frame";
import { level_for, level_within, segments_at } from "./level";
import { first_from, place_at, type Place } from "./place";
import { piece_shown, segments_of, type Segments } from "./segments";
import type { ColourBy, Point, SceneFilter } from "./types";

export interface Drawn { piece: Piece; lines: LineSegments; built: string; segments: Segments; box: Box3 }

export class PathView {
  readonly group = new Group();
  drawn: Drawn[] = [];
  zero: Point = [0, 0, 0];
  instant = 0;
  private main: Piece[] = [];       // the program itself, channel 0, in order of time
  private ranges: Ranges = ranges_of([]);
  private stamp = 0;                // counts what changes the lines of every piece
  private material = new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false });
  private by: ColourBy = "kind";
  private theme: Theme = light;
  private filter: SceneFilter = { rapids: true, tools: null, depth: null, lines: null, hideDone: false, programmed: false, other: true };

  add(frame: ArrayBuffer): boolean {
    const piece = decode_path(frame);
    if (!piece) return this.add_leans(frame);
    const lines = new LineSegments(new BufferGeometry(), this.material);
    lines.matrixAutoUpdate = false;
    lines.frustumCulled = false; // culled here, before anything is built
    this.group.add(lines);
    this.drawn.push({ piece, lines, built: "", segments: { points: new Float32Array(), colours: new Uint8Array(), ends: new Uint32Array() }, box: this.box_of(piece) });
    if (piece.which === 0 && piece.channel === 0) this.main.push(piece);
    return true;
  }

  private add_leans(frame: ArrayBuffer): boolean {
    const head = frame.byteLength >= 16 ? new Uint32Array(frame, 0, 4) : null;
    const last = head && this.drawn.filter((d) => d.piece.which === head[1] && d.piece.channel === head[3]).at(-1)?.piece;
    const leans = last && decode_leans(frame, last);
    if (leans) last.leans = leans;
    return Boolean(leans);
  }

  /// Without `which` all goes; 1: the path that the program was compared with.
  clear(which?: number): void {
    const goes = (d: Drawn): boolean => which === undefined || (d.piece.which & 1) === which;
    for (const d of this.drawn.filter(goes)) { d.lines.geometry.dispose(); this.group.remove(d.lines); }
    this.drawn = this.drawn.filter((d) => !goes(d));
    if (which !== 1) this.main = [];
  }

  set_zero(zero: Point): void { this.zero = zero; for (const d of this.drawn) d.box = this.box_of(d.piece); this.change(); }
  set_filter(f: SceneFilter): void { this.filter = f; this.change(); }
  set_colour(by: ColourBy): void { this.by = by; this.change(); }
  set_theme(theme: Theme): void { this.theme = theme; this.change(); }
  place(time: number): Place | null { return place_at(this.main, time); }

  /// What cuts, or where nothing cuts all of the path; from the picture's zero.
  extent(cut: boolean): Box3 {
    const all = new Box3();
    for (const { piece: p, box } of this.drawn) {
      if (!piece_shown(p, this.filter)) continue;
      if (!cut) all.union(box);
      else if (p.cut) all.union(new Box3(this.from_zero(p.cut[0]), this.from_zero(p.cut[1])));
    }
    return cut && all.isEmpty() ? this.extent(false) : all;
  }

  /// Builds what is missing at the level of this view. Gives how many segments are drawn, and how many there are.
  refresh(eye: Eye): { drawn: number; all: number } {
    const seen = this.seen(eye);
    const level = level_within(seen.map((d) => d.piece), level_for(eye.mm_per_pixel));
    const wanted = `${this.stamp}:${level}`;
    let drawn = 0;
    for (const d of seen) {
      if (d.built !== wanted) this.build(d, level, wanted);
      drawn += d.segments.ends.length;
      this.hide_done(d);
    }
    const all = segments_at(seen.map((d) => d.piece), 0), kept = segments_at(seen.map((d) => d.piece), level);
    return { drawn: kept < all ? drawn : all, all };
  }

  private seen(eye: Eye): Drawn[] {
    const view = new Frustum().setFromProjectionMatrix(new Matrix4().multiplyMatrices(eye.camera.projectionMatrix, eye.camera.matrixWorldInverse));
    return this.drawn.filter((d) => (d.lines.visible = piece_shown(d.piece, this.filter) && view.intersectsBox(d.box)));
  }

  private build(d: Drawn, level: number, built: string): void {
    d.segments = segments_of(d.piece, { level, filter: this.filter, by: this.by, ranges: this.ranges, theme: this.theme, zero: this.zero });
    d.lines.geometry.dispose();
    d.lines.geometry = new BufferGeometry();
    d.lines.geometry.setAttribute("position", new BufferAttribute(d.segments.points, 3));
    d.lines.geometry.setAttribute("color", new BufferAttribute(d.segments.colours, 4, true));
    d.built = built;
  }

  private hide_done({ piece: p, segments, lines }: Drawn): void {
    const from = this.filter.hideDone && p.which !== 1 ? first_from(segments.ends.length, (i) => p.start + p.times[segments.ends[i]!]!, this.instant) : 0;
    lines.geometry.setDrawRange(2 * from, Infinity);
  }

  /// After the last piece: the ramps of colour run over all of the path.
  change(): void { this.ranges = ranges_of(this.drawn.map((d) => d.piece).filter((p) => !(p.which & 1))); this.stamp++; }

  private from_zero(p: Point): Vector3 { return new Vector3(p[0] - this.zero[0], p[1] - this.zero[1], p[2] - this.zero[2]); }
  private box_of(p: Piece): Box3 { return new Box3(this.from_zero(p.least), this.from_zero(p.greatest)); }
}
