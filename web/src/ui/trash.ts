// "Trash": what was deleted on the page, the latest first; each file is put back or deleted for good.
import type { App } from "../model/app";
import { folder_part } from "../model/file_names";
import type { TrashEntry } from "../protocol/types";
import { t } from "../texts/texts";
import { ask, open_dialog } from "./dialog";
import { button, fill, h } from "./dom";
import { bytes } from "./figures";
import { told_of } from "./file_actions";
import { toast } from "./toast";

/// `show`: the list of a folder has changed.
export async function show_trash(app: App, show: (folder: string) => void): Promise<void> {
  const body = h("div", { class: "trash", role: "status", "aria-live": "polite" });
  const empty = button(t("trash_empty"), () => void drop(""), { disabled: true });
  const may = app.hello?.may_change === true;

  async function draw(): Promise<void> {
    const { entries, more } = await app.client.ask("trash", {});
    empty.disabled = !may || !entries.length;
    fill(
      body,
      entries.length > 0 && table(entries),
      !entries.length && h("p", { class: "note" }, t("trash_is_empty")),
      more && h("p", { class: "note" }, t("more_files")),
    );
  }

  const table = (entries: TrashEntry[]): HTMLElement =>
    h(
      "table",
      { class: "list" },
      h("thead", null, h("tr", null, ...[t("trash_file"), t("trash_when"), t("trash_size"), ""].map(head))),
      h("tbody", null, ...entries.map(row)),
    );
  const head = (text: string): HTMLElement => h("th", { scope: "col", class: "text" }, text);
  const row = (one: TrashEntry): HTMLElement =>
    h(
      "tr",
      null,
      h("td", { class: "text" }, one.file),
      h("td", { class: "text" }, one.deleted ? new Date(one.deleted * 1000).toLocaleString() : "–"),
      h("td", null, bytes(one.size)),
      h(
        "td",
        { class: "text" },
        h(
          "div",
          { class: "row" },
          button(t("trash_back"), () => void back(one), {
            disabled: !may,
            "aria-label": `${t("trash_back")}: ${one.file}`,
          }),
          button(t("trash_delete"), () => void drop(one.trash, one.file), {
            disabled: !may,
            "aria-label": `${t("trash_delete")}: ${one.file}`,
          }),
        ),
      ),
    );

  async function back(one: TrashEntry): Promise<void> {
    try {
      await app.client.ask("restore", { trash: one.trash, file: one.file });
      show(folder_part(one.file));
      toast(t("restored", { file: one.file }));
      await draw();
    } catch (e) {
      app.on_error.emit(told_of(e, one.file));
    }
  }

  /// Deletes one file, or all of them, for good.
  async function drop(trash: string, file = ""): Promise<void> {
    const name = file ? t("trash_delete") : t("trash_empty");
    const choice = await ask(name, file ? t("trash_delete_long", { file }) : t("trash_empty_long"), [
      ["delete", name],
      ["cancel", t("cancel")],
    ]);
    if (choice !== "delete") return;
    try {
      await app.client.ask("empty_trash", trash ? { trash } : {});
      await draw();
    } catch (e) {
      app.tell(e);
    }
  }

  try {
    await draw();
    open_dialog(t("trash"), body, { wide: true, tools: empty });
  } catch (e) {
    app.tell(e);
  }
}
