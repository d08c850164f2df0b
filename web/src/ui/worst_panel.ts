// The lines that lose most time compared with their programmed feed.
import type { App } from "../model/app";
import { WorstLines } from "../model/worst";
import { on_language, t } from "../texts/texts";
import { fill, h } from "./dom";
import { feed_unit } from "../model/units";
import { feed } from "./figures";

const shown = 20;

export class WorstPanel {
  readonly element = h("div", { class: "worst" });
  private lines = new WorstLines();

  constructor(
    private app: App,
    private jump: (line: number, file: number) => void,
  ) {
    app.on_opening.on(() => {
      this.lines.clear();
      this.draw();
    });
    app.on_path.on((frame) => this.lines.add(frame));
    app.on_done.on(() => this.draw());
    on_language(() => this.draw());
    this.draw();
  }

  private draw(): void {
    const worst = this.app.done ? this.lines.worst(shown) : [];
    if (!worst.length) return fill(this.element, h("p", { class: "note" }, t("worst_none")));
    fill(
      this.element,
      h("p", { class: "note" }, t("worst_long")),
      h(
        "table",
        { class: "list" },
        h(
          "thead",
          null,
          h(
            "tr",
            null,
            ...[t("line"), t("lost_s"), t("takes_s"), `F, ${feed_unit()}`, `${t("slowest_v")}, ${feed_unit()}`].map(
              (x) => h("th", { scope: "col" }, x),
            ),
          ),
        ),
        h(
          "tbody",
          null,
          ...worst.map((w) =>
            h(
              "tr",
              null,
              h(
                "td",
                null,
                h(
                  "button",
                  {
                    type: "button",
                    class: "link",
                    onclick: () => {
                      this.app.seek(w.at);
                      this.jump(w.line, w.file);
                    },
                  },
                  w.file ? `${w.file}:${w.line}` : String(w.line),
                ),
              ),
              h("td", null, w.lost.toFixed(2)),
              h("td", null, w.seconds.toFixed(2)),
              h("td", null, feed(w.feed)),
              h("td", null, feed(w.least)),
            ),
          ),
        ),
      ),
    );
  }
}
