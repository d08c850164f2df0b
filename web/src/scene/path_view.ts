// The pieces of the path as lines on the screen: decides which are in view and in which detail, and rebuilds only what
// changed, a few milliseconds' worth per picture.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Group,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  Vector3,
  type Material,
} from "three";
import type { OfPathFrame } from "../protocol/frames";
import { BuiltLines, hide_done, not_built, type Drawn, type Wanted } from "./built_lines";
import { Bundle, most_pieces } from "./bundle";
import { is_ramp, light, no_ranges, ranges_of, widen_ranges, type Ranges, type Theme } from "./colours";
import type { Eye } from "./camera";
import { add_rows, piece_of, type Piece } from "./frame";
import { InView } from "./in_view";
import { every_of, level_of, segments_at } from "./level";
import { place_at, type Place } from "./place";
import { piece_shown } from "./segments";
import { usual_filter, type ColourBy, type Point, type SceneFilter } from "./types";

export interface Refreshed {
  drawn: number;
  all: number;
  finished: boolean;
  cost: number;
} // `cost`: in segments, as a budget counts

export class PathView {
  readonly group = new Group();
  drawn: Drawn[] = [];
  zero: Point = [0, 0, 0];
  instant = 0;
  ranges: Ranges = no_ranges();
  kinds = new Set<number>(); // kinds of motion in the program's own path
  private main: Piece[] = []; // the program itself, channel 0, in order of time
  private last = new Map<string, Piece>(); // of each path and channel
  private bundles: Bundle<Drawn>[] = [];
  private open = new Map<string, Bundle<Drawn>>(); // the bundle of each path and channel that accepts more pieces
  private stamp = 0; // counts changes that affect the lines of every piece
  private lines = new BuiltLines();
  private in_view = new InView();
  private whole = new Box3(); // of what the filter shows; machine coordinates
  private cutting = new Box3();
  private material = new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false });
  private dashes = new LineDashedMaterial({
    vertexColors: true,
    transparent: true,
    depthWrite: false,
    dashSize: 1,
    gapSize: 0.7,
  });
  private by: ColourBy = "kind";
  private theme: Theme = light;
  private filter = usual_filter;

  constructor() {
    this.group.matrixAutoUpdate = false;
  }

  /// Lines of its materials, to compile their shaders.
  samples(): LineSegments[] {
    // Colours with an alpha have a shader of their own.
    const geometry = new BufferGeometry().setAttribute("color", new BufferAttribute(new Uint8Array(), 4, true));
    return [this.material, this.dashes].map((m) => new LineSegments(geometry, m as Material));
  }

  /// Adds directions of the tool or positions of what rotates the part to the preceding piece; returns false if they
  /// fit none.
  add(frame: OfPathFrame): boolean {
    const whose = `${frame.which} ${frame.channel}`;
    if (frame.kind !== "path") {
      const last = this.last.get(whose);
      return last !== undefined && add_rows(last, frame);
    }
    const piece = piece_of(frame);
    const d = not_built(piece, this.drawn.length);
    this.drawn.push(d);
    this.bundle_for(piece).parts.push(d);
    this.last.set(whose, piece);
    if (piece.which === 0 && piece.channel === 0) this.main.push(piece);
    if (!(piece.which & 1)) {
      widen_ranges(this.ranges, piece);
      for (const k of piece.kinds_seen) this.kinds.add(k);
    }
    this.widen(piece);
    return true;
  }

  private bundle_for(piece: Piece): Bundle<Drawn> {
    const whose = `${piece.which} ${piece.channel}`,
      open = this.open.get(whose);
    if (open && open.parts.length < most_pieces) return open;
    const dashed = (piece.which & 2) !== 0,
      bundle = new Bundle<Drawn>((dashed ? this.dashes : this.material) as Material, dashed);
    this.bundles.push(bundle);
    this.open.set(whose, bundle);
    this.group.add(bundle.lines);
    return bundle;
  }

  /// Without `which` everything is removed; 1: the path that the program was compared with.
  clear(which?: number): void {
    const goes = (d: Drawn): boolean => which === undefined || (d.piece.which & 1) === which;
    const of_those = (b: Bundle<Drawn>): boolean => goes(b.parts[0]!);
    for (const d of this.drawn.filter(goes)) this.lines.drop(d);
    for (const b of this.bundles.filter(of_those)) {
      b.drop();
      this.group.remove(b.lines);
    }
    this.drawn = this.drawn.filter((d) => !goes(d));
    this.bundles = this.bundles.filter((b) => !of_those(b));
    this.last.clear();
    this.open.clear();
    if (which !== 1) {
      this.main = [];
      this.kinds.clear();
    }
    this.measure();
  }

  set_zero(zero: Point): void {
    this.zero = zero;
    this.group.matrix.setPosition(-zero[0], -zero[1], -zero[2]);
    this.group.matrixWorldNeedsUpdate = true;
    if (this.filter.depth) this.stamp++;
  }
  set_filter(f: SceneFilter): void {
    this.filter = f;
    this.stamp++;
    this.measure();
  }
  set_colour(by: ColourBy): void {
    this.by = by;
    this.stamp++;
  }
  set_theme(theme: Theme): void {
    this.theme = theme;
    this.stamp++;
  }
  place(time: number): Place | null {
    return place_at(this.main, time);
  }
  get shows_bounds(): boolean {
    return this.filter.bounds;
  }
  get turns_part(): boolean {
    return this.filter.turned;
  }

  /// Box of the cutting motions, or of all of the path if nothing cuts; relative to the picture's zero.
  extent(cut: boolean): Box3 {
    const box = cut && !this.cutting.isEmpty() ? this.cutting : this.whole;
    return box.isEmpty() ? new Box3() : box.clone().translate(new Vector3(...this.zero).negate());
  }

  /// Builds what is missing at the level of this view, until `deadline`. Returns how many segments are drawn, and how
  /// many there are. `pixels`: of a line, which cost as much as a segment.
  refresh(eye: Eye, budget: number, pixels: number, deadline = Infinity): Refreshed {
    const seen = this.seen(eye),
      pieces = seen.map((d) => d.piece);
    const level = level_of(pieces, eye.mm_per_pixel, budget),
      all = segments_at(pieces, 0),
      kept = segments_at(pieces, level);
    const length = Number.isFinite(pixels)
      ? seen.reduce((sum, d) => sum + d.piece.length * this.in_view.part_of(d.box), 0)
      : 0;
    const full = kept + length / eye.mm_per_pixel / pixels,
      every = every_of(full, budget),
      wanted = this.wanted(level, every),
      finished = this.bring(seen, wanted, deadline);
    const drawn = seen.reduce((sum, d) => sum + d.segments.ends.length, 0);
    for (const b of this.bundles) b.refresh();
    this.dash(eye);
    return {
      drawn: kept < all || every > 1 || !finished ? Math.min(drawn, all) : all,
      all,
      finished,
      cost: full / every,
    };
  }

  /// Returns false if the time did not suffice: the old lines are shown for what is missing.
  private bring(seen: Drawn[], wanted: Wanted, deadline: number): boolean {
    let finished = true,
      built = 0;
    for (const d of seen) {
      if (!this.lines.has(d, wanted)) {
        if (built > 0 && performance.now() > deadline) finished = false;
        else {
          this.lines.bring(d, wanted);
          built++;
        }
      }
      d.visible = d.now !== null;
      hide_done(d, this.filter.hideDone, this.instant);
    }
    if (this.lines.too_many) this.drop_unseen();
    return finished;
  }

  private wanted(level: number, every: number): Wanted {
    const { stamp, filter, by, ranges, theme } = this;
    return { stamp, look: { level, every, filter, by, ranges, theme, zero_z: this.zero[2] } };
  }

  private seen(eye: Eye): Drawn[] {
    this.in_view.look(eye, this.group.matrix);
    return this.drawn.filter((d) => {
      const is_seen = piece_shown(d.piece, this.filter) && this.in_view.sees(d.box);
      if (!is_seen) d.visible = false;
      return is_seen;
    });
  }

  private drop_unseen(): void {
    for (const d of this.drawn) if (!d.visible) this.lines.drop(d);
    for (const b of this.bundles) if (!b.lines.visible) b.drop();
  }

  /// Dashes keep their length on the screen, in steps, so that they do not drift during zooming.
  private dash(eye: Eye): void {
    this.dashes.scale = 1 / (6 * 2 ** Math.round(Math.log2(eye.mm_per_pixel)));
  }

  /// After the last piece: the ramps of colour cover all of the path.
  change(): void {
    if (is_ramp(this.by)) this.stamp++;
  }

  private widen(p: Piece): void {
    if (!piece_shown(p, this.filter)) return;
    this.whole.union(new Box3(new Vector3(...p.least), new Vector3(...p.greatest)));
    if (p.cut) this.cutting.union(new Box3(new Vector3(...p.cut[0]), new Vector3(...p.cut[1])));
  }
  private measure(): void {
    this.whole.makeEmpty();
    this.cutting.makeEmpty();
    for (const d of this.drawn) this.widen(d.piece);
    this.ranges = ranges_of(this.drawn.map((d) => d.piece).filter((p) => !(p.which & 1)));
  }
}
