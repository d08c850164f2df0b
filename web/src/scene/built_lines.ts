// The lines of the pieces of the path, built for a look and a level. A piece keeps those of one level more: moving and
// resting alternate, and have a level each.
import { Box3, Vector3 } from "three";
import type { Part } from "./bundle";
import { first_from } from "./place";
import type { Piece } from "./frame";
import { no_segments, runs, segments_of, type Look, type Segments } from "./segments";

/// `built`: the look and level that the lines were built for.
interface Made {
  built: string;
  segments: Segments;
}
export interface Drawn extends Part {
  piece: Piece;
  ordinal: number;
  box: Box3;
  now: Made | null;
  spare: Made | null;
}
/// The lines that are wanted; `stamp` stands for all of the look but level and share.
export interface Wanted {
  stamp: number;
  look: Look;
}

const most_held = 2_000_000; // segments that are built, in view or not

export const not_built = (piece: Piece, ordinal: number): Drawn => ({
  piece,
  ordinal,
  box: new Box3(new Vector3(...piece.least), new Vector3(...piece.greatest)),
  segments: no_segments,
  from: 0,
  visible: false,
  now: null,
  spare: null,
});

export class BuiltLines {
  private held = 0;

  get too_many(): boolean {
    return this.held > most_held;
  }

  has(d: Drawn, wanted: Wanted): boolean {
    return d.now?.built === name_of(wanted);
  }

  /// Gives the piece the wanted lines: its spare ones, or newly built.
  bring(d: Drawn, wanted: Wanted): void {
    const built = name_of(wanted);
    if (d.spare?.built === built) [d.now, d.spare] = [d.spare, d.now];
    else this.build(d, wanted, built);
    d.segments = d.now!.segments;
  }

  drop(d: Drawn): void {
    this.forget(d.now);
    this.forget(d.spare);
    d.now = d.spare = null;
    d.segments = no_segments;
    d.visible = false;
  }

  private build(d: Drawn, wanted: Wanted, built: string): void {
    const segments = segments_of(d.piece, { ...wanted.look, runs_before: d.ordinal * runs });
    this.forget(d.spare);
    if (d.now?.built.startsWith(`${wanted.stamp}:`)) d.spare = d.now;
    else {
      this.forget(d.now);
      d.spare = null;
    }
    d.now = { built, segments };
    this.held += segments.ends.length;
  }

  private forget(made: Made | null): void {
    if (made) this.held -= made.segments.ends.length;
  }
}

const name_of = ({ stamp, look }: Wanted): string => `${stamp}:${look.level}:${look.every}`;

/// Leaves out what the tool has done at an instant.
export function hide_done(d: Drawn, hides: boolean, instant: number): void {
  const { piece: p, segments } = d;
  d.from =
    hides && p.which !== 1
      ? first_from(segments.ends.length, (i) => p.start + p.times[segments.ends[i]!]!, instant)
      : 0;
}
