// Files that come with the page: inside it, where `kadr report --live` has put them, or in its address after `#files=`,
// as the links of the documentation have them. Both are base64 of zlib of JSON: {"open": OpenQuestion, "files": {path:
// text}}, each character of a text a byte.
import type { OpenQuestion } from "../protocol/types";
import type { FileBytes } from "./messages";
import { unpacked } from "./parts";

export interface Given {
  open: OpenQuestion;
  files: FileBytes[];
  kept: boolean; // the browser keeps them; those of a report live as long as its page
}

const begins = "#files=";

const bytes_of = (text: string): ArrayBuffer => Uint8Array.from(text, (c) => c.charCodeAt(0)).buffer;

/// Returns null if no files came with the page, or they cannot be read.
export async function given_files(address = location.hash): Promise<Given | null> {
  const inside = document.getElementById("kadr-files")?.textContent?.trim(),
    after = address.startsWith(begins) ? address.slice(begins.length).replace(/-/g, "+").replace(/_/g, "/") : "",
    text = inside || after;
  if (!text) return null;
  try {
    const { open, files } = (await unpacked(text, "deflate").json()) as {
      open: OpenQuestion;
      files: Record<string, string>;
    };
    const all = Object.entries(files).map(([path, content]): FileBytes => [path, bytes_of(content)]);
    return { open, files: all, kept: !inside };
  } catch {
    return null;
  }
}

/// The same page with other files in its address is another page.
export function listen_given(): void {
  addEventListener("hashchange", () => location.hash.startsWith(begins) && location.reload());
}
