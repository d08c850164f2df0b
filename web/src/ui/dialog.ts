// Dialogues based on the browser's own <dialog>: it keeps the focus inside, closes by Escape, and works with screen
// readers.
import { t } from "../texts/texts";
import { button, h } from "./dom";
import { icon } from "./icons";
import { place_toasts } from "./toast";

/// `docked`: the page remains usable next to it: on the left the view stays visible, on the right the source.
export function open_dialog(
  title: string,
  content: Node,
  options: { wide?: boolean; docked?: "left" | "right"; closed?: () => void; tools?: Node } = {},
): HTMLDialogElement {
  const close = (): void => dialog.close();
  const dialog = h(
    "dialog",
    {
      class: `dialog${options.wide ? " wide" : ""}${options.docked ? ` docked ${options.docked}` : ""}`,
      "aria-label": title,
    },
    h(
      "header",
      { class: "dialog-head" },
      h("h2", null, title),
      options.tools,
      button(icon("close"), close, { "aria-label": t("close"), title: t("close"), class: "icon" }),
    ),
    h("div", { class: "dialog-body" }, content),
  );
  dialog.addEventListener("close", () => {
    place_toasts(dialog);
    dialog.remove();
    options.closed?.();
  });
  document.body.append(dialog);
  if (options.docked) {
    for (const other of document.querySelectorAll<HTMLDialogElement>("dialog.docked")) other.close(); // one at a time
    dialog.addEventListener("keydown", (e) => {
      if (e.key === "Escape") close();
    });
    dialog.show(); // the view remains usable next to it
  } else {
    dialog.showModal();
    place_toasts();
  }
  return dialog;
}

/// Asks the user; returns the name of the button, or "cancel".
export function ask(title: string, text: string, choices: [string, string][]): Promise<string> {
  return new Promise((yes) => {
    let answer = "cancel";
    const buttons = choices.map(([name, shown], i) =>
      button(
        shown,
        () => {
          answer = name;
          dialog.close();
        },
        i === 0 ? { class: "main" } : {},
      ),
    );
    const dialog = open_dialog(title, h("div", null, h("p", null, text), h("div", { class: "row end" }, ...buttons)), {
      closed: () => yes(answer),
    });
  });
}
