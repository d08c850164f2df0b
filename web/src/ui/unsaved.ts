// Offers the text that an earlier visit, or another tab, left unsaved when its program is opened.
import type { App } from "../model/app";
import type { KeptText } from "../model/unsaved";
import { language, t } from "../texts/texts";
import { ask } from "./dialog";

export function offer_unsaved(app: App): void {
  app.unsaved.on_offer.on((all) => void offer(app, all));
}

async function offer(app: App, all: KeptText[]): Promise<void> {
  for (const kept of all) {
    const when = new Date(kept.at).toLocaleString(language() === "ru" ? "ru-RU" : "en-GB", {
      dateStyle: "medium",
      timeStyle: "short",
    });
    const changed = kept.digest !== app.digest ? ` ${t("unsaved_kept_changed")}` : "";
    const choice = await ask(t("unsaved_kept"), t("unsaved_kept_long", { file: kept.file, when }) + changed, [
      ["take", t("unsaved_take")],
      ["later", t("unsaved_later")],
      ["discard", t("unsaved_discard")],
    ]);
    if (app.opened?.file !== kept.file) return; // another program was opened meanwhile
    if (choice === "discard") app.unsaved.drop(kept);
    if (choice === "take") return app.take_unsaved(kept);
  }
}
