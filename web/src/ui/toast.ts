// A short message at the bottom: read out by screen readers, removed after a while; an error stays longer.
import { button, h } from "./dom";

const host = h("div", { class: "toasts", role: "status", "aria-live": "polite" });

/// Messages stand in the modal dialogue that is open: what is outside of it is covered, and hears neither mouse nor keys.
/// A dialogue calls this when it has opened, and before it is removed.
///   closing  the dialogue that is about to be removed
export function place_toasts(closing?: HTMLDialogElement): void {
  const open = [...document.querySelectorAll<HTMLDialogElement>("dialog:modal")].filter((d) => d !== closing),
    wanted = open.at(-1) ?? document.body;
  if (host.parentElement !== wanted) wanted.append(host);
}

/// `act`: a button of the message, for instance to undo what was done; then the message stays longer.
export function toast(text: string, error = false, act?: { name: string; go: () => void }): void {
  place_toasts();
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
  setTimeout(() => e.remove(), act ? 30_000 : error ? 12_000 : 3_000);
}
