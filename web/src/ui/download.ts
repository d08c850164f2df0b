// A file of the page, saved on the computer by the browser.
import { h } from "./dom";

const kept = 60_000; // ms that the browser may need to take the file

export function save_file(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  h("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), kept);
}
