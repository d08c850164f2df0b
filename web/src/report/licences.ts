// The notices of the packages inside a report.
import { t } from "../texts/texts";
import { open_dialog } from "../ui/dialog";
import { h } from "../ui/dom";

export function show_licences(text: string): void {
  open_dialog(t("licences"), h("pre", { class: "licences", tabindex: "0" }, text), { wide: true });
}
