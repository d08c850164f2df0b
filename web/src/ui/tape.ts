// Punched tape: the open program as the rows of a tape, and a tape of the folder as a program.
import type { App } from "../model/app";
import { files_beneath, save_new } from "../model/new_file";
import type { Punched, TapeCode, TapeRead } from "../protocol/types";
import { t } from "../texts/texts";
import { open_dialog } from "./dialog";
import { button, fill, h, option } from "./dom";
import { short } from "./figures";
import { may_leave, may_replace } from "./save";
import { toast } from "./toast";

const row_step = 2.54e-3; // m from row to row
const most_files = 2000,
  most_shown = 4000; // of a list; characters of a tape's text

const code_choice = (codes: [string, string][], changed: (code: string) => void): HTMLSelectElement =>
  h(
    "select",
    { "aria-label": t("tape_code"), onchange: (e: Event) => changed((e.target as HTMLSelectElement).value) },
    ...codes.map(([value, text], i) => option(value, text, i === 0)),
  );

/// Uses the current text, saved or not.
export function show_to_tape(app: App): void {
  const opened = app.opened;
  if (!opened) return;
  let code: TapeCode = "iso",
    punched: Punched | null = null,
    asked = 0;
  const told = h("p", { role: "status", "aria-live": "polite" }),
    fault = h("p", { class: "hint error", role: "alert" }),
    name = h("input", { "aria-label": t("file_name"), size: "24" });
  const leader = h("input", {
    value: "100",
    inputmode: "numeric",
    size: "6",
    "aria-label": t("tape_leader"),
    onchange: () => void punch(),
  });
  const save = button(t("save"), () => void keep(), { class: "main", disabled: true });
  const take = button(t("tape_download"), () => download(), { disabled: true });
  const punch = async (): Promise<void> => {
    const mine = ++asked;
    punched = null;
    save.disabled = take.disabled = true;
    const rows = Number(leader.value);
    if (!/^\d+$/.test(leader.value.trim()) || rows > 100_000) {
      told.className = "hint error";
      told.textContent = t("mill_no_numbers", { fields: t("tape_leader") });
      return;
    }
    try {
      const answer = (await app.client.ask("tape", {
        way: "out",
        file: opened.file,
        code,
        leader: rows,
        ...(app.dirty && app.text !== null ? { text: app.text } : {}),
      })) as Punched;
      if (mine !== asked) return;
      punched = answer;
      told.className = "note";
      told.textContent = t("tape_rows", { rows: short(answer.rows), metres: short(answer.rows * row_step, 1) });
      name.value ||= answer.name;
      save.disabled = !app.hello?.may_change;
      save.title = app.hello?.may_change ? "" : t("may_not_change");
      take.disabled = false;
    } catch (e) {
      if (mine === asked) {
        told.className = "hint error";
        told.textContent = e instanceof Error ? e.message : String(e);
      }
    }
  };
  const keep = async (): Promise<void> => {
    const file = name.value.trim();
    if (!punched || !file) return name.focus();
    fault.textContent = await save_new(app, file, { bytes: punched.bytes }, () => may_replace(file));
    if (fault.textContent) return name.select();
    toast(t("saved", { file }));
    app.on_files.emit(file);
    dialog.close();
  };
  const download = (): void => {
    const bytes = Uint8Array.from(atob(punched!.bytes), (c) => c.charCodeAt(0));
    const a = h("a", {
      href: URL.createObjectURL(new Blob([bytes], { type: "application/octet-stream" })),
      download: (name.value.trim() || "program.tape").replace(/.*\//, ""),
    });
    a.click();
    URL.revokeObjectURL(a.href);
  };
  const dialog = open_dialog(
    t("to_tape"),
    h(
      "div",
      { class: "tape" },
      h(
        "label",
        { class: "mill-row" },
        h("span", null, t("tape_code")),
        code_choice(
          [
            ["iso", "ISO-7 / ГОСТ 20999"],
            ["eia", "EIA RS-244"],
          ],
          (c) => {
            code = c as TapeCode;
            void punch();
          },
        ),
      ),
      h("label", { class: "mill-row" }, h("span", null, t("tape_leader")), leader),
      h("label", { class: "mill-row" }, h("span", null, t("save_as")), name),
      told,
      fault,
      h("div", { class: "row end" }, take, save),
    ),
  );
  void punch();
}

/// `folder`: its files are listed first.
export function show_from_tape(app: App, folder: string): void {
  let read: TapeRead | null = null,
    asked = 0,
    code = "";
  const told = h("div", { role: "status", "aria-live": "polite" }),
    fault = h("p", { class: "hint error", role: "alert" }),
    text = h("pre", { class: "block-text tape-text", hidden: true, tabindex: "0", "aria-label": t("source") });
  const file = h("select", { "aria-label": t("tape_file"), onchange: () => void look() }),
    name = h("input", { "aria-label": t("file_name"), size: "24" });
  const save = button(t("save_and_open"), () => void keep(), { class: "main", disabled: true });
  const look = async (): Promise<void> => {
    const mine = ++asked;
    read = null;
    save.disabled = text.hidden = true;
    told.replaceChildren();
    if (!file.value) return;
    try {
      const answer = (await app.client.ask("tape", {
        way: "in",
        file: file.value,
        ...(code ? { code: code as TapeCode } : {}),
      })) as TapeRead;
      if (mine !== asked) return;
      read = answer;
      text.hidden = false;
      text.textContent = answer.text.length > most_shown ? `${answer.text.slice(0, most_shown)}\n…` : answer.text;
      fill(
        told,
        h("p", { class: "note" }, t("tape_read_as", { code: answer.code === "eia" ? "EIA" : "ISO-7" })),
        answer.lies && h("p", { class: "mill-warning" }, answer.lies),
        answer.faults.length > 0 &&
          h(
            "ul",
            { class: "hint error" },
            ...answer.faults.map((f) => h("li", null, f)),
            answer.more > 0 && h("li", null, t("tape_more", { count: answer.more })),
          ),
      );
      name.value = answer.name;
      save.disabled = !app.hello?.may_change;
      save.title = app.hello?.may_change ? "" : t("may_not_change");
    } catch (e) {
      if (mine === asked) fill(told, h("p", { class: "hint error" }, e instanceof Error ? e.message : String(e)));
    }
  };
  const keep = async (): Promise<void> => {
    const wanted = name.value.trim();
    if (!read || !wanted) return name.focus();
    fault.textContent = await save_new(app, wanted, { text: read.text }, () => may_replace(wanted));
    if (fault.textContent) return name.select();
    toast(t("saved", { file: wanted }));
    app.on_files.emit(wanted);
    if (!(await may_leave(app))) return;
    dialog.close();
    await app.open({ file: wanted });
  };
  const dialog = open_dialog(
    t("from_tape"),
    h(
      "div",
      { class: "tape" },
      h("label", { class: "mill-row" }, h("span", null, t("tape_file")), file),
      h(
        "label",
        { class: "mill-row" },
        h("span", null, t("tape_code")),
        code_choice(
          [
            ["", t("tape_by_rows")],
            ["iso", "ISO-7 / ГОСТ 20999"],
            ["eia", "EIA RS-244"],
          ],
          (c) => {
            code = c;
            void look();
          },
        ),
      ),
      told,
      text,
      h("label", { class: "mill-row" }, h("span", null, t("save_as")), name),
      fault,
      h("div", { class: "row end" }, save),
    ),
  );
  const likely = (f: string): boolean => /\.(tape|tap|ptp|ppt|pt|bin)$/i.test(f);
  files_beneath(app, folder, (n) => !/\.(png|svg|json|toml|dxf|stl|md|html)$/i.test(n)).then(
    (names) => {
      const sorted = [...names.filter(likely), ...names.filter((n) => !likely(n))].slice(0, most_files);
      const first = app.opened && /^(iso7|eia)/.test(app.opened.encoding) ? app.opened.file : "";
      fill(file, option("", t("tape_choose"), !first), ...sorted.map((n) => option(n, n, n === first)));
      file.focus();
      void look();
    },
    (e) => app.tell(e),
  );
}
