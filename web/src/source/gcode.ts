// Colours the visible words in the editor. No word of G-code continues over a line's end, so a line needs nothing of
// the lines before it.
import { RangeSetBuilder } from "@codemirror/state";
import { Decoration, ViewPlugin, type DecorationSet, type EditorView, type ViewUpdate } from "@codemirror/view";
import { token_at } from "./tokens";

const marks = new Map<string, Decoration>();
function mark(kind: string): Decoration {
  const found = marks.get(kind) ?? Decoration.mark({ class: `tok-${kind}` });
  marks.set(kind, found);
  return found;
}

const longest = 5000; // characters of one line that are coloured

function colours(view: EditorView): DecorationSet {
  const out = new RangeSetBuilder<Decoration>();
  for (const { from, to } of view.visibleRanges) {
    for (let at = from; at <= to;) {
      const line = view.state.doc.lineAt(at),
        text = line.text.slice(0, longest);
      for (let i = 0; i < text.length;) {
        const { kind, length } = token_at(text, i);
        if (kind) out.add(line.from + i, line.from + Math.min(text.length, i + length), mark(kind));
        i += length;
      }
      at = line.to + 1;
    }
  }
  return out.finish();
}

export const gcode = ViewPlugin.fromClass(
  class {
    decorations: DecorationSet;
    constructor(view: EditorView) {
      this.decorations = colours(view);
    }
    update(u: ViewUpdate): void {
      if (u.docChanged || u.viewportChanged) this.decorations = colours(u.view);
    }
  },
  { decorations: (v) => v.decorations },
);
