// A short message at the bottom: read out by screen readers, removed after a while; an error stays longer.
import { h } from "./dom";

const host = h("div", { class: "toasts", role: "status", "aria-live": "polite" });

export function toast(text: string, error = false): void {
  if (!host.isConnected) document.body.append(host);
  const e = h("div", { class: error ? "toast error" : "toast" }, text);
  host.append(e);
  while (host.childElementCount > 4) host.firstElementChild!.remove();
  setTimeout(() => e.remove(), error ? 12_000 : 3_000);
}
