// The set-up that the program runs with, chosen from the set-ups in its folder.
import type { App } from "../model/app";
import { t } from "../texts/texts";
import { fill, h, option } from "../ui/dom";

const folder_of = (file: string): string => file.slice(0, Math.max(0, file.lastIndexOf("/")));
const stem = (file: string): string => file.slice(file.lastIndexOf("/") + 1).replace(/\.[^.]*$/, "");
const make_one = "\n"; // no file has this name

export class SetupChoice {
  private select = h("select", { class: "setup-choice" });
  private folder: string | null = null;
  private beside: string[] = [];

  /// `make`: shows the form that makes a set-up from the program.
  constructor(
    private app: App,
    private make: () => void,
  ) {
    this.select.addEventListener("change", () => {
      const { value } = this.select;
      if (value !== make_one) return void app.run_again({ ...app.choice, setup: value || undefined });
      this.draw();
      this.make();
    });
    app.on_opened.on((o) => {
      if (folder_of(o.file) !== this.folder) void this.look(folder_of(o.file));
    });
    app.on_files.on((file) => {
      if (folder_of(file) === this.folder) void this.look(this.folder);
    });
  }

  /// The list, with the set-up in force.
  element(): HTMLElement {
    this.draw();
    return this.select;
  }

  private draw(): void {
    const now = this.app.opened?.setup ?? "",
      own = stem(this.app.opened?.file ?? "");
    const all = [...new Set([...this.beside, ...(now ? [now] : [])])].sort(
      (a, b) => Number(stem(b) === own) - Number(stem(a) === own) || a.localeCompare(b),
    );
    this.select.setAttribute("aria-label", t("setup"));
    this.select.title = now || t("setup");
    fill(
      this.select,
      option("", t("no_setup"), !now),
      ...all.map((file) =>
        option(file, folder_of(file) === this.folder ? file.slice(file.lastIndexOf("/") + 1) : file, file === now),
      ),
      option(make_one, t("setup_make"), false),
    );
  }

  private async look(folder: string): Promise<void> {
    this.folder = folder;
    try {
      const { entries } = await this.app.client.ask("files", { folder });
      if (folder !== this.folder) return;
      this.beside = entries.filter((e) => e.kind === "setup").map((e) => (folder ? `${folder}/${e.name}` : e.name));
      this.draw();
    } catch {
      /* the drawer of files reports it */
    }
  }
}
