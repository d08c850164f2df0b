// The 3D view with its tools: views, colours, filters, section, measuring, picture; its messages are in the corners.
import { spline } from "../protocol/frames";
import { figure_places } from "../scene/boxes";
import { dark, is_ramp, light } from "../scene/colours";
import {
  Scene,
  type ColourBy,
  type Measured,
  type Point,
  type SceneFilter,
  type SceneVertex,
  type View,
} from "../scene/scene";
import type { App } from "../model/app";
import { remember, remembered } from "../model/memory";
import { on_language, t, type TextKey } from "../texts/texts";
import { button, fill, h, option } from "./dom";
import { filter_form } from "./filters";
import { feed_unit, length_unit } from "../model/units";
import { diameter_sign, is_diameter, no_diameters, widest, type Diameters } from "../model/diameters";
import { coordinate, feed, length, length_told, point_told, short } from "./figures";
import { Flags, flags_of } from "./flags";
import { legend } from "./legend";
import { icon } from "./icons";
import { toast } from "./toast";
import { ViewCube } from "./view_cube";

const colours: ColourBy[] = ["kind", "tool", "feed", "speed", "slowed", "time", "depth"];
const worth_telling = 5000; // segments: in a shorter path nothing visible is left out
const views = ["top", "front", "left", "right", "back", "bottom", "iso", "fit"] as const;

export class ScenePane {
  readonly element = h("section", { class: "pane scene" });
  readonly scene: Scene | null;
  private bar = h("div", { class: "scene-bar", role: "toolbar" });
  private below = h("div", { class: "scene-bar below" });
  private told = h("div", { class: "scene-told", "aria-live": "polite" });
  private thinned_told = h("div", { class: "scene-thinned" });
  private legend = h("div", { class: "scene-legend" });
  private flags = new Flags((time) => this.app.seek(time));
  private cube = new ViewCube(
    (v) => this.scene?.view(v),
    (towards) => this.scene?.look_from(towards),
  );
  private box: [Point, Point] | null = null; // extents, whose figures are at its edges
  private tip = h("div", { class: "scene-tip", hidden: true });
  private colour = remembered<ColourBy>("colour", "kind");
  private flat = remembered("orthographic", true);
  private measuring = false;
  private is_lathe = false;
  private touched: ((place: Point, normal: Point) => void) | null = null;
  private counted: [number, number] = [0, 0]; // drawn segments, and all
  private section: { axis: 0 | 1 | 2 | "half" | null; part: number; flip: boolean } = {
    axis: null,
    part: 0.5,
    flip: false,
  };
  filter: SceneFilter = {
    rapids: true,
    tools: null,
    depth: null,
    lines: null,
    hideDone: false,
    programmed: false,
    other: true,
    bounds: true,
    turned: true,
  };

  constructor(
    private app: App,
    picked: (v: SceneVertex) => void,
  ) {
    const host = h("div", { class: "scene-host" });
    this.element.append(
      host,
      this.flags.element,
      this.legend,
      this.cube.element,
      this.bar,
      this.below,
      this.told,
      this.tip,
    );
    this.scene = this.make(host, picked);
    for (const s of [app.on_done, app.on_opening, app.on_opened]) s.on(() => this.draw());
    on_language(() => {
      this.draw();
      this.mark();
    });
    app.on_done.on((done) => this.scene?.setZero(done.zero)); // before anything is positioned by it
    for (const s of [app.on_done, app.on_cut]) s.on(() => this.mark());
    app.on_opening.on(() => this.mark());
    app.on_opening.on(() => this.scene?.setJoints([]));
    app.on_done.on((done) => this.scene?.setJoints(done.joints));
    app.on_opened.on((o) => this.scene?.setBounds(o.bounds ?? null));
    app.on_opened.on((o) => this.show_lathe(o.control.lathe ?? false));
    app.on_part_told.on((p) =>
      this.scene?.setTurned(
        p?.section ? { section: p.section, section_y: p.section_y ?? [], edges: p.edges ?? [] } : null,
      ),
    );
    this.scene?.setColour(this.colour);
    this.scene?.setProjection(this.flat);
    this.scene?.setFilter(this.filter);
    this.draw();
  }

  /// Sends a click on the part to `touched`; null: no longer.
  ask_touch(touched: ((place: Point, normal: Point) => void) | null): void {
    if (this.measuring) this.toggle_measure();
    this.touched = touched;
    this.scene?.setMode(touched ? "touch" : "orbit");
    this.told.textContent = touched ? t("touch_how") : "";
  }

  toggle_measure(): void {
    this.touched = null;
    this.measuring = !this.measuring;
    this.scene?.setMode(this.measuring ? "measure" : "orbit");
    this.told.textContent = this.measuring ? t("measure_how") : "";
    this.draw();
  }
  leave(): void {
    if (this.measuring) this.toggle_measure();
  }
  toggle_rapids(): void {
    this.set_filter({ rapids: !this.filter.rapids });
  }
  picture(): Promise<Blob> {
    return this.scene ? this.scene.picture() : Promise.reject(new Error("no view"));
  }

  private make(host: HTMLElement, picked: (v: SceneVertex) => void): Scene | null {
    try {
      return new Scene(host, {
        pick: (v) => {
          if (v) picked(v);
        },
        hover: (v, x, y) => this.hover(v, x, y),
        touched: (place, normal) => this.touched?.(place, normal),
        measured: (m) => {
          this.told.textContent = this.measured(m);
        },
        turned: (view) => this.turn(view),
        thinned: (drawn, all) => {
          this.counted = [drawn, all];
          this.tell_thinned();
          this.draw_legend();
        },
      });
    } catch {
      host.append(h("p", { class: "note no-webgl" }, t("no_webgl"))); // source, state and times work without it
      return null;
    }
  }

  private tell_thinned(): void {
    const [drawn, all] = this.counted;
    this.thinned_told.textContent =
      drawn < all && all >= worth_telling ? t("thinned", { drawn: short(drawn), all: short(all) }) : "";
    this.thinned_told.title = t("thinned_long");
  }

  private turn(view: View): void {
    this.legend.style.top = `${this.bar.offsetTop + this.bar.offsetHeight + 8}px`;
    this.cube.turn(view);
    const { box } = this;
    if (box)
      this.flags.set(
        "figures",
        figure_places(box, (p) => view.place(p)?.[1] ?? -Infinity)
          .map((at, k) => ({ kind: "figure" as const, at, text: this.figure_told(box, k) }))
          .filter((_, k) => this.axes.includes("XYZ"[k]!)),
      );
    this.flags.place(view, this.element.clientWidth, this.element.clientHeight);
  }

  /// Along an axis in diameter programming the greatest diameter, else the size.
  private figure_told(box: [Point, Point], k: number): string {
    const is_wide = is_diameter("XYZ"[k]!, this.diameters);
    return is_wide
      ? `${diameter_sign} ${length_told(widest(box[0][k]!, box[1][k]!))}`
      : length_told(box[1][k]! - box[0][k]!);
  }
  private get diameters(): Diameters {
    return this.app.done?.diameters ?? no_diameters;
  }
  /// X, Y, Z of the program; a lathe may have no Y.
  private get axes(): string[] {
    const { axes } = this.app.done ?? {};
    return ["X", "Y", "Z"].filter((a) => !axes?.length || axes.includes(a));
  }

  /// Places the marks of the program that has been run.
  private mark(): void {
    const { app, scene } = this,
      box = app.done?.extents.cutting;
    this.box = box ? (box as [Point, Point]) : null;
    this.flags.set(
      "marks",
      scene && app.done ? flags_of(app.marks, app.done.seconds, (at) => scene.positionAt(at)) : [],
    );
    if (!box) this.flags.set("figures", []);
    this.draw_legend();
    scene?.redraw();
  }

  private draw_legend(): void {
    const { scene, colour } = this;
    const made =
      scene &&
      legend({
        by: colour,
        range: is_ramp(colour) ? scene.ranges()[colour] : null,
        kinds: scene.kinds(),
        tools: this.tools(),
        theme: document.documentElement.dataset.theme === "dark" ? dark : light,
      });
    fill(this.legend, made);
  }
  private tools(): { tool: number; name?: string }[] {
    const seen = new Map((this.app.done?.tools ?? []).map((x) => [x.tool, x]));
    return [...seen.values()];
  }

  private measured({ ends, distance }: Measured): string {
    const [a, b] = ends;
    if (!a) return this.measuring ? t("measure_how") : "";
    const named = (e: typeof a): string =>
      `${t(`anchor_${e.kind}`)}${e.radius ? ` R ${length(e.radius)}` : ""} (${t("line_n", { line: e.line })})`;
    const at = (p: Point): string => `${point_told(p, this.diameters, this.axes)} ${length_unit()}`;
    if (!b || !distance) return `${named(a)}: ${at(a.place)}\n${t("measure_next")}`;
    const d = distance.delta.map(Math.abs) as Point;
    const parts = `${point_told(d, this.diameters, this.axes, "Δ")} ${length_unit()}`;
    const angle = distance.angle === null ? "" : `   ∠ ${coordinate(distance.angle)}°`;
    return `${named(a)} – ${named(b)}\n${t("distance")} ${length_told(distance.distance)}   ${parts}${angle}`;
  }

  private hover(v: SceneVertex | null, x: number, y: number): void {
    this.tip.hidden = !v;
    if (!v) return;
    const kind = t(`motion_${Math.min(spline, v.kind)}` as TextKey);
    const radius = v.radius ? ` · R ${length(v.radius)}` : "",
      long = v.length ? ` · L ${length(v.length)}` : "";
    this.tip.textContent = [
      `${t("line_n", { line: v.line })} · ${kind}${radius}${long} · T${v.tool}`,
      `${point_told(v.at, this.diameters, this.axes)} ${length_unit()}`,
      `${v.feed ? `F ${feed(v.feed, 1)} · ` : ""}V ${feed(v.speed)} ${feed_unit()}`,
    ].join("\n");
    const box = this.element.getBoundingClientRect();
    this.tip.style.left = `${Math.min(x + 14, box.width - 250)}px`;
    this.tip.style.top = `${Math.min(y + 14, box.height - 70)}px`;
  }

  private draw(): void {
    this.element.setAttribute("aria-label", t("view_3d"));
    this.bar.setAttribute("aria-label", t("view_3d"));
    const look = h(
      "select",
      {
        "aria-label": t("colour_by"),
        title: t("colour_by"),
        onchange: () => {
          this.colour = look.value as ColourBy;
          remember("colour", this.colour);
          this.scene?.setColour(this.colour);
          this.draw_legend();
        },
      },
      ...colours.map((c) => option(c, t(`colour_${c}`), c === this.colour)),
    );
    fill(
      this.bar,
      ...views.map((v) => button(t(`view_${v}`), () => this.scene?.view(v), { title: t(`view_${v}_long`) })),
      look,
      button(
        t(this.flat ? "orthographic" : "perspective"),
        () => {
          this.flat = !this.flat;
          remember("orthographic", this.flat);
          this.scene?.setProjection(this.flat);
          this.draw();
        },
        { title: t("projection") },
      ),
      filter_form(this.app, this.filter, (f) => this.set_filter(f)),
    );
    this.tell_thinned();
    this.draw_section();
  }

  private draw_section(): void {
    const { section } = this,
      box = this.app.done?.extents.all,
      is_plane = section.axis !== null && section.axis !== "half";
    const change = (): void => this.cut_through();
    const axis = h(
      "select",
      {
        "aria-label": t("section"),
        title: t("section"),
        onchange: () => {
          section.axis = axis.value === "" ? null : axis.value === "half" ? "half" : (Number(axis.value) as 0 | 1 | 2);
          change();
          this.draw_section();
        },
      },
      option("", t("section_none"), section.axis === null),
      ...(this.is_lathe ? [option("half", t("section_half"), section.axis === "half")] : []),
      ...[0, 1, 2].map((i) => option(String(i), `${t("section")} ${"XYZ"[i]}`, section.axis === i)),
    );
    const at = h("input", {
      type: "range",
      min: "0",
      max: "1",
      step: "0.002",
      value: String(section.part),
      "aria-label": t("section_at"),
      oninput: () => {
        section.part = Number(at.value);
        change();
      },
    });
    fill(
      this.below,
      axis,
      is_plane && box && at,
      is_plane &&
        button(
          icon("flip"),
          () => {
            section.flip = !section.flip;
            change();
          },
          { class: "icon", title: t("section_flip"), "aria-label": t("section_flip") },
        ),
      is_plane && h("span", { class: "section-told" }),
      button(t("measure"), () => this.toggle_measure(), {
        "aria-pressed": this.measuring,
        title: `${t("measure")} (M)`,
      }),
      button("PNG", () => void this.save_picture(), { title: t("save_picture") }),
      this.thinned_told,
    );
    change();
  }

  /// A lathe's part is shown in half section, until the user chooses otherwise.
  private show_lathe(on: boolean): void {
    this.scene?.setLathe(on);
    if (on === this.is_lathe) return;
    this.is_lathe = on;
    this.section.axis = on ? "half" : null;
    this.draw_section();
  }

  private cut_through(): void {
    const { axis, part, flip } = this.section,
      box = this.app.done?.extents.all;
    if (axis === "half") return this.scene?.setHalf();
    if (axis === null || !box) return this.scene?.setSection(null, 0, false);
    const margin = 5,
      low = box[0][axis]! - margin,
      high = box[1][axis]! + margin; // mm: the blank is slightly larger than the path
    const at = low + part * (high - low);
    this.scene?.setSection(axis, at, flip);
    const told = this.below.querySelector(".section-told");
    if (told) told.textContent = `${"XYZ"[axis]} ${length_told(at)}`;
  }

  private set_filter(f: Partial<SceneFilter>): void {
    this.filter = { ...this.filter, ...f };
    this.scene?.setFilter(this.filter);
    if ("rapids" in f) this.draw();
  }

  private async save_picture(): Promise<void> {
    try {
      const address = URL.createObjectURL(await this.picture());
      h("a", { href: address, download: `${(this.app.opened?.file ?? "kadr").replace(/.*\//, "")}.png` }).click();
      setTimeout(() => URL.revokeObjectURL(address), 10_000);
    } catch {
      toast(t("no_picture"), true);
    }
  }
}
