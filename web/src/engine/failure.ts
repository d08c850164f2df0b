// Says that the engine cannot start: the only thing on the page then.
import { t } from "../texts/texts";
import { h } from "../ui/dom";

export function tell_failure(why: string): void {
  const old = document.querySelector(".engine-failed");
  old?.remove();
  document.body.prepend(h("div", { class: "banner engine-failed", role: "alert" }, t("alone_failed", { why })));
}
