// The sheet before a restart in the middle of a program: the position, what will be in force, the approach; one part for
// each channel.
import type { App } from "../model/app";
import { no_diameters } from "../model/diameters";
import type { Operator } from "../model/operator";
import type { Restart } from "../model/restart";
import type { BesideSheet, RestartSheet } from "../protocol/types";
import { t, type TextKey } from "../texts/texts";
import { button, h } from "./dom";
import { restart_rows, type SheetPart } from "./restart_rows";
import { restart_way, way_rules } from "./restart_way";

export class RestartSheetView {
  constructor(
    private app: App,
    private operator: Operator,
    private restart: Restart,
  ) {}

  /// `may`: the machine stands, and this page holds its keys.
  draw(may: boolean): HTMLElement {
    const { restart: r } = this,
      s = r.sheet!,
      part = this.part(s, may);
    return h(
      "div",
      { class: "restart-sheet" },
      s.beside.length > 0 && this.channel(s, may),
      h(
        "p",
        null,
        h("b", null, s.file ? `${s.file}:${s.line}` : t("line_n", { line: s.line })),
        " ",
        h("code", null, s.text),
        ...s.calls.map((c) => h("span", { class: "dim" }, ` ← ${c.what} (${c.line})`)),
      ),
      ...restart_rows(r, part),
      way_rules(r, may),
      restart_way(r, part),
      ...s.beside.map((b) => this.beside(b, may)),
      h(
        "div",
        { class: "row" },
        button(t("restart_go"), () => void r.go(), {
          class: "main",
          disabled: !may || r.searching,
          title: t("restart_go_long"),
        }),
      ),
      h(
        "details",
        null,
        h("summary", null, t("restart_blocks")),
        h("pre", { class: "restart-blocks" }, s.blocks.join("\n")),
        s.by_hand && h("p", { class: "note" }, `${t("restart_by_hand")} ${s.by_hand}`),
      ),
      this.own_search(),
    );
  }

  private part(sheet: RestartSheet | BesideSheet, may: boolean): SheetPart {
    const p = this.operator.panel,
      of = p?.channels.find((c) => c.number === sheet.number)?.diameters ?? p?.diameters ?? no_diameters;
    return { sheet, of, may };
  }

  /// The heading of a channel, if there are several: the order of their approaches.
  private channel(s: RestartSheet | BesideSheet, may: boolean): HTMLElement {
    const at = this.restart.ways.findIndex((w) => w.channel === s.number);
    return h(
      "div",
      { class: "row" },
      h("h3", { class: "grow" }, t("channel_n", { n: s.number })),
      h("span", { class: "dim" }, t("restart_turn", { n: at + 1 })),
      button(t("restart_first"), () => this.restart.go_first(s.number), {
        disabled: !may || at === 0,
        "aria-label": `${t("restart_first")}: ${t("channel_n", { n: s.number })}`,
      }),
    );
  }

  /// Another channel: its position at the restart, and its approach.
  private beside(b: BesideSheet, may: boolean): HTMLElement {
    const part = this.part(b, may);
    return h(
      "section",
      { class: "restart-beside" },
      this.channel(b, may),
      h(
        "p",
        null,
        h("b", null, b.line ? t("line_n", { line: b.line }) : ""),
        " ",
        h("code", null, b.text),
        " ",
        h("span", { class: "dim" }, t(`beside_${b.stands}`)),
      ),
      ...restart_rows(this.restart, part),
      restart_way(this.restart, part),
    );
  }

  /// What the control's own block search would restore, and what it would miss.
  private own_search(): HTMLElement | false {
    const s = this.restart.sheet!,
      found = s.search;
    if (this.app.opened?.control.id !== "nct") return false;
    const list = (name: TextKey, codes: { text: string; line: number }[]): HTMLElement | false =>
      codes.length > 0 &&
      h(
        "p",
        null,
        h("b", null, t(name)),
        " ",
        codes.map((c) => `${c.text} (${t("line_n", { line: c.line })})`).join(", "),
      );
    return h(
      "details",
      { open: Boolean(found) },
      h("summary", null, t("restart_own")),
      found
        ? h(
            "div",
            null,
            list("restart_carried", found.carried_out),
            list("restart_no_group", found.of_no_group),
            found.forgotten &&
              h("p", { class: "told alarm" }, h("b", null, t("restart_forgotten")), ` ${found.forgotten}`),
          )
        : button(t("restart_own_ask"), () => void this.restart.find(this.restart.place!, true)),
    );
  }
}
