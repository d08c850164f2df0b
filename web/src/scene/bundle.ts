// Pieces of the path that are drawn together: each call to the graphics card costs as much as thousands of segments,
// and a long path has hundreds of pieces.
import { BufferAttribute, BufferGeometry, LineSegments, type Material } from "three";
import type { Segments } from "./segments";

export const most_pieces = 32; // of a bundle: with more, joining them again after a change costs more than it saves

/// What a bundle joins of a piece: the `segments` starting at number `from`.
export interface Part {
  segments: Segments;
  from: number;
  visible: boolean;
}

export class Bundle<P extends Part> {
  readonly lines: LineSegments;
  readonly parts: P[] = [];
  private joined: Segments[] = []; // the source of the geometry

  constructor(
    material: Material,
    private dashed: boolean,
  ) {
    this.lines = new LineSegments(new BufferGeometry(), material);
    this.lines.matrixAutoUpdate = false;
    this.lines.frustumCulled = false; // pieces are culled before anything is built
    this.lines.visible = false;
  }

  /// Updates the lines after the parts were changed. The segments left out are at the beginning: the parts are in the
  /// order of time.
  refresh(): void {
    const shown = this.parts.filter((p) => p.visible && p.segments.ends.length > 0);
    this.lines.visible = shown.length > 0;
    if (!this.lines.visible) return;
    if (shown.length !== this.joined.length || shown.some((p, i) => p.segments !== this.joined[i]))
      this.join(shown.map((p) => p.segments));
    let from = 0;
    for (const p of shown) {
      from += p.from;
      if (p.from < p.segments.ends.length) break;
    }
    this.lines.geometry.setDrawRange(2 * from, Infinity);
  }

  /// Releases the joined lines.
  drop(): void {
    this.lines.geometry.dispose();
    this.lines.geometry = new BufferGeometry();
    this.lines.visible = false;
    this.joined = [];
  }

  private join(all: Segments[]): void {
    const count = all.reduce((n, s) => n + s.ends.length, 0),
      points = new Float32Array(6 * count),
      colours = new Uint32Array(2 * count);
    let at = 0;
    for (const s of all) {
      points.set(s.points, 6 * at);
      colours.set(s.colours, 2 * at);
      at += s.ends.length;
    }
    this.lines.geometry.dispose();
    this.lines.geometry = new BufferGeometry()
      .setAttribute("position", new BufferAttribute(points, 3))
      .setAttribute("color", new BufferAttribute(new Uint8Array(colours.buffer), 4, true));
    if (this.dashed) this.lines.computeLineDistances();
    this.joined = all;
  }
}
