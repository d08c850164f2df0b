// Cutting: blank and tools as proposed, which can be changed; then the progress, the collisions, and the remaining
// stock.
import type { App } from "../model/app";
import { box_of, cylinder_of, extent_of, proper, stock_of, stock_of_cylinder, type Cylinder } from "../model/stock";
import { shape_of, with_inserts } from "../model/tool_shape";
import { diameter_sign } from "../model/diameters";
import type { Box, CutThread, Insert, PartAnswer, Problem, Tool } from "../protocol/types";
import { on_language, t, type TextKey } from "../texts/texts";
import { button, fill, h, option } from "./dom";
import { length, length_told, short, volume_told } from "./figures";
import { tool_picture } from "./outline";
import { CutProblems } from "./problems_panel";
import { fact } from "./summary";

const kinds = ["flat", "ball", "bull", "drill", "taper", "chamfer", "tslot", "form", "turning"];
const sizes: (keyof Tool & ("diameter" | "corner" | "angle" | "lead" | "width" | "tip" | "flute_length" | "length"))[] =
  ["diameter", "corner", "angle", "lead", "width", "tip", "flute_length", "length"];
const sizes_of: Record<string, string[]> = {
  flat: [],
  ball: [],
  bull: ["corner"],
  drill: ["angle", "tip"],
  chamfer: ["angle", "tip"],
  taper: ["angle"],
  turning: ["corner", "angle", "lead", "width"],
};
/// The programmed point of an insert, by the directions from the nose's centre, with the number of the imaginary tip.
const tips: [string, string][] = [
  ["-x-z", "3"],
  ["-x+z", "4"],
  ["+x-z", "2"],
  ["+x+z", "1"],
  ["-x", "8"],
  ["+x", "6"],
  ["-z", "7"],
  ["+z", "5"],
  ["centre", "0, 9"],
];

export class CutPanel {
  readonly element = h("div", { class: "cut" });
  private stock = "";
  private tools: Tool[] = [];
  private files: string[] = []; // tools files next to the program
  private fixtures: string[] = [];
  private resolution = "";
  private inserts: Insert[] = []; // outlines of the turning tools as proposed, or as cut
  private known = false;
  private of: string | null = null; // the program that blank and tools belong to
  private touched = false; // by the user
  private start = h("div", { class: "row cut-start" });
  private form = h("div");
  private told = h("div", { "aria-live": "polite" });
  private part: PartAnswer | null = null;
  private hit: CutProblems;

  constructor(
    private app: App,
    private shown: (stock: Box | null, tools: Tool[], inserts: Insert[]) => void,
    jump: (p: Problem) => void,
  ) {
    this.hit = new CutProblems(app, jump);
    this.element.append(this.start, this.told, this.form);
    this.element.addEventListener("change", () => {
      this.touched = true;
    });
    app.on_opening.on(() => {
      this.known = false;
      this.part = null;
      this.draw();
    });
    app.on_done.on(() => void this.propose());
    app.on_cut.on((part) => {
      if (part === null) this.part = app.cut_ready ? this.part : null;
      this.draw_told(part);
      if (part === null || part === 0) this.draw_run();
      if (part === null && app.cut?.inserts?.length) {
        this.inserts = app.cut.inserts;
        this.show();
      }
    });
    app.on_part_told.on((p) => {
      this.part = p;
      this.draw_told(null);
    });
    on_language(() => this.draw());
    this.draw();
  }

  badge(): string {
    return this.hit.badge();
  }

  private async propose(): Promise<void> {
    try {
      const p = await this.app.client.ask("proposals", {});
      const opened = this.app.opened?.file ?? null;
      if (opened === null || opened !== this.of || !this.touched) {
        // changes by the user stay while the program is edited
        this.touched = false;
        this.stock = p.stock ?? "";
        this.tools = p.tools ?? [];
        this.fixtures = [];
        this.resolution = "";
      } else this.tools.push(...(p.tools ?? []).filter((x) => !this.tools.some((y) => y.number === x.number)));
      this.of = opened;
      this.files = p.files ?? [];
      this.inserts = p.inserts ?? [];
      this.known = true;
    } catch {
      this.known = true; /* a program without motion has no blank: the form stays empty */
    }
    this.draw();
  }

  /// Reads the tools from a file next to the program.
  private async take_file(file: string): Promise<void> {
    try {
      const found = await this.app.client.ask("proposals", { tools: file });
      this.tools = found.tools;
      this.inserts = found.inserts ?? [];
    } catch (e) {
      this.app.tell(e);
    }
    this.draw();
  }

  private draw(): void {
    if (!this.known) fill(this.form, h("p", { class: "note" }, this.app.opened ? t("running") : t("open_a_program")));
    else
      fill(
        this.form,
        h("h3", null, `${t("stock")}, ${t("mm")}`),
        this.stock_form(),
        this.fixtures_form(),
        h("h3", null, `${t("tools")}, ${t("mm")}`),
        this.files_form(),
        ...this.tools.map((x) => this.tool_form(x)),
        button(t("add_tool"), () => {
          this.touched = true;
          this.tools.push({
            number: Math.max(0, ...this.tools.map((x) => x.number)) + 1,
            kind: "flat",
            diameter: 10,
            flute_length: 20,
            length: 50,
          });
          this.draw();
        }),
      );
    fill(
      this.start,
      this.known && h("div", { class: "cut-run" }),
      this.known &&
        h(
          "label",
          { class: "field" },
          h("span", null, t("resolution")),
          this.input(
            this.resolution,
            (v) => {
              this.resolution = v;
            },
            { placeholder: t("auto"), inputmode: "decimal" },
          ),
          h("span", { class: "dim" }, t("mm")),
        ),
    );
    this.draw_run();
    this.draw_told(null);
    this.show();
  }

  private show(): void {
    if (this.known) this.shown(extent_of(this.stock), this.tools, this.inserts);
  }

  private draw_run(): void {
    const e = this.start.querySelector(".cut-run");
    if (e)
      fill(
        e,
        this.app.cutting
          ? button(t("stop"), () => this.app.stop(), { class: "stop" })
          : button(t("cut"), () => this.run(), { class: "main", disabled: !this.app.done }),
      );
  }

  private stock_form(): HTMLElement {
    const box = box_of(this.stock),
      cylinder = cylinder_of(this.stock);
    const text = h(
      "label",
      { class: "field" },
      h("span", null, t("stock_as_text")),
      this.input(
        this.stock,
        (v) => {
          this.stock = v;
          this.draw();
        },
        { class: "wide" },
      ),
    );
    if (cylinder) return h("div", null, this.cylinder_form(cylinder), text);
    if (!box) return text;
    const cell = (corner: 0 | 1, i: number): HTMLElement =>
      h(
        "td",
        null,
        this.input(
          String(box[corner][i]),
          (v) => {
            box[corner][i] = Number(v.replace(",", "."));
            this.stock = stock_of(box);
            this.draw();
          },
          { inputmode: "decimal", "aria-label": `${"XYZ"[i]} ${t(corner ? "to" : "from")}` },
        ),
      );
    return h(
      "div",
      null,
      h(
        "table",
        { class: "list stock-form" },
        h(
          "thead",
          null,
          h("tr", null, h("th", null), h("th", { scope: "col" }, t("from")), h("th", { scope: "col" }, t("to"))),
        ),
        h(
          "tbody",
          null,
          ...[0, 1, 2].map((i) => h("tr", null, h("th", { scope: "row" }, "XYZ"[i]!), cell(0, i), cell(1, i))),
        ),
      ),
      !proper(box) && h("p", { class: "hint error" }, t("stock_inside_out")),
      text,
    );
  }

  /// A bar or a tube about Z.
  private cylinder_form(c: Cylinder): HTMLElement {
    const field = (key: keyof Cylinder, name: TextKey): HTMLElement =>
      h(
        "label",
        { class: "field small" },
        h("span", null, t(name)),
        this.input(
          String(c[key]),
          (v) => {
            const n = Number(v.replace(",", "."));
            if (Number.isFinite(n)) this.stock = stock_of_cylinder({ ...c, [key]: n });
            this.draw();
          },
          { inputmode: "decimal" },
        ),
      );
    return h(
      "div",
      { class: "bar-form" },
      field("diameter", "blank_diameter"),
      field("bore", "blank_bore"),
      field("from", "blank_from"),
      field("to", "blank_to"),
    );
  }

  private fixtures_form(): HTMLElement {
    const text = h(
      "textarea",
      {
        rows: String(Math.max(1, this.fixtures.length)),
        placeholder: "box:X0,Y0,Z0,X1,Y1,Z1",
        onchange: () => {
          this.fixtures = text.value
            .split("\n")
            .map((line) => line.trim())
            .filter((line) => line !== "");
          this.draw();
        },
      },
      this.fixtures.join("\n"),
    );
    return h("label", { class: "field" }, h("span", null, t("fixtures")), text);
  }

  private files_form(): HTMLElement | false {
    if (!this.files.length) return false;
    const select = h(
      "select",
      {
        onchange: () => {
          if (select.value) void this.take_file(select.value);
        },
      },
      option("", "…", true),
      ...this.files.map((f) => option(f, f, false)),
    );
    return h("label", { class: "field" }, h("span", null, t("tools_from_file")), select);
  }

  private tool_form(x: Tool): HTMLElement {
    const more = sizes_of[x.kind] ?? ["corner", "angle", "tip"],
      turns = x.kind === "turning";
    const changed = (): void => {
      delete x.by_offset; // it is no longer what the offset table says
      this.inserts = this.inserts.filter((i) => i.tool !== x.number);
      this.draw();
    };
    const point = h(
      "select",
      {
        "aria-label": t("tip_number"),
        title: t("tip_number"),
        onchange: () => {
          x.points = point.value;
          changed();
        },
      },
      ...tips.map(([points, number]) => option(points, `${points} (${number})`, points === x.points)),
    );
    const select = h(
      "select",
      {
        "aria-label": t("kind"),
        onchange: () => {
          x.kind = select.value;
          if (x.kind === "turning") x.points ??= "-x-z";
          changed();
        },
      },
      ...kinds.map((k) => option(k, t(`kind_${k}` as TextKey), k === x.kind)),
    );
    const fields = sizes
      .filter((s) => [turns ? "" : "diameter", "flute_length", "length", ...more].includes(s))
      .map((s) =>
        h(
          "label",
          { class: "field small" },
          h("span", null, t(turns && s === "corner" ? "nose_radius" : s)),
          this.input(
            x[s] === undefined ? "" : String(x[s]),
            (v) => {
              if (v.trim() === "") delete x[s];
              else x[s] = Number(v.replace(",", "."));
              changed();
            },
            { inputmode: "decimal" },
          ),
        ),
      );
    return h(
      "fieldset",
      { class: x.known === false ? "tool-form unknown" : "tool-form" },
      h("legend", null, `T${x.number} ${x.name ?? ""}`),
      tool_picture(with_inserts(shape_of(x), this.inserts), `T${x.number}`, 44, 96),
      h(
        "div",
        { class: "tool-fields" },
        x.known === false && h("p", { class: "hint" }, t("shape_unknown")),
        h("div", { class: "row" }, select, turns && point, h("span", { class: "dim from" }, x.from ?? "")),
        h("div", { class: "fields" }, ...fields),
      ),
    );
  }

  private input(v: string, changed: (v: string) => void, more: Record<string, unknown> = {}): HTMLInputElement {
    const e = h("input", { type: "text", value: v, ...more, onchange: () => changed(e.value) });
    return e;
  }

  private run(): void {
    const r = Number(this.resolution.replace(",", "."));
    const tools = this.tools.map(({ from: _, known: __, ...shape }) => shape);
    void this.app.run_cut({
      stock: this.stock,
      tools,
      ...(this.fixtures.length ? { fixtures: this.fixtures } : {}),
      ...(r > 0 ? { resolution: r } : {}),
    });
  }

  private draw_told(part: number | null): void {
    const { app } = this,
      c = app.cut;
    const bar =
      part !== null && app.cutting ? h("progress", { max: 1, value: part, "aria-label": t("cutting") }) : null;
    fill(
      this.told,
      bar,
      c &&
        !c.error &&
        h(
          "dl",
          { class: "facts" },
          ...fact(t("stock"), volume_told(c.stock)),
          ...fact(t("removed"), volume_told(c.removed)),
          ...fact(t("left"), volume_told(c.left)),
          ...(c.turned ? [] : fact(t("cell"), length_told(c.resolution))),
          ...(c.threads ?? []).flatMap((x) => fact(t("thread_of", { tool: x.tool }), thread_told(x))),
        ),
      this.part &&
        h(
          "p",
          { class: "note" },
          t(this.part.section ? "turned_told" : "part_told", {
            left: volume_told(this.part.left),
            triangles: short(this.part.triangles),
            cell: length_told(this.part.cell),
          }),
        ),
      ...(c?.notes ?? []).map((note) => h("p", { class: "note" }, note)),
      ...this.hit.rows(),
    );
  }
}

/// "Ø 24.000 – Ø 21.546, lead 2.000 mm, 8 passes".
function thread_told(x: CutThread): string {
  const crest = x.crest ?? x.from.diameter;
  return t("thread_told", {
    crest: `${diameter_sign} ${length(crest)}`,
    root: `${diameter_sign} ${length(x.to.diameter)}`,
    lead: x.lead === undefined ? "–" : length_told(x.lead),
    passes: x.passes,
  });
}
