// The list of keys, in a dialogue.
import { t, type TextKey } from "../texts/texts";
import { open_dialog } from "./dialog";
import { h } from "./dom";

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
  ["?", "key_help"],
];

export function show_help(): void {
  open_dialog(
    t("keys"),
    h(
      "div",
      null,
      h(
        "table",
        { class: "keys" },
        h(
          "tbody",
          null,
          ...keys.map(([k, what]) =>
            h(
              "tr",
              null,
              h("th", { scope: "row" }, ...k.split(" ").flatMap((x) => [h("kbd", null, x), " "])),
              h("td", null, t(what)),
            ),
          ),
        ),
      ),
      h("p", { class: "note" }, t("keys_note")),
    ),
  );
}
