// Explains the words of a line on this control, where the mouse rests.
import { hoverTooltip } from "@codemirror/view";
import type { App } from "../model/app";
import type { Word } from "../protocol/types";
import { h } from "../ui/dom";

export const explain = (app: App) =>
  hoverTooltip(
    async (view, pos) => {
      const line = view.state.doc.lineAt(pos);
      let words: Word[];
      try {
        words = (await app.client.ask("explain", { line: line.number, text: line.text })).words;
      } catch {
        return null;
      }
      const column = pos - line.from + 1;
      const word = words.find((w) => column >= w.from && column < w.to);
      if (!word) return null;
      return {
        pos: line.from + word.from - 1,
        end: Math.min(line.to, line.from + word.to - 1),
        above: true,
        create: () => ({ dom: explained(word) }),
      };
    },
    { hoverTime: 350 },
  );

export function explained(word: Word): HTMLElement {
  return h(
    "div",
    { class: "explained" },
    h("div", null, h("code", null, word.code), " ", h("strong", null, word.title)),
    word.text && h("div", null, word.text),
  );
}
