// Tells that the file was changed on the disk, above the text: take it, keep the text of the page, compare the two.
import type { App } from "../model/app";
import type { DiskChange, DiskWatch } from "../model/disk_watch";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";
import { save } from "./save";

export function disk_notice(app: App, watch: DiskWatch, compare: (name: string, text: string) => void): HTMLElement {
  const e = h("div", { class: "disk-notice", role: "status", "aria-live": "polite", hidden: true });
  const draw = (change: DiskChange | null): void => {
    e.hidden = !change;
    if (!change) return;
    const { file } = change;
    if (change.text === null) {
      return fill(
        e,
        h("span", null, t("gone_from_disk", { file })),
        button(t("save_again"), () => void save(app), { class: "main" }),
      );
    }
    fill(
      e,
      h("span", null, t(app.dirty ? "changed_on_disk_dirty" : "changed_on_disk", { file })),
      button(t("take_disk"), () => void app.changed_on_disk(change, true), { class: app.dirty ? "" : "main" }),
      button(t("keep_mine"), () => void app.changed_on_disk(change, false)),
      button(t("compare_disk"), () => compare(t("on_the_disk", { file }), change.text)),
    );
  };
  watch.on_change.on(draw);
  for (const s of [app.on_dirty]) s.on(() => draw(watch.change));
  on_language(() => draw(watch.change));
  return e;
}
