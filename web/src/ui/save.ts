// Saving: the session refuses it if another client has changed the file; then the user decides.
import { Refused } from "../protocol/client";
import type { App } from "../model/app";
import { t } from "../texts/texts";
import { ask } from "./dialog";
import { toast } from "./toast";

export async function save(app: App): Promise<void> {
  if (!app.opened?.editable || app.text === null || !app.hello?.may_change) return;
  await save_over(app, app.digest);
}

async function save_over(app: App, digest: string | null): Promise<void> {
  const file = app.opened!.file,
    text = app.text!;
  try {
    const saved = await app.client.ask("save", { file, text, digest });
    app.saved(text, saved.digest);
    toast(t("saved", { file }));
    void app.run_again();
  } catch (e) {
    if (e instanceof Refused && e.changed) await conflict(app, file, text);
    else app.tell(e);
  }
}

async function conflict(app: App, file: string, text: string): Promise<void> {
  const choice = await ask(t("conflict"), t("conflict_long", { file }), [
    ["theirs", t("conflict_theirs")],
    ["copy", t("conflict_copy")],
    ["cancel", t("cancel")],
  ]);
  if (choice === "theirs") await app.open({ file, ...app.choice }, app.instant);
  if (choice !== "copy") return;
  const name = file.replace(/(\.[^./]*)?$/, (end) => `_2${end}`);
  try {
    await app.client.ask("save", { file: name, text, digest: null });
    app.unsaved.keep(file, null, null); // it is in the copy
    await app.open({ file: name, ...app.choice }, app.instant);
  } catch (e) {
    app.tell(e);
  }
}

/// Asks about unsaved text before another program is opened.
export async function may_leave(app: App): Promise<boolean> {
  if (!app.dirty) return true;
  const file = app.opened?.file ?? "";
  const answer = await ask(t("unsaved"), t("unsaved_long", { file }), [
    ["leave", t("discard")],
    ["cancel", t("cancel")],
  ]);
  if (answer === "leave") app.unsaved.keep(file, null, null);
  return answer === "leave";
}

export async function may_replace(file: string): Promise<boolean> {
  return (
    (await ask(t("file_there"), t("file_there_long", { file }), [
      ["replace", t("replace")],
      ["cancel", t("cancel")],
    ])) === "replace"
  );
}
