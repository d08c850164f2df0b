// Files of this computer: chosen or dropped on the page, copied to the folder that is shown; a single program is opened.
import type { App } from "../model/app";
import { base64, folder_part, free_name, most_sent, name_part } from "../model/file_names";
import { Refused } from "../protocol/client";
import { alone } from "../protocol/way";
import { on_language, t } from "../texts/texts";
import { ask } from "./dialog";
import { h } from "./dom";
import { dropped, type Found } from "./dropped";
import { bytes } from "./figures";
import { may_leave } from "./save";
import { toast } from "./toast";

export class Upload {
  constructor(
    private app: App,
    private folder: () => string, // the one that is shown
    private names: () => ReadonlySet<string>,
    private show: (folder: string) => Promise<void>,
  ) {}

  /// Lets the user choose files.
  choose(): void {
    const field = h("input", { type: "file", multiple: true });
    field.addEventListener("change", () => void this.take([...(field.files ?? [])]));
    field.click();
  }

  /// Makes the whole page a place to drop files on.
  listen(target: HTMLElement): void {
    const sign = h("div", { class: "drop-here", hidden: true });
    target.append(sign);
    const brings_files = (e: DragEvent): boolean => e.dataTransfer?.types.includes("Files") ?? false;
    target.addEventListener("dragover", (e) => {
      if (!brings_files(e)) return;
      e.preventDefault();
      e.dataTransfer!.dropEffect = this.app.hello?.may_change ? "copy" : "none";
      sign.textContent = t(alone ? "alone_drop_here" : "drop_here", {
        folder: this.folder() || this.app.hello?.folder || "/",
      });
      sign.hidden = false;
    });
    target.addEventListener("dragleave", (e) => {
      if (!e.relatedTarget) sign.hidden = true;
    });
    target.addEventListener("drop", (e) => {
      sign.hidden = true;
      if (!brings_files(e)) return;
      e.preventDefault(); // the browser would leave the page and show the file
      if (alone && e.dataTransfer) void dropped(e.dataTransfer).then((found) => this.put(found));
      else void this.take([...(e.dataTransfer?.files ?? [])]);
    });
    on_language(() => (sign.hidden = true));
  }

  async take(files: File[]): Promise<void> {
    const { app } = this;
    if (alone) return this.put(files.map((file) => ({ path: file.name, file })));
    if (!app.hello?.may_change) return app.on_error.emit(t("may_not_change"));
    const sent: string[] = [];
    for (const file of files) {
      const name = await this.send(file);
      if (name) sent.push(name);
    }
    if (!sent.length) return;
    await this.show(this.folder());
    toast(sent.length === 1 ? t("sent", { file: sent[0]! }) : t("sent_many", { n: sent.length }));
    if (sent.length !== 1 || !(await this.is_program(sent[0]!)) || !(await may_leave(app))) return;
    await app.open({ file: sent[0]! });
  }

  /// Returns its name in the folder; null if it was not copied, which has been reported.
  private async send(file: File): Promise<string | null> {
    const { app } = this;
    if (file.size > most_sent) return this.refuse(t("too_long_to_send", { file: file.name, most: bytes(most_sent) }));
    const content = await file.arrayBuffer().catch(() => null); // a folder, or a file that may not be read
    if (!content) return this.refuse(t("empty_dropped", { file: file.name }));
    const folder = this.folder(),
      name = folder ? `${folder}/${file.name}` : file.name,
      coded = base64(new Uint8Array(content));
    try {
      await app.client.ask("save", { file: name, bytes: coded, digest: null });
      return name;
    } catch (e) {
      if (!(e instanceof Refused && e.changed)) return this.refuse(e instanceof Error ? e.message : String(e));
    }
    return this.send_beside(name, coded);
  }

  /// A file of this name is there.
  private async send_beside(name: string, coded: string): Promise<string | null> {
    const { app } = this;
    const choice = await ask(t("there_already", { file: name }), t("there_already_long"), [
      ["both", t("there_both")],
      ["replace", t("there_replace")],
      ["skip", t("there_skip")],
    ]);
    if (choice !== "both" && choice !== "replace") return null;
    try {
      if (choice === "replace") await app.client.ask("delete", { file: name });
      const folder = folder_part(name),
        free = choice === "both" ? free_name(name_part(name), this.names()) : name_part(name),
        other = folder ? `${folder}/${free}` : free;
      await app.client.ask("save", { file: other, bytes: coded, digest: null });
      return other;
    } catch (e) {
      return this.refuse(e instanceof Error ? e.message : String(e));
    }
  }

  /// Without a server the files need not be sent: they become files of the page, of any length, with their folders.
  async put(found: Found[]): Promise<void> {
    const { app } = this,
      folder = this.folder(),
      files: { path: string; bytes: ArrayBuffer }[] = [];
    for (const { path: name, file } of found) {
      const path = folder ? `${folder}/${name}` : name,
        bytes = await file.arrayBuffer().catch(() => null);
      if (!bytes) this.refuse(t("empty_dropped", { file: name }));
      else if (!alone!.bytes_of(path) || (await this.may_replace(path))) files.push({ path, bytes });
    }
    if (!files.length) return;
    alone!.put(files);
    await this.show(folder);
    const first = files[0]!.path;
    if (files.length > 1) return toast(t("sent_many", { n: files.length }));
    if ((await this.is_program(first)) && (await may_leave(app))) await app.open({ file: first });
  }

  private async may_replace(path: string): Promise<boolean> {
    const choice = await ask(t("there_already", { file: path }), t("there_already_long"), [
      ["replace", t("there_replace")],
      ["skip", t("there_skip")],
    ]);
    if (choice === "replace") await this.app.client.ask("delete", { file: path }).catch((e) => this.app.tell(e));
    return choice === "replace";
  }

  private async is_program(file: string): Promise<boolean> {
    const { entries } = await this.app.client.ask("files", { folder: folder_part(file) });
    return entries.some((e) => e.name === name_part(file) && e.kind === "program");
  }

  private refuse(text: string): null {
    this.app.on_error.emit(text);
    return null;
  }
}
