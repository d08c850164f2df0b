// A dialogue that asks for a file's name: the fault of a name is shown next to it, and nothing that was typed is lost.
import { t } from "../texts/texts";
import { open_dialog } from "./dialog";
import { button, h } from "./dom";

export interface NameQuestion {
  title: string;
  name: string;
  folder: string;
  verb: string;
  more?: HTMLElement; // other fields
  /// Returns why the name is refused; "" if it is done.
  take(name: string): Promise<string>;
}

export function ask_name(q: NameQuestion): void {
  const field = h("input", { value: q.name, "aria-label": t("file_name"), spellcheck: "false", autocomplete: "off" }),
    fault = h("p", { class: "hint error", role: "alert" });
  const go = async (): Promise<void> => {
    const name = field.value.trim();
    if (!name) return field.focus();
    verb.disabled = true;
    fault.textContent = await q.take(q.folder && !name.includes("/") ? `${q.folder}/${name}` : name);
    verb.disabled = false;
    if (fault.textContent) return field.focus();
    dialog.close();
  };
  const verb = button(q.verb, () => void go(), { class: "main" });
  field.addEventListener("keydown", (e) => {
    if (e.key === "Enter") void go();
  });
  const dialog = open_dialog(
    q.title,
    h(
      "div",
      { class: "name-dialog" },
      h("label", { class: "mill-row" }, h("span", null, t("file_name")), field),
      q.folder && h("p", { class: "note" }, t("in_folder", { folder: q.folder })),
      q.more,
      fault,
      h("div", { class: "row end" }, verb),
    ),
  );
  field.focus();
  const last = field.value.lastIndexOf("/") + 1,
    dot = field.value.lastIndexOf(".");
  field.setSelectionRange(last, dot > last ? dot : field.value.length);
}
