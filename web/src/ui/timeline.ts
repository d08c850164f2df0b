// Slider, play buttons and speed strip: the lower edge of the page.
import type { App } from "../model/app";
import { slider_of, times_of } from "../model/time";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";
import { clock } from "./figures";
import { icon, type IconName } from "./icons";
import type { Player } from "./player";
import { TimeSlider } from "./slider";
import { SpeedStrip } from "./strip";

export function timeline(app: App, player: Player, step_tool: (way: 1 | -1) => void): HTMLElement {
  const controls = h("div", { class: "play" }),
    told = h("span", { class: "clock" }),
    hint = h("span", { class: "strip-hint" });
  const slider = new TimeSlider(app);
  const strip = new SpeedStrip(
    app,
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
  return h("section", { class: "timeline" }, slider.element, strip.element, controls);
}
