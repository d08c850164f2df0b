// What is dropped on a page, or chosen: files, and the files of folders, each with its path.

export interface Found {
  path: string;
  file: File;
}

const most = 5000; // files of a folder that is dropped
const is_hidden = (name: string): boolean => name.startsWith(".");

/// Must be called at once in the handler of the event: later the browser gives nothing.
export function dropped(data: DataTransfer): Promise<Found[]> {
  const entries = [...data.items].map((item) => item.webkitGetAsEntry()).filter((e) => e !== null);
  return entries.length ? walk(entries) : Promise.resolve([...data.files].map((file) => ({ path: file.name, file })));
}

async function walk(entries: FileSystemEntry[]): Promise<Found[]> {
  const found: Found[] = [];
  const visit = async (entry: FileSystemEntry): Promise<void> => {
    if (is_hidden(entry.name) || found.length >= most) return;
    if (entry.isFile) {
      const file = await new Promise<File>((yes, no) => (entry as FileSystemFileEntry).file(yes, no));
      found.push({ path: entry.fullPath.replace(/^\//, ""), file });
    } else if (entry.isDirectory) {
      for (const inner of await inside(entry as FileSystemDirectoryEntry)) await visit(inner);
    }
  };
  for (const entry of entries) await visit(entry).catch(() => undefined); // what cannot be read is left out
  return found;
}

async function inside(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader(),
    all: FileSystemEntry[] = [];
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((yes, no) => reader.readEntries(yes, no)); // a hundred at a time
    if (!some.length) return all;
    all.push(...some);
  }
}
