// The speed strip below the slider: the actual speed of the machine, and the programmed feed.
import uPlot from "uplot";
import type { App } from "../model/app";
import { debounce } from "../model/latest";
import { top_of, type TimeWindow } from "../model/time_window";
import { on_language, t } from "../texts/texts";
import { h } from "./dom";
import { feed_unit } from "../model/units";
import { feed, short } from "./figures";

export class SpeedStrip {
  readonly element = h("div", { class: "strip" });
  private here = h("div", { class: "strip-here", hidden: true });
  private plot: uPlot | null = null;
  private redraw = debounce(250, () => this.draw(), 1500);

  /// `selected`: an interval of time was drawn with the mouse; `hint` describes what is under it.
  constructor(
    private app: App,
    private shown: TimeWindow,
    private selected: (loop: [number, number] | null) => void,
    private hint: (text: string) => void,
  ) {
    this.element.append(this.here);
    app.on_done.on(() => this.draw());
    app.on_opening.on(() => {
      if (!app.done) this.draw(); // a program that runs again is shown as before until the new path arrives
    });
    shown.on_change.on(() => this.draw());
    app.on_path.on(() => this.redraw());
    app.on_instant.on(() => this.place());
    on_language(() => this.draw());
    window.addEventListener("resize", () => this.redraw());
    new ResizeObserver(() => this.redraw()).observe(this.element);
  }

  private draw(): void {
    this.plot?.destroy();
    this.plot = null;
    this.here.hidden = true;
    const width = this.element.clientWidth,
      height = this.element.clientHeight,
      { from, seconds } = this.shown;
    if (!this.app.path.vertices || width < 50 || height < 20 || !(seconds > 0)) return;
    const b = this.app.path.bins(from, from + seconds, Math.max(50, Math.floor(width)));
    const top = Math.max(top_of(b.greatest), top_of(b.feed)) * 1.05;
    const style = getComputedStyle(this.element),
      colour = (name: string): string => style.getPropertyValue(name).trim();
    this.plot = new uPlot(
      {
        width,
        height,
        padding: [4, 0, 0, 0],
        legend: { show: false },
        scales: { x: { time: false, range: [from, from + seconds] }, y: { range: [0, top] } },
        axes: [{ show: false }, { show: false }],
        cursor: { y: false, points: { show: false }, drag: { x: true, y: false, setScale: false } },
        select: { show: true, left: 0, top: 0, width: 0, height: 0 },
        series: [
          {},
          this.series(t("fastest"), colour("--speed"), colour("--speed-fill")),
          this.series(t("slowest"), colour("--speed-low")),
          this.series("F", colour("--feed"), undefined, [4, 3]),
        ],
        hooks: {
          setSelect: [
            (u) => {
              if (u.select.width > 3)
                this.selected([u.posToVal(u.select.left, "x"), u.posToVal(u.select.left + u.select.width, "x")]);
            },
          ],
          setCursor: [
            (u) => {
              const i = u.cursor.idx;
              this.hint(
                i === null || i === undefined
                  ? ""
                  : t("strip_at", { speed: feed(b.greatest[i]), feed: feed(b.feed[i]), unit: feed_unit() }),
              );
            },
          ],
          ready: [
            (u) =>
              u.over.addEventListener("click", () => {
                if (u.select.width <= 3 && u.cursor.left !== undefined && u.cursor.left >= 0) {
                  this.selected(null);
                  this.app.seek(u.posToVal(u.cursor.left, "x"));
                }
              }),
          ],
        },
      },
      [[...b.at], gaps(b.greatest), gaps(b.least), gaps(b.feed)],
      this.element,
    );
    this.place();
  }

  private series(label: string, stroke: string, fill?: string, dash?: number[]): uPlot.Series {
    return {
      label,
      stroke,
      fill,
      dash,
      width: 1,
      points: { show: false },
      spanGaps: false,
      value: (_u, v) => short(v),
    };
  }

  /// An element of its own: the plot is not drawn again for every instant.
  private place(): void {
    const share = this.shown.share_of(this.app.instant);
    this.here.style.transform = `translateX(${share * this.element.clientWidth}px)`;
    this.here.hidden = !this.plot || share < 0 || share > 1;
  }
}

/// Without motion there is no speed: a gap, which uPlot represents by null.
const gaps = (v: Float64Array): (number | null)[] => Array.from(v, (x) => (Number.isNaN(x) ? null : x));
