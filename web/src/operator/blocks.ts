// The block that runs and the next three, from the text that the machine runs. A click goes to the line in the text.
import type { Operator } from "../model/operator";
import type { Panel } from "../protocol/types";
import { t } from "../texts/texts";
import { h } from "../ui/dom";
import { set, write } from "../ui/update";

const next_ones = 3;

export class Blocks {
  readonly element = h("ol", { class: "next-blocks" });
  private rows = Array.from({ length: 1 + next_ones }, () => ({
    number: h("span", { class: "block-number" }),
    text: h("code"),
  }));
  private lines: string[] = [];
  private of = ""; // the digest of `lines`
  private asking = false;

  constructor(
    private operator: Operator,
    private show_line: (line: number) => void,
  ) {
    for (const [i, row] of this.rows.entries())
      this.element.append(
        h(
          "li",
          {
            class: i === 0 ? "now" : "",
            onclick: () => this.show_line(Number(row.number.textContent) || 1),
          },
          row.number,
          row.text,
        ),
      );
  }

  /// The text of a line of the machine's program; empty if it is not known.
  line(n: number): string {
    return this.lines[n - 1] ?? "";
  }

  show(p: Panel): void {
    set(this.element, "aria-label", t("op_blocks"));
    if (p.digest !== this.of) void this.fetch(p.digest);
    for (const [i, row] of this.rows.entries()) {
      const here = p.file === 0 && !p.entered,
        line = p.line + i;
      write(row.text, i === 0 ? p.text : here ? this.line(line) : "");
      write(
        row.number,
        i === 0 ? (p.line ? String(p.line) : "") : here && line <= this.lines.length ? String(line) : "",
      );
    }
  }

  private async fetch(digest: string): Promise<void> {
    if (this.asking) return;
    this.asking = true;
    const got = await this.operator.ask("machine_source", {}, false);
    this.asking = false;
    this.of = got?.digest ?? digest; // a program that is too long to be shown has no next lines
    this.lines = got ? got.text.replace(/\n$/, "").split(/\r?\n/) : [];
  }
}
