// The 3D view with its tools: views, colours, filters, section, measuring, picture; its messages are in the corners.
import type { App } from "../model/app";
import { dark, is_ramp, light } from "../scene/colours";
import { Scene, usual_filter, type Point, type SceneFilter, type SceneVertex, type View } from "../scene/scene";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";
import { short } from "./figures";
import { legend } from "./legend";
import { axes_of, diameters_of, ProgramFlags } from "./program_flags";
import { SceneBar } from "./scene_bar";
import { measured_told, motion_told } from "./scene_words";
import { SectionBar } from "./section_bar";
import { toast } from "./toast";
import { ViewCube } from "./view_cube";

const worth_telling = 5000; // segments: in a shorter path nothing visible is left out

export class ScenePane {
  readonly element = h("section", { class: "pane scene" });
  readonly scene: Scene | null;
  private bar: SceneBar;
  private section: SectionBar;
  private told = h("div", { class: "scene-told", "aria-live": "polite" });
  private thinned_told = h("div", { class: "scene-thinned" });
  private empty_told = h("div", { class: "scene-empty" });
  private old_told = h("div", { class: "scene-old", "aria-live": "polite" });
  private legend = h("div", { class: "scene-legend" });
  private flags: ProgramFlags;
  private cube = new ViewCube(
    (v) => this.scene?.view(v),
    (towards) => this.scene?.look_from(towards),
  );
  private tip = h("div", { class: "scene-tip", hidden: true });
  private measuring = false;
  private touched: ((place: Point, normal: Point) => void) | null = null;
  private counted: [number, number] = [0, 0]; // drawn segments, and all
  private filter = usual_filter;
  private size: [number, number] = [0, 0]; // of the pane, px

  constructor(
    private app: App,
    picked: (v: SceneVertex) => void,
  ) {
    this.flags = new ProgramFlags(app);
    this.bar = new SceneBar(app, () => this.scene, {
      filter: () => this.filter,
      set_filter: (f) => this.set_filter(f),
      coloured: () => this.draw_legend(),
    });
    this.section = new SectionBar(
      app,
      () => this.scene,
      () => [
        button(t("measure"), () => this.toggle_measure(), {
          "aria-pressed": this.measuring,
          title: `${t("measure")} (M)`,
        }),
        button("PNG", () => void this.save_picture(), { title: t("save_picture") }),
        this.thinned_told,
      ],
    );
    const host = h("div", { class: "scene-host" });
    this.element.append(
      host,
      this.flags.element,
      this.legend,
      this.cube.element,
      this.bar.element,
      this.section.element,
      this.told,
      this.old_told,
      this.empty_told,
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
    app.on_opened.on((o) => this.section.show_lathe(o.control.lathe ?? false));
    app.on_part_told.on((p) =>
      this.scene?.setTurned(
        p?.section ? { section: p.section, section_y: p.section_y ?? [], edges: p.edges ?? [] } : null,
      ),
    );
    const sizes = new ResizeObserver(() => this.measure());
    for (const e of [this.element, this.bar.element]) sizes.observe(e);
    this.bar.apply();
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

  /// The path belongs to the text before the last change: says so, after the time in which a short program runs.
  tell_old(old: boolean): void {
    this.element.classList.toggle("old", old);
    this.old_told.textContent = old ? t("path_old") : "";
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
    const { app } = this;
    try {
      return new Scene(host, {
        pick: (v) => {
          if (v) picked(v);
        },
        hover: (v, x, y) => this.hover(v, x, y),
        touched: (place, normal) => this.touched?.(place, normal),
        measured: (m) => {
          this.told.textContent = measured_told(
            m,
            this.measuring ? t("measure_how") : "",
            diameters_of(app),
            axes_of(app),
          );
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

  /// Sizes are read when they change: to ask for them with each picture would lay the page out each time.
  private measure(): void {
    const { element: bar } = this.bar;
    this.legend.style.top = `${bar.offsetTop + bar.offsetHeight + 8}px`;
    this.size = [this.element.clientWidth, this.element.clientHeight];
    this.scene?.redraw();
  }
  private turn(view: View): void {
    this.cube.turn(view);
    this.flags.place(view, ...this.size);
  }

  private mark(): void {
    this.flags.mark(this.scene);
    this.draw_legend();
    this.scene?.redraw();
  }

  private draw_legend(): void {
    const { scene } = this,
      { colour } = this.bar;
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

  private hover(v: SceneVertex | null, x: number, y: number): void {
    this.tip.hidden = !v;
    if (!v) return;
    this.tip.textContent = motion_told(v, diameters_of(this.app), axes_of(this.app));
    const box = this.element.getBoundingClientRect();
    this.tip.style.left = `${Math.min(x + 14, box.width - 250)}px`;
    this.tip.style.top = `${Math.min(y + 14, box.height - 70)}px`;
  }

  private draw(): void {
    this.element.setAttribute("aria-label", t("view_3d"));
    this.empty_told.textContent = t("nothing_yet");
    this.empty_told.hidden = this.app.opened !== null || this.app.running;
    this.bar.draw();
    this.tell_thinned();
    this.section.draw();
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
