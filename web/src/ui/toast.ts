// A short message at the bottom: read out by screen readers, removed after a while; an error stays longer.
import { button, h } from "./dom";

const host = h("div", { class: "toasts", role: "status", "aria-live": "polite" });

/// `act`: a button of the message, for instance to undo what was done; then the message stays longer.
export function toast(text: string, error = false, act?: { name: string; go: () => void }): void {
  if (!host.isConnected) document.body.append(host);
  const e = h("div", { class: error ? "toast error" : "toast" }, text);
  if (act)
    e.append(
      button(act.name, () => {
        e.remove();
        act.go();
      }),
    );
  host.append(e);
  while (host.childElementCount > 4) host.firstElementChild!.remove();
  setTimeout(() => e.remove(), act ? 15_000 : error ? 12_000 : 3_000);
}
