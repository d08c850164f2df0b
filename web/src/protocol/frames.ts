// The head and columns of a binary frame (docs/panel-protocol.md, Frames). Views into the frame, nothing is copied.
export const frame_path = 1, frame_directions = 2, frame_part = 3, frame_positions = 4;
const head_bytes = 16, path_head_bytes = 80;

export interface Head { kind: number; which: number; count: number; more: number }
export interface PathColumns { start: number; first: number; times: Float32Array; lines: Uint32Array; numbers: Uint32Array; feeds: Float32Array; speeds: Float32Array; tools: Uint16Array; kinds: Uint8Array }

export function head_of(frame: ArrayBuffer): Head | null {
  if (frame.byteLength < head_bytes) return null;
  const v = new DataView(frame);
  return { kind: v.getUint32(0, true), which: v.getUint32(4, true), count: v.getUint32(8, true), more: v.getUint32(12, true) };
}

/// The columns of a piece of path; null where the frame is another kind or too short for what it says of itself.
export function path_columns(frame: ArrayBuffer): PathColumns | null {
  const head = head_of(frame);
  if (!head || head.kind !== frame_path) return null;
  const n = head.count, view = new DataView(frame);
  const at = head_bytes + path_head_bytes;
  const column_bytes = 12 + 4 * 7; // xyz, then time, line, number, feed, speed, tool+file, kind+level
  if (frame.byteLength < at + n * column_bytes) return null;
  let from = at + 12 * n;
  const step = (): number => { const f = from; from += 4 * n; return f; };
  return {
    start: view.getFloat64(head_bytes, true), first: view.getUint32(head_bytes + 32, true),
    times: new Float32Array(frame, step(), n), lines: new Uint32Array(frame, step(), n), numbers: new Uint32Array(frame, step(), n),
    feeds: new Float32Array(frame, step(), n), speeds: new Float32Array(frame, step(), n), tools: new Uint16Array(frame, step(), 2 * n),
    kinds: new Uint8Array(frame, step(), 4 * n),
  };
}
