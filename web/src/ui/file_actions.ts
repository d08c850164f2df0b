// What is done with files of the served folder: a new program, another name, a copy, the trash. A file is never
// replaced, and what was deleted can be brought back.
import type { App } from "../model/app";
import { free_name, name_part, folder_part } from "../model/file_names";
import { Refused } from "../protocol/client";
import { alone } from "../protocol/way";
import { t } from "../texts/texts";
import { ask } from "./dialog";
import { h, option } from "./dom";
import { save_file } from "./download";
import { ask_name } from "./name_dialog";
import { may_leave } from "./save";
import { toast } from "./toast";

export const told_of = (e: unknown, file: string): string =>
  e instanceof Refused && e.changed ? t("name_taken", { file }) : e instanceof Error ? e.message : String(e);

export class FileActions {
  constructor(
    private app: App,
    private show: (folder: string) => void, // the list of this folder has changed
  ) {}

  /// Of a page without a server: the file as a download.
  download(path: string): void {
    const bytes = alone?.bytes_of(path);
    if (bytes) save_file(name_part(path), new Blob([bytes]));
  }

  /// Asks for name and control, and opens the new program.
  new_program(folder: string, names: ReadonlySet<string>): void {
    const { app } = this,
      now = app.opened?.control.id ?? "mach3",
      controls = h(
        "select",
        { "aria-label": t("of_control") },
        ...(app.hello?.controls ?? []).map((c) => option(c.id, c.name, c.id === now)),
      );
    ask_name({
      title: t("new_program_title"),
      name: free_name("new.nc", names),
      folder,
      verb: t("create"),
      more: h(
        "div",
        null,
        h("label", { class: "mill-row" }, h("span", null, t("of_control")), controls),
        h("p", { class: "note" }, t("new_head")),
      ),
      take: (file) =>
        this.done(file, async () => {
          const control = controls.value,
            { text } = await app.client.ask("new_program", { control });
          await app.client.ask("save", { file, text, digest: null });
          this.show(folder_part(file));
          if (await may_leave(app)) await app.open({ file, control });
        }),
    });
  }

  /// Saves the text of the editor as another file, and opens that.
  save_as(names: ReadonlySet<string>): void {
    const { app } = this,
      from = app.opened?.file;
    if (!from || app.text === null) return;
    ask_name({
      title: t("save_under"),
      name: free_name(name_part(from), names),
      folder: folder_part(from),
      verb: t("save"),
      take: (file) =>
        this.done(file, async () => {
          const { control, machine, setup } = app.choice;
          await app.client.ask("save", { file, text: app.text ?? "", digest: null });
          app.unsaved.keep(from, null, null); // it is in the new file
          this.show(folder_part(file));
          toast(t("saved", { file }));
          await app.open({ file, control, machine, setup }, app.instant);
        }),
    });
  }

  rename(file: string): void {
    ask_name({
      title: t("rename"),
      name: name_part(file),
      folder: folder_part(file),
      verb: t("rename").replace("…", ""),
      take: (to) =>
        this.done(to, async () => {
          if (to === file) return;
          await this.app.client.ask("rename", { file, to });
          this.show(folder_part(to));
          toast(t("renamed", { file, to }), false, { name: t("undo"), go: () => void this.rename_back(to, file) });
          await this.follow(file, to);
        }),
    });
  }
  private async rename_back(file: string, to: string): Promise<void> {
    try {
      await this.app.client.ask("rename", { file, to });
      this.show(folder_part(to));
      await this.follow(file, to);
    } catch (e) {
      this.app.tell(e);
    }
  }
  /// The open program and its set-up keep being open under their new names.
  private async follow(file: string, to: string): Promise<void> {
    const { app } = this;
    if (app.opened?.file === file) await app.renamed(to);
    else if (app.opened && app.choice.setup === file) await app.run_again({ ...app.choice, setup: to });
  }

  duplicate(file: string, names: ReadonlySet<string>): void {
    ask_name({
      title: t("duplicate"),
      name: free_name(name_part(file), names),
      folder: folder_part(file),
      verb: t("duplicate").replace("…", ""),
      take: (to) =>
        this.done(to, async () => {
          await this.app.client.ask("copy", { file, to });
          this.show(folder_part(to));
          toast(t("duplicated", { file: to }));
        }),
    });
  }

  async delete(file: string): Promise<void> {
    const { app } = this,
      is_open = app.opened?.file === file;
    if (is_open && app.dirty) {
      const choice = await ask(t("delete"), t("delete_unsaved", { file }), [
        ["delete", t("delete")],
        ["cancel", t("cancel")],
      ]);
      if (choice !== "delete") return;
    }
    try {
      const { trash } = await app.client.ask("delete", { file });
      this.show(folder_part(file));
      if (is_open) app.lost_on_disk();
      toast(t("deleted", { file }), false, { name: t("undo"), go: () => void this.restore(file, trash) });
    } catch (e) {
      app.tell(e);
    }
  }

  private async restore(file: string, trash: string): Promise<void> {
    try {
      await this.app.client.ask("restore", { file, trash });
      this.show(folder_part(file));
      toast(t("restored", { file }));
    } catch (e) {
      this.app.on_error.emit(told_of(e, file));
    }
  }

  private async done(file: string, what: () => Promise<void>): Promise<string> {
    try {
      await what();
      return "";
    } catch (e) {
      return told_of(e, file);
    }
  }
}
