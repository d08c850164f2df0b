// What the cursor and the view of the path say to each other (web/src/report/editor.ts has the other side).
export type ToView = { kind: "line"; line: number } | { kind: "report"; text: string };
export type FromView = { kind: "ready" } | { kind: "line"; line: number; file: string; picked: boolean };

/// The line in which cursor and view agree, from 1: a move that the other side has caused is not sent back.
export class Follow {
  private shared = 0;

  /// The cursor has moved.  returns the message for the view, null if it knows
  cursor(line: number): ToView | null {
    if (line === this.shared) return null;
    this.shared = line;
    return { kind: "line", line };
  }

  /// The view has shown a report and waits for the line of the cursor.
  begin(line: number): ToView {
    this.shared = line;
    return { kind: "line", line };
  }

  /// The view has moved.  returns the line for the cursor; null if it is there
  view(line: number): number | null {
    if (line === this.shared) return null;
    this.shared = line;
    return line;
  }
}

/// Returns the message if it is one of the view's.
export function read_message(message: unknown): FromView | null {
  const m = message as Partial<Record<string, unknown>> | null;
  if (m?.kind === "ready") return { kind: "ready" };
  if (m?.kind !== "line" || typeof m.line !== "number" || !Number.isInteger(m.line) || m.line < 1) return null;
  return { kind: "line", line: m.line, file: typeof m.file === "string" ? m.file : "", picked: m.picked === true };
}
