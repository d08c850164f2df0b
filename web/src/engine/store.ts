// Keeps the files of the page in this browser (IndexedDB) until they are deleted. Where the browser does not allow it, such
// as in a private window, they live as long as the page.
import type { FileBytes } from "./messages";

const base = "kadr-files",
  table = "files";

function opened(): Promise<IDBDatabase> {
  return new Promise((yes, no) => {
    const request = indexedDB.open(base, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(table);
    request.onsuccess = () => yes(request.result);
    request.onerror = () => no(request.error);
  });
}

export class Store {
  private constructor(private db: IDBDatabase | null) {}

  /// `nothing`: keeps nothing, and has nothing.
  static async open(nothing = false): Promise<Store> {
    return new Store(nothing ? null : await opened().catch(() => null));
  }

  /// Whether files outlive the page.
  get keeps(): boolean {
    return this.db !== null;
  }

  all(): Promise<FileBytes[]> {
    const { db } = this;
    if (!db) return Promise.resolve([]);
    return new Promise((yes, no) => {
      const found: FileBytes[] = [],
        request = db.transaction(table).objectStore(table).openCursor();
      request.onsuccess = () => {
        const cursor = request.result;
        if (!cursor) return yes(found);
        found.push([String(cursor.key), cursor.value as ArrayBuffer]);
        cursor.continue();
      };
      request.onerror = () => no(request.error);
    });
  }

  /// Returns false if the browser has no room: then the files live as long as the page.
  keep(changed: FileBytes[], gone: string[]): Promise<boolean> {
    const { db } = this;
    if (!db) return Promise.resolve(false);
    return new Promise((yes) => {
      const change = db.transaction(table, "readwrite"),
        files = change.objectStore(table);
      for (const [path, bytes] of changed) files.put(bytes, path);
      for (const path of gone) files.delete(path);
      change.oncomplete = () => yes(true);
      change.onerror = change.onabort = () => yes(false);
    });
  }
}
