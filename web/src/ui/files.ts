// The drawer of files: folders below the served one, programs to open, set-ups to run with, drawings to create
// programs from; tape, other controls; what is done with a file is in its menu.
import type { App } from "../model/app";
import { folder_part } from "../model/file_names";
import type { FileEntry } from "../protocol/types";
import { alone } from "../protocol/way";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";
import { bytes } from "./figures";
import { icon } from "./icons";
import { FileActions } from "./file_actions";
import { open_menu } from "./row_menu";
import { may_leave } from "./save";
import { show_trash } from "./trash";
import { Upload } from "./upload";

const is_drawing = (name: string): boolean => /\.(dxf|svg)$/i.test(name);

/// `folder`: the shown one.
export interface FilesVerbs {
  from_drawing(folder: string, drawing?: string): void;
  to_tape(): void;
  from_tape(folder: string): void;
  convert(): void;
}

export class FilesDrawer {
  readonly element = h("nav", { class: "pane files", "aria-label": "" });
  private folder = "";
  private fresh = true;
  private list = h("ul", { class: "file-list" });
  private crumbs = h("span", { class: "pane-title crumbs" });
  private verbs_row = h("div", { class: "files-verbs" });
  private names = new Set<string>();
  private tools = h("span", { class: "pane-tools" });
  readonly actions: FileActions;
  readonly upload: Upload;

  constructor(
    private app: App,
    private verbs: FilesVerbs,
  ) {
    this.actions = new FileActions(app, (folder) => void this.go(folder));
    this.upload = new Upload(
      app,
      () => this.folder,
      () => this.names,
      (folder) => this.go(folder),
    );
    this.element.append(h("header", { class: "pane-head" }, this.crumbs, this.tools), this.list, this.verbs_row);
    app.on_files.on((file) => void this.go(folder_part(file)));
    app.on_line.on((l) => {
      if (l === "open") void this.go(this.folder);
    });
    app.on_opened.on((o) => {
      const folder = folder_part(o.file);
      if (this.fresh && folder !== this.folder)
        void this.go(folder); // the program that was open before a reload is shown in its folder
      else if (folder === this.folder && !this.names.has(o.file)) void this.go(folder); // it has just been saved
      this.fresh = false;
      this.mark();
    });
    on_language(() => void this.go(this.folder));
  }

  new_program(): void {
    this.actions.new_program(this.folder, this.names);
  }
  save_as(): void {
    this.actions.save_as(this.names);
  }

  private async go(folder: string): Promise<void> {
    try {
      const { entries, more } = await this.app.client.ask("files", { folder });
      this.folder = folder;
      this.draw(entries, more === true);
    } catch (e) {
      this.app.tell(e);
    }
  }

  private draw(entries: FileEntry[], more: boolean): void {
    this.element.setAttribute("aria-label", t("files"));
    const parts = this.folder ? this.folder.split("/") : [];
    fill(
      this.crumbs,
      button(this.app.hello?.folder || "/", () => void this.go("")),
      ...parts.flatMap((name, i) => [" / ", button(name, () => void this.go(parts.slice(0, i + 1).join("/")))]),
    );
    const may = { disabled: !this.app.hello?.may_change };
    fill(
      this.tools,
      button(t("new_program"), () => this.new_program(), may),
      button(t(alone ? "alone_open" : "upload"), () => this.upload.choose(), {
        ...may,
        title: t(alone ? "alone_upload_long" : "upload_long"),
      }),
    );
    fill(
      this.list,
      ...entries.map((e) => this.row(e)),
      more && h("li", { class: "note" }, t("more_files")),
      !entries.length && h("li", { class: "note" }, t("empty_folder")),
    );
    this.names = new Set(entries.map((e) => (this.folder ? `${this.folder}/${e.name}` : e.name)));
    fill(
      this.verbs_row,
      button(t("new_from_drawing"), () => this.verbs.from_drawing(this.folder)),
      button(t("to_tape"), () => this.verbs.to_tape(), { "data-needs": "program" }),
      button(t("from_tape"), () => this.verbs.from_tape(this.folder)),
      button(t("convert"), () => this.verbs.convert(), { "data-needs": "program" }),
      button(t("trash"), () => void show_trash(this.app, (folder) => void this.go(folder)), { title: t("trash_long") }),
    );
    this.mark();
  }

  private row(e: FileEntry): HTMLElement {
    const path = this.folder ? `${this.folder}/${e.name}` : e.name;
    const draws = e.kind === "other" && is_drawing(e.name);
    const can =
      draws || e.kind === "folder" || e.kind === "program" || (e.kind === "setup" && this.app.opened !== null);
    return h(
      "li",
      null,
      e.kind !== "folder" && this.menu_button(path),
      h(
        "button",
        {
          type: "button",
          class: `file-row ${e.kind}`,
          disabled: !can,
          "data-path": path,
          title: e.kind === "setup" ? t("use_setup") : draws ? `${path}: ${t("new_from_drawing")}` : path,
          onclick: () => void this.choose(e, path),
          onkeydown: (event: KeyboardEvent) => this.key(event, e, path),
        },
        icon(e.kind),
        h("span", { class: "file-name" }, e.name),
        e.kind !== "folder" && h("span", { class: "file-size" }, bytes(e.size)),
      ),
    );
  }

  /// What can be done with a file.
  private menu_button(path: string): HTMLButtonElement {
    const { actions, names } = this,
      label = t("file_menu", { file: path });
    const dots = button(
      icon("dots"),
      () =>
        open_menu(dots, label, [
          { name: t("rename"), go: () => actions.rename(path) },
          { name: t("duplicate"), go: () => actions.duplicate(path, names) },
          { name: t("delete"), go: () => void actions.delete(path) },
          ...(alone ? [{ name: t("alone_download"), go: () => actions.download(path) }] : []),
        ]),
      {
        class: "icon file-menu",
        "aria-label": label,
        title: label,
        "aria-haspopup": "menu",
        disabled: !this.app.hello?.may_change,
      },
    );
    return dots;
  }
  private key(event: KeyboardEvent, e: FileEntry, path: string): void {
    if (e.kind === "folder" || !this.app.hello?.may_change) return;
    if (event.key === "F2") this.actions.rename(path);
    else if (event.key === "Delete") void this.actions.delete(path);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private async choose(e: FileEntry, path: string): Promise<void> {
    if (e.kind === "folder") return this.go(path);
    if (e.kind === "setup") return this.app.run_again({ ...this.app.choice, setup: path });
    if (e.kind === "other") return this.verbs.from_drawing(this.folder, path);
    if (!(await may_leave(this.app))) return;
    await this.app.open({ file: path });
  }

  private mark(): void {
    for (const b of this.list.querySelectorAll<HTMLElement>(".file-row")) {
      if (b.dataset.path === this.app.opened?.file) b.setAttribute("aria-current", "true");
      else b.removeAttribute("aria-current");
      if (b.classList.contains("setup")) (b as HTMLButtonElement).disabled = this.app.opened === null;
    }
    for (const b of this.verbs_row.querySelectorAll<HTMLButtonElement>("[data-needs=program]"))
      b.disabled = this.app.opened === null;
  }
}
