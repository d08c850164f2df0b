// Notices that the file of the open program has been changed on the disk, or is gone: looks every few seconds while the
// page is visible. A file that was written again with the same text is no change.
import type { App } from "./app";
import { Signal } from "./signal";

const every = 3000; // ms

export type DiskChange = { file: string; text: string; digest: string } | { file: string; text: null };

export class DiskWatch {
  readonly on_change = new Signal<DiskChange | null>(); // null: the file is as the page knows it
  change: DiskChange | null = null;
  private looking = false;
  private connected = false;

  constructor(private app: App) {
    app.on_line.on((line) => (this.connected = line === "open"));
    setInterval(() => void this.look(), every);
    for (const s of [app.on_opening, app.on_dirty]) s.on(() => this.compare_known());
    document.addEventListener("visibilitychange", () => void this.look());
  }

  async look(): Promise<void> {
    const { app } = this,
      file = app.opened?.file;
    if (this.looking || document.hidden || !file || app.text === null || !this.connected || app.running) return;
    this.looking = true;
    try {
      const known = app.digest;
      const { digest } = await app.client.ask("digest", { file, known: known ?? "" });
      if (app.opened?.file !== file || app.digest !== known) return; // opened, saved or renamed meanwhile
      if (digest === null) {
        if (known !== null) app.lost_on_disk();
        return this.tell({ file, text: null });
      }
      if (digest === known) return this.tell(null);
      if (this.change && this.change.text !== null && this.change.digest === digest) return;
      const read = await app.client.ask("read", { file });
      if (app.opened?.file !== file || app.digest !== known) return;
      if (read.text === app.saved_text || read.text === app.text) app.saved(read.text, read.digest);
      else this.tell({ file, text: read.text, digest: read.digest });
    } catch {
      /* the connection is lost, or the file cannot be read: the next look tells */
    } finally {
      this.looking = false;
    }
  }

  private compare_known(): void {
    const { change, app } = this;
    if (!change) return;
    const known = change.text === null ? app.digest !== null : app.digest === change.digest;
    if (known || app.opened?.file !== change.file) this.tell(null);
  }

  private tell(change: DiskChange | null): void {
    if (change === this.change || (change?.text === null && this.change?.text === null)) return;
    this.change = change;
    this.on_change.emit(change);
  }
}
