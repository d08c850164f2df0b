// The control's screen at the instant of the slider: positions, feed, spindle, tool, modal codes, variables, calls,
// passes.
import type { App } from "../model/app";
import { axis_name, is_diameter, no_diameters } from "../model/diameters";
import type { Axes, Passes, State } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";
import { axis_unit, length_unit } from "../model/units";
import { axis_value, clock, length } from "./figures";
import { icon } from "./icons";
import { figure, lengths_told, modal_of, motion_of, turning_offset, variables_of, zero_of } from "./state_parts";
import { Latest } from "../model/latest";

export class StatePane {
  readonly element = h("section", { class: "pane state" });
  private body = h("div", { class: "pane-body" });
  private passes: Passes | null = null;
  private passes_of = "";
  private ask_passes = new Latest<{ line: number; file: number }>(async (w) => {
    const key = `${w.file}:${w.line}`;
    this.passes = await this.app.client.ask("passes", w.file ? w : { line: w.line });
    this.passes_of = key;
    this.draw();
  });

  constructor(
    private app: App,
    private jump: (line: number, file: number) => void,
  ) {
    this.element.append(h("header", { class: "pane-head" }, h("span", { class: "pane-title" })), this.body);
    app.on_state.on((s) => {
      if (s) this.want_passes(s);
      this.draw();
    });
    app.on_opening.on(() => {
      this.passes_of = "";
    });
    on_language(() => this.draw());
    this.draw();
  }

  private want_passes(s: State): void {
    const file = s.file ?? 0;
    if (this.passes_of !== `${file}:${s.line}`) this.ask_passes.want({ line: s.line, file });
  }

  private draw(): void {
    const s = this.app.state;
    this.element.setAttribute("aria-label", t("state"));
    this.element.querySelector(".pane-title")!.textContent = t("state");
    if (!s) return fill(this.body, h("p", { class: "note" }, this.app.opened ? t("running") : t("open_a_program")));
    fill(
      this.body,
      this.block(s),
      this.positions(s),
      motion_of(s),
      this.tool(s),
      modal_of(s),
      zero_of(s),
      this.calls(s),
      variables_of(s),
    );
  }

  private block(s: State): HTMLElement {
    return h(
      "div",
      { class: "block-told" },
      h(
        "div",
        { class: "row" },
        h("span", { class: "dim" }, t("line_n", { line: s.line }), s.file_name ? ` · ${s.file_name}` : ""),
        h("span", { class: "grow" }),
        h("span", { class: "dim" }, t("left_time", { time: clock(s.left) })),
      ),
      h("code", { class: "block-text", tabindex: "0" }, s.text ?? ""),
      this.pass(s),
    );
  }

  private pass(s: State): HTMLElement | null {
    const p = this.passes;
    if (!p || this.passes_of !== `${s.file ?? 0}:${s.line}` || p.count < 2) return null;
    const here = p.passes.findIndex((x) => x.number >= s.number),
      n = here < 0 ? p.passes.length - 1 : here;
    const go = (i: number): void => {
      const to = p.passes[i];
      if (to) this.app.seek_block(to.number);
    };
    return h(
      "div",
      { class: "row pass" },
      h("span", null, t("pass_of", { n: s.pass || n + 1, m: p.count })),
      h("span", { class: "grow" }),
      button(icon("less"), () => go(n - 1), {
        class: "icon",
        disabled: n <= 0,
        "aria-label": t("pass_before"),
        title: t("pass_before"),
      }),
      button(icon("more"), () => go(n + 1), {
        class: "icon",
        disabled: n >= p.passes.length - 1,
        "aria-label": t("pass_after"),
        title: t("pass_after"),
      }),
    );
  }

  private positions(s: State): HTMLElement {
    const names = [...new Set([...Object.keys(s.position ?? {}), ...Object.keys(s.machine ?? {})])];
    const of = s.diameters ?? this.app.done?.diameters ?? no_diameters;
    const cell = (axes: Axes | undefined, name: string): HTMLElement =>
      h("td", null, axis_value(name, axes?.[name], of));
    const has_machine = Object.keys(s.machine ?? {}).length > 0; // a report has only the path
    return h(
      "table",
      { class: "positions" },
      h(
        "thead",
        null,
        h(
          "tr",
          null,
          h("th", null),
          h("th", { scope: "col" }, t("work")),
          has_machine && h("th", { scope: "col" }, t("machine_position")),
          h("th", { scope: "col" }, t("to_go")),
          h("th", null),
        ),
      ),
      h(
        "tbody",
        null,
        ...names.map((n) =>
          h(
            "tr",
            null,
            h("th", { scope: "row", title: is_diameter(n, of) ? t("is_diameter") : "" }, axis_name(n, of)),
            cell(s.position, n),
            has_machine && cell(s.machine, n),
            cell(s.togo, n),
            h("td", { class: "unit" }, axis_unit(n)),
          ),
        ),
      ),
    );
  }

  private tool(s: State): HTMLElement {
    const o = s.offsets ?? {},
      lengths = lengths_told(o.length);
    const name = this.app.done?.tools.find((x) => x.tool === s.tool)?.name;
    const knows = Object.keys(o).length > 0;
    if (s.tool_offset)
      return h(
        "div",
        { class: "figures" },
        figure("T", String(s.tool || "–"), name || t("tool")),
        ...turning_offset(s.tool_offset, s.diameters ?? no_diameters),
      );
    return h(
      "div",
      { class: "figures" },
      figure("T", String(s.tool || "–"), name || t("tool")),
      knows && figure(`D${o.D || ""}`, length(o.radius), t("radius"), length_unit()),
      knows && figure(`H${o.H || ""}`, lengths, t("length"), length_unit()),
    );
  }

  private calls(s: State): HTMLElement | null {
    if (!s.calls?.length) return null;
    return h(
      "div",
      { class: "calls" },
      h("h3", null, t("calls")),
      h(
        "ol",
        null,
        ...s.calls.map((c) =>
          h(
            "li",
            null,
            button(`${c.what} · ${t("line_n", { line: c.line })}`, () => this.jump(c.line, Number(c.file) || 0), {
              class: "link",
              title: c.block ?? "",
            }),
          ),
        ),
      ),
    );
  }
}
