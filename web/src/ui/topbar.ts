// The top bar: the open program and its control, machine and set-up; language, light, shop mode.
import type { App } from "../model/app";
import { remember, remembered } from "../model/memory";
import { choose_unit, unit } from "../model/units";
import { SetupChoice } from "../setup/setup_choice";
import { language, on_language, set_language, t } from "../texts/texts";
import { button, fill, h, option } from "./dom";
import { clock, short } from "./figures";
import { icon } from "./icons";
import { save_report } from "./report_file";

/// A missing verb has no button: a report has no files, runs nothing and compares nothing.
export interface TopbarVerbs {
  files?(): void;
  sheet(): void;
  edit?(): void;
  compare?(): void;
  setup?(): void;
  licences?(): void;
  help(): void;
  operator?(): void;
  theme(dark: boolean): void;
}

export class Topbar {
  readonly element = h("header", { class: "topbar", role: "banner" });
  private bar = h("div", { class: "progress", role: "progressbar", "aria-valuemin": "0", "aria-valuemax": "100" });
  private told = h("span", { class: "run-told" });
  private dark = remembered("dark", matchMedia("(prefers-color-scheme: dark)").matches);
  private shop = remembered("shop", false);
  private setup_choice: SetupChoice | null;

  constructor(
    private app: App,
    private verbs: TopbarVerbs,
  ) {
    this.setup_choice = verbs.files ? new SetupChoice(app, () => verbs.setup?.()) : null;
    const draw = (): void => this.draw();
    app.on_opened.on(draw);
    app.on_opening.on(draw);
    app.on_line.on(draw);
    app.on_done.on(draw);
    on_language(draw);
    let was_running = false;
    app.on_run.on(() => {
      if (was_running !== app.running) this.draw();
      else this.draw_progress();
      was_running = app.running;
    });
    this.apply();
    draw();
  }

  private draw(): void {
    const { app, verbs } = this,
      o = app.opened;
    fill(
      this.element,
      verbs.files && button(icon("menu"), verbs.files, { class: "icon", title: t("files"), "aria-label": t("files") }),
      h("span", { class: "brand" }, "Kadr"),
      h("span", { class: "file", title: o?.file ?? "" }, o?.file ?? t("no_program")),
      o &&
        (verbs.files
          ? this.choices()
          : h("span", { class: "note" }, `${o.control.name}${o.machine ? ` · ${o.machine}` : ""}`)),
      o &&
        verbs.files &&
        (app.running
          ? button(t("stop"), () => app.stop(), { class: "stop" })
          : button(t("run"), () => void app.run_again(), { class: "main", title: t("run_long") })),
      this.told,
      h("span", { class: "grow" }),
      button(t("sheet"), verbs.sheet, { disabled: !app.done }),
      verbs.files && button(t("report"), () => void save_report(app), { disabled: !app.done, title: t("report_long") }),
      verbs.edit && button(t("edit_program"), verbs.edit, { disabled: !o }),
      verbs.compare && button(t("compare"), verbs.compare, { disabled: !app.done }),
      verbs.licences && button(t("licences"), verbs.licences),
      verbs.operator && button(t("op_enter"), verbs.operator, { title: t("op_enter_long"), "aria-keyshortcuts": "O" }),
      button("?", verbs.help, { class: "icon", title: t("keys"), "aria-label": t("keys") }),
      button(
        icon(this.dark ? "sun" : "moon"),
        () => {
          this.dark = !this.dark;
          this.apply();
          this.draw();
        },
        { class: "icon", title: t("theme"), "aria-label": t("theme") },
      ),
      button(
        t("shop"),
        () => {
          this.shop = !this.shop;
          this.apply();
          this.draw();
        },
        { "aria-pressed": this.shop, title: t("shop_long") },
      ),
      this.units(),
      this.languages(),
      this.bar,
    );
    this.draw_progress();
  }

  private choices(): HTMLElement {
    const { app } = this,
      o = app.opened!;
    const controls = h(
      "select",
      {
        class: o.control.guessed ? "is-guess" : "",
        "aria-label": t("control"),
        title: o.control.guessed ? `${t("guessed")}: ${o.control.why ?? ""}` : t("control"),
        onchange: () => void app.run_again({ ...app.choice, control: controls.value || undefined }),
      },
      option("", t("guess"), false),
      ...(app.hello?.controls ?? []).map((c) => option(c.id, c.name, c.id === o.control.id)),
    );
    const machines = h(
      "select",
      {
        "aria-label": t("machine"),
        title: o.machine ? t("machine") : t("machine_none"),
        onchange: () => void app.run_again({ ...app.choice, machine: machines.value || undefined }),
      },
      option("", t("no_machine"), !o.machine),
      ...[...new Set([...(app.hello?.machines ?? []), ...(o.machine ? [o.machine] : [])])].map((m) =>
        option(m, m, m === o.machine),
      ),
    );
    return h(
      "span",
      { class: "choices" },
      controls,
      o.control.guessed && h("span", { class: "guessed", title: o.control.why ?? "" }, t("guessed")),
      machines,
      this.setup_choice?.element(),
    );
  }

  /// The unit of figures; programs in inches start with inches.
  private units(): HTMLElement {
    const one = (its: "mm" | "inch"): HTMLElement =>
      button(t(its), () => choose_unit(its), { "aria-pressed": unit() === its, title: t("units_long") });
    return h("span", { class: "switch", role: "group", "aria-label": t("units") }, one("mm"), one("inch"));
  }

  private languages(): HTMLElement {
    const one = (lang: "en" | "ru", text: string): HTMLElement =>
      button(
        text,
        () => {
          if (language() !== lang) {
            set_language(lang);
            void this.app.speak(lang);
          }
        },
        { "aria-pressed": language() === lang, lang },
      );
    return h("span", { class: "switch", role: "group", "aria-label": t("language") }, one("en", "EN"), one("ru", "РУ"));
  }

  private draw_progress(): void {
    const { app } = this,
      part = app.running ? (app.progress?.part ?? 0) : 0;
    this.bar.style.width = `${part * 100}%`;
    this.bar.setAttribute("aria-valuenow", String(Math.round(part * 100)));
    this.bar.setAttribute("aria-label", t("running"));
    const d = app.done;
    this.told.title = d ? (this.told.textContent ?? "") : "";
    this.told.className = `run-told ${app.running ? "running" : (d?.state ?? "")}`;
    this.told.textContent = app.running
      ? t("running_at", { blocks: short(app.progress?.blocks ?? 0), time: clock(app.progress?.seconds ?? 0) })
      : d
        ? `${t(d.state === "ended" ? "state_ended" : d.state === "stopped" ? "state_stopped" : "state_cancelled")} · ${clock(d.seconds)}`
        : "";
  }

  set_dark(dark: boolean): void {
    if (dark === this.dark) return;
    this.dark = dark;
    this.apply();
  }

  private apply(): void {
    document.documentElement.dataset.theme = this.dark ? "dark" : "light";
    document.documentElement.dataset.shop = String(this.shop);
    remember("dark", this.dark);
    remember("shop", this.shop);
    this.verbs.theme(this.dark);
    dispatchEvent(new Event("resize")); // canvases measure their size and read their colours again
  }
}
