// The list of keys, in a dialogue.
import { t, type TextKey } from "../texts/texts";
import { open_dialog } from "./dialog";
import { button, h } from "./dom";

const keys: [string, TextKey][] = [
  ["← →", "key_block"],
  ["Shift ← →", "key_ten"],
  ["Ctrl ← →", "key_hundred"],
  ["PgUp PgDn", "key_tool"],
  ["A · Shift A", "key_alarm"],
  ["Space", "key_play"],
  ["Home End", "key_ends"],
  ["+ −", "key_pace"],
  ["1 2 3 4 5 6", "key_views"],
  ["0 · F", "key_fit"],
  ["M", "key_measure"],
  ["R", "key_rapids"],
  ["Ctrl S", "key_save"],
  ["Ctrl F", "key_search"],
  ["Ctrl Z", "key_undo"],
  ["F6", "key_panes"],
  ["Esc", "key_leave"],
  ["O", "key_operator"],
  ["?", "key_help"],
];

/// Keys of the operator's screen (operator/keys.ts).
const operator_keys: typeof keys = [
  ["R", "key_op_start"],
  ["P", "key_op_hold"],
  ["Esc", "key_op_escape"],
  ["F1", "key_op_stop"],
  ["− + 0", "key_op_override"],
  ["1 2 3 4 5", "key_op_tabs"],
  ["← → ↑ ↓ PgUp PgDn", "key_op_jog"],
];

const list = (of: typeof keys): HTMLElement =>
  h(
    "table",
    { class: "keys" },
    h(
      "tbody",
      null,
      ...of.map(([k, what]) =>
        h(
          "tr",
          null,
          h("th", { scope: "row" }, ...k.split(" ").flatMap((x) => [h("kbd", null, x), " "])),
          h("td", null, t(what)),
        ),
      ),
    ),
  );

/// `tour`: shows the page once more; a report has none. `operator`: the operator's screen is shown, whose keys come first.
export function show_help(tour?: () => void, operator = document.body.classList.contains("operates")): void {
  const of_page = h("div", null, h("h3", null, t("keys")), list(keys), h("p", { class: "note" }, t("keys_note")));
  const of_operator = h(
    "div",
    null,
    h("h3", null, t("keys_operator")),
    list(operator_keys),
    h("p", { class: "note" }, t("keys_operator_note")),
  );
  const again =
    tour &&
    button(t("tour"), () => {
      dialog.close();
      tour();
    });
  const dialog = open_dialog(
    t("keys"),
    h("div", null, ...(operator ? [of_operator, of_page] : [of_page, of_operator])),
    { tools: again },
  );
}
