// Shows that the connection to the session is lost, and that the page tries to reconnect.
import type { App } from "../model/app";
import { alone } from "../protocol/way";
import { on_language, t } from "../texts/texts";
import { h } from "./dom";

export function banner(app: App): HTMLElement {
  const e = h("div", { class: "banner", role: "alert", hidden: true });
  let line = "connecting",
    ever = false;
  const draw = (): void => {
    e.hidden = line === "open" || (!ever && line === "connecting");
    e.textContent =
      line === "refused"
        ? t("refused")
        : ever
          ? t(alone ? "alone_lost" : "lost")
          : t(alone ? "alone_starts" : "no_server");
  };
  app.on_line.on((l) => {
    if (l === "open") ever = true;
    if (l !== "connecting" || line === "open") line = l; // a try in between is not reported
    draw();
  });
  on_language(draw);
  return e;
}
