// The sheet before a restart in the middle of a program: the position, what will be in force, the approach.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import { Restart } from "../model/restart";
import type { BesideSheet, RestartPlace, RestartRow, RestartSheet } from "../protocol/types";
import { on_language, t, type TextKey } from "../texts/texts";
import { button, fill, h, redraw } from "./dom";
import { axis_name, factor, no_diameters, type Diameters } from "../model/diameters";
import { coordinate } from "./figures";

/// Positions, origins and lengths along an axis in diameter programming are shown as diameters.
const of_an_axis = ["position", "machine", "origin", "length"];
const written = (row: RestartRow, v: string | number | null, of: Diameters): string =>
  v === null
    ? "–"
    : typeof v === "string"
      ? v
      : row.kind === "variable"
        ? String(v)
        : ["tool", "selected", "offset", "length_offset"].includes(row.kind)
          ? String(v)
          : coordinate(of_an_axis.includes(row.kind) ? factor(row.name, of) * v : v);

export class RestartPanel {
  readonly element = h("details", { class: "restart" });
  readonly restart: Restart;
  private body = h("div");
  private drawn = "";

  constructor(
    private app: App,
    private operator: Operator,
  ) {
    this.restart = new Restart(operator);
    this.restart.on_change.on(() => this.draw());
    operator.on_panel.on(() => this.draw());
    on_language(() => {
      this.drawn = "";
      this.draw();
    });
    this.element.addEventListener("toggle", () => this.draw());
    this.draw();
  }

  /// Starts from a position that is already known.
  async find(place: RestartPlace): Promise<void> {
    this.restart.leave.clear();
    await this.restart.find(place);
    this.propose_clearance();
    this.body.querySelector(".restart-sheet")?.scrollIntoView({ block: "nearest" });
  }

  private draw(): void {
    const p = this.operator.panel,
      { restart: r } = this;
    this.element.hidden = !p;
    if (!p) return;
    const may = p.holds && ["standing", "ended"].includes(p.mode);
    const wanted = JSON.stringify([may, p.diameters, r.sheet, r.ways, [...r.leave], r.searching, this.element.open]);
    if (wanted === this.drawn) return;
    this.drawn = wanted;
    fill(
      this.element,
      h("summary", null, h("b", null, t("restart")), " ", h("span", { class: "dim" }, t("in_mm"))),
      this.body,
    );
    if (!this.element.open) return;
    redraw(this.body, () =>
      fill(
        this.body,
        this.form(may),
        r.searching && h("p", { class: "note", "aria-live": "polite" }, t("restart_searching")),
        r.sheet && this.sheet(may),
      ),
    );
  }

  private form(may: boolean): HTMLElement {
    const place = this.restart.place,
      number = (name: TextKey, value: number | undefined): HTMLInputElement =>
        h("input", {
          size: "6",
          inputmode: "numeric",
          "aria-label": t(name),
          placeholder: t(name),
          value: value ? String(value) : "",
        });
    const line = number("stop_line", place?.line ?? this.app.state?.line),
      pass = number("restart_pass", place?.pass),
      hole = number("restart_hole", place?.hole);
    const call = h("input", {
      size: "8",
      "aria-label": t("restart_call"),
      placeholder: t("restart_call"),
      value: place?.call ?? "",
    });
    const find = (): void => {
      const wish: RestartPlace = {};
      for (const [key, input] of [
        ["line", line],
        ["pass", pass],
        ["hole", hole],
      ] as const)
        if (Number(input.value) > 0) wish[key] = Math.round(Number(input.value));
      if (call.value.trim()) wish.call = call.value.trim();
      void this.find(wish);
    };
    const on_enter = (e: KeyboardEvent): void => {
      if (e.key === "Enter" && may) find();
    };
    return h(
      "div",
      { class: "row wrap", onkeydown: on_enter },
      ...[line, pass, call, hole].map((i) =>
        h("label", { class: "field" }, h("span", null, i.getAttribute("aria-label")), i),
      ),
      button(t("restart_find"), find, { disabled: !may }),
      this.restart.sheet && button(t("restart_forget"), () => this.restart.forget()),
    );
  }

  /// Above everything on the program's path.
  private propose_clearance(): void {
    const { sheet: s, rules } = this.restart,
      all = this.app.done?.extents.all,
      zero = this.app.done?.zero;
    if (!s || rules.clearance !== undefined || s.normal !== "Z" || !all || !zero) return;
    const origin = s.rows.find((r) => r.kind === "origin" && r.name === "Z")?.wanted;
    if (typeof origin === "number")
      this.restart.set_rules({ clearance: Math.round(1000 * (all[1][2]! + zero[2] - origin)) / 1000 });
  }

  private sheet(may: boolean): HTMLElement {
    const { restart: r } = this,
      s = r.sheet!,
      beside = s.beside.length > 0;
    return h(
      "div",
      { class: "restart-sheet" },
      beside && this.channel(s, may),
      h(
        "p",
        null,
        h("b", null, s.file ? `${s.file}:${s.line}` : t("line_n", { line: s.line })),
        " ",
        h("code", null, s.text),
        ...s.calls.map((c) => h("span", { class: "dim" }, ` ← ${c.what} (${c.line})`)),
      ),
      ...this.rows(s, may),
      this.rules(may),
      this.way(s, may),
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

  private rows(s: RestartSheet | BesideSheet, may: boolean): HTMLElement[] {
    const other = s.rows.filter((row) => row.by !== ""),
      same = s.rows.filter((row) => row.by === "");
    return [
      h(
        "table",
        { class: "restart-rows" },
        h(
          "thead",
          null,
          h(
            "tr",
            null,
            h("th", null),
            ...(["restart_wanted", "restart_now", "restart_by"] as const).map((x) => h("th", { scope: "col" }, t(x))),
          ),
        ),
        h("tbody", null, ...other.map((row) => this.row(row, may, s.number))),
      ),
      h(
        "details",
        null,
        h("summary", { class: "dim" }, t("restart_same", { n: same.length })),
        h("table", { class: "restart-rows" }, h("tbody", null, ...same.map((row) => this.row(row, false, s.number)))),
      ),
    ];
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
      ...this.rows(b, may),
      this.way(b, may),
    );
  }

  /// The axes in diameter programming of a channel.
  private diameters(channel: number): Diameters {
    const p = this.operator.panel;
    return p?.channels.find((c) => c.number === channel)?.diameters ?? p?.diameters ?? no_diameters;
  }

  private row(row: RestartRow, may: boolean, channel: number): HTMLElement {
    const of = this.diameters(channel);
    const name = t(`force_${row.kind}` as TextKey),
      leaves = this.restart.leave.has(row.key);
    const how = row.may_be_left
      ? h(
          "select",
          {
            "aria-label": `${name} ${row.name}`,
            disabled: !may,
            onchange: (e: Event) => this.restart.set_leave(row.key, (e.target as HTMLSelectElement).value === "leave"),
          },
          ...(["set", "leave"] as const).map((v) => {
            const o = h("option", { value: v }, t(`restart_${v}`));
            o.selected = (v === "leave") === leaves;
            return o;
          }),
        )
      : h("span", { class: "dim" }, row.by && t(`restart_by_${row.by}` as TextKey));
    return h(
      "tr",
      { class: row.by && !leaves ? "differs" : "" },
      h("th", { scope: "row" }, `${name} ${of_an_axis.includes(row.kind) ? axis_name(row.name, of) : row.name}`),
      h("td", null, written(row, row.wanted, of)),
      h("td", null, written(row, row.now, of)),
      h("td", null, how),
    );
  }

  private rules(may: boolean): HTMLElement {
    const { restart: r } = this,
      rule = (name: "clearance" | "above" | "feed"): HTMLElement => {
        const input = h("input", {
          size: "6",
          inputmode: "decimal",
          "aria-label": t(`restart_${name}`),
          disabled: !may,
          value: r.rules[name] === undefined ? "" : String(r.rules[name]),
          onchange: () => {
            const v = Number(input.value.replace(",", "."));
            input.value = input.defaultValue;
            if (Number.isFinite(v)) r.set_rules({ [name]: v });
          },
        });
        return h("label", { class: "field" }, h("span", null, t(`restart_${name}`)), input);
      };
    return h(
      "section",
      null,
      h("h3", null, t("restart_way")),
      h("div", { class: "row wrap" }, rule("clearance"), rule("above"), rule("feed")),
    );
  }

  private way(s: RestartSheet | BesideSheet, may: boolean): HTMLElement {
    const { restart: r } = this,
      of = this.diameters(s.number),
      way = r.way(s.number),
      own = s.number === r.sheet!.number,
      name = own ? t("restart_way") : `${t("channel_n", { n: s.number })}: ${t("restart_way")}`;
    const point = (i: number): HTMLElement => {
      const p = way[i]!;
      return h(
        "li",
        { class: "row" },
        h("b", null, p.rapid ? "G0" : "G1"),
        ...Object.entries(p.to).map(([axis, v]) => {
          const input = h("input", {
            size: "8",
            inputmode: "decimal",
            "aria-label": `${name} ${i + 1} ${axis}`,
            disabled: !may,
            value: (factor(axis, of) * (v - (s.zero[axis] ?? 0))).toFixed(3),
            onchange: () => {
              const v = Number(input.value.replace(",", "."));
              input.value = input.defaultValue;
              r.set_point(i, axis, v / factor(axis, of), s.number);
            },
          });
          return h("label", { class: "field" }, h("span", null, axis_name(axis, of)), input);
        }),
        !p.rapid && h("span", { class: "dim" }, `F${p.feed}`),
      );
    };
    return h(
      "section",
      null,
      h("ol", { class: "restart-way" }, ...way.map((_, i) => point(i))),
      !way.length && h("p", { class: "note" }, t("restart_no_way")),
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
