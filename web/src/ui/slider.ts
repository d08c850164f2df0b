// The time slider: a bar over the whole machine time with its marks. The bar is an ARIA slider; marks are painted
// above it and can be clicked.
import type { App } from "../model/app";
import { clamp, clusters } from "../model/time";
import type { TimeWindow } from "../model/time_window";
import type { Mark } from "../protocol/types";
import { on_language, t, type TextKey } from "../texts/texts";
import { fill, h } from "./dom";
import { clock } from "./figures";

const signs: Partial<Record<Mark["kind"], string>> = {
  tool: "T",
  alarm: "!",
  warning: "!",
  stop: "■",
  optional_stop: "□",
  zero: "0",
  message: "i",
  end: "■",
};

export class TimeSlider {
  readonly element = h("div", { class: "slider", role: "slider", tabindex: "0", "aria-valuemin": "0" });
  private done_bar = h("div", { class: "slider-done" });
  private knob = h("div", { class: "slider-knob" });
  private loop_bar = h("div", { class: "slider-loop", hidden: true });
  private marks = h("div", { class: "slider-marks" });

  constructor(
    private app: App,
    private shown: TimeWindow,
  ) {
    this.element.append(h("div", { class: "slider-track" }, this.done_bar, this.loop_bar), this.marks, this.knob);
    app.on_instant.on(() => this.draw());
    shown.on_change.on(() => {
      this.draw_marks();
      this.draw();
    });
    for (const s of [app.on_run, app.on_done, app.on_cut])
      s.on(() => {
        this.draw_marks();
        this.draw();
      });
    on_language(() => {
      this.draw_marks();
      this.draw();
    });
    new ResizeObserver(() => {
      this.draw_marks();
      this.draw();
    }).observe(this.element);
    this.drag();
    this.draw();
  }

  show_loop(loop: [number, number] | null): void {
    this.loop_bar.hidden = !loop;
    if (!loop) return;
    const [from, to] = loop.map((at) => clamp(this.shown.share_of(at), 0, 1)) as [number, number];
    this.loop_bar.style.left = `${from * 100}%`;
    this.loop_bar.style.width = `${(to - from) * 100}%`;
  }

  private draw(): void {
    const { instant, seconds } = this.app,
      share = this.shown.share_of(instant),
      part = clamp(share, 0, 1) * 100;
    this.done_bar.style.width = `${part}%`;
    this.knob.style.left = `${part}%`;
    this.knob.hidden = share < 0 || share > 1;
    this.element.setAttribute("aria-label", t("time"));
    this.element.setAttribute("aria-valuemax", seconds.toFixed(1));
    this.element.setAttribute("aria-valuenow", instant.toFixed(1));
    this.element.setAttribute("aria-valuetext", t("time_of", { at: clock(instant), all: clock(seconds) }));
  }

  private draw_marks(): void {
    const { app, shown } = this,
      width = this.element.clientWidth,
      inside = app.marks.filter((m) => shown.share_of(m.at) >= 0 && shown.share_of(m.at) <= 1);
    fill(
      this.marks,
      ...clusters(inside, shown.seconds, width, 12, shown.from).map((c) => {
        const names = c.marks
          .slice(0, 8)
          .map((m) => `${clock(m.at)}  ${t(`mark_${m.kind}` as TextKey)}${m.text ? `: ${m.text}` : ""}`)
          .join("\n");
        const more = c.marks.length > 8 ? `\n… +${c.marks.length - 8}` : "";
        const e = h("div", { class: `mark ${c.kind}`, title: names + more }, signs[c.kind] ?? "·");
        e.style.left = `${shown.share_of(c.at) * 100}%`;
        e.addEventListener("pointerdown", (event) => {
          event.stopPropagation();
          app.seek(c.at);
          this.element.focus();
        });
        return e;
      }),
    );
  }

  private drag(): void {
    const go = (e: PointerEvent): void => {
      const box = this.element.getBoundingClientRect();
      this.app.seek(this.shown.instant_at((e.clientX - box.left) / box.width));
    };
    this.element.addEventListener("pointerdown", (e) => {
      this.element.setPointerCapture(e.pointerId);
      go(e);
    });
    this.element.addEventListener("pointermove", (e) => {
      if (this.element.hasPointerCapture(e.pointerId)) go(e);
    });
  }
}
