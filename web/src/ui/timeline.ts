// Slider, play buttons and speed strip: the lower edge of the page.
import type { App } from "../model/app";
import { slider_of, times_of } from "../model/time";
import { TimeWindow } from "../model/time_window";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";
import { clock } from "./figures";
import { icon, type IconName } from "./icons";
import type { Player } from "./player";
import { TimeSlider } from "./slider";
import { SpeedStrip } from "./strip";

/// The wheel zooms about the mouse, with Shift it moves; the arrows up and down zoom about the slider.
function listen_zoom(e: HTMLElement, app: App, shown: TimeWindow): void {
  e.addEventListener(
    "wheel",
    (event) => {
      if (!app.done) return;
      event.preventDefault();
      const box = e.getBoundingClientRect(),
        way = event.deltaY || event.deltaX;
      if (event.shiftKey || !event.deltaY) shown.move(0.1 * Math.sign(way));
      else shown.zoom(way > 0 ? 1.25 : 0.8, shown.instant_at((event.clientX - box.left) / box.width));
    },
    { passive: false },
  );
  e.addEventListener("keydown", (event) => {
    if (event.key !== "ArrowUp" && event.key !== "ArrowDown") return;
    event.preventDefault();
    event.stopPropagation();
    shown.zoom(event.key === "ArrowUp" ? 0.5 : 2, app.instant);
  });
}

export function timeline(app: App, player: Player, step_tool: (way: 1 | -1) => void): HTMLElement {
  const controls = h("div", { class: "play" }),
    told = h("span", { class: "clock" }),
    hint = h("span", { class: "strip-hint" });
  const shown = new TimeWindow(() => app.seconds);
  const slider = new TimeSlider(app, shown);
  const strip = new SpeedStrip(
    app,
    shown,
    (loop) => player.set_loop(loop),
    (text) => {
      hint.textContent = text;
    },
  );
  const pace = h("input", {
    type: "range",
    min: "0",
    max: "1",
    step: "0.01",
    class: "pace",
    oninput: () => player.set_times(times_of(Number(pace.value))),
  });
  const pace_told = h("span", { class: "pace-told" });

  const tell = (): void => {
    told.textContent = `${clock(app.instant)} / ${clock(app.seconds)}`;
  };
  const draw = (): void => {
    pace.value = String(slider_of(player.times));
    pace.setAttribute("aria-label", t("pace"));
    pace.title = t("pace");
    pace_told.textContent = `${player.times}×`;
    const b = (sign: IconName, title: string, f: () => void): HTMLElement =>
      button(icon(sign), f, { class: "icon", title, "aria-label": title, disabled: !app.done });
    fill(
      controls,
      b("tool_back", t("tool_before"), () => step_tool(-1)),
      b("back", t("block_before"), () => app.step(-1)),
      b(player.playing ? "pause" : "play", player.playing ? t("pause") : t("play"), () => player.toggle()),
      b("on", t("block_after"), () => app.step(1)),
      b("tool_on", t("tool_after"), () => step_tool(1)),
      pace,
      pace_told,
      told,
      player.loop &&
        button(`${clock(player.loop[0])}–${clock(player.loop[1])} ×`, () => player.set_loop(null), {
          title: t("loop_off"),
        }),
      h("span", { class: "grow" }),
      hint,
      b("zoom_out", t("time_farther"), () => shown.zoom(2, app.instant)),
      b("zoom_in", t("time_closer"), () => shown.zoom(0.5, app.instant)),
      !shown.is_whole && button(t("time_all"), () => shown.show_all()),
    );
    slider.show_loop(player.loop);
    tell();
  };
  player.changed.on(draw);
  app.on_done.on(draw);
  app.on_opening.on(draw);
  app.on_instant.on(tell);
  app.on_run.on(tell);
  on_language(draw);
  draw();
  shown.on_change.on(draw);
  app.on_instant.on((at) => shown.follow(at));
  let file = "";
  app.on_opening.on((name) => {
    if (name !== file) shown.show_all();
    file = name;
  });
  for (const e of [slider.element, strip.element]) listen_zoom(e, app, shown);
  return h("section", { class: "timeline" }, slider.element, strip.element, controls);
}
