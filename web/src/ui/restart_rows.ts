// What will be in force at a restart, next to what is in force now: a table, in which some of it can be left as it is.
import { axis_name, factor, type Diameters } from "../model/diameters";
import type { Restart } from "../model/restart";
import type { BesideSheet, RestartRow, RestartSheet } from "../protocol/types";
import { t, type TextKey } from "../texts/texts";
import { h } from "./dom";
import { coordinate } from "./figures";

/// A sheet, the axes in diameter programming of its channel, and whether the user may change it.
export interface SheetPart {
  sheet: RestartSheet | BesideSheet;
  of: Diameters;
  may: boolean;
}

/// Positions, origins and lengths along an axis in diameter programming are shown as diameters.
const of_an_axis = ["position", "machine", "origin", "length"];
const plain = ["variable", "tool", "selected", "offset", "length_offset"]; // numbers that are no lengths
function written(row: RestartRow, v: string | number | null, of: Diameters): string {
  if (v === null) return "–";
  if (typeof v === "string" || plain.includes(row.kind)) return String(v);
  return coordinate(of_an_axis.includes(row.kind) ? factor(row.name, of) * v : v);
}

/// Rows that differ; those that are the same in a fold.
export function restart_rows(restart: Restart, { sheet, of, may }: SheetPart): HTMLElement[] {
  const other = sheet.rows.filter((row) => row.by !== ""),
    same = sheet.rows.filter((row) => row.by === ""),
    body = (rows: RestartRow[], can: boolean): HTMLElement =>
      h("tbody", null, ...rows.map((row) => one_row(restart, row, of, can)));
  return [
    h(
      "table",
      { class: "restart-rows" },
      h(
        "thead",
        null,
        h(
          "tr",
          null,
          h("th", null),
          ...(["restart_wanted", "restart_now", "restart_by"] as const).map((x) => h("th", { scope: "col" }, t(x))),
        ),
      ),
      body(other, may),
    ),
    h(
      "details",
      null,
      h("summary", { class: "dim" }, t("restart_same", { n: same.length })),
      h("table", { class: "restart-rows" }, body(same, false)),
    ),
  ];
}

function one_row(restart: Restart, row: RestartRow, of: Diameters, may: boolean): HTMLElement {
  const name = t(`force_${row.kind}` as TextKey),
    leaves = restart.leave.has(row.key);
  const how = row.may_be_left
    ? h(
        "select",
        {
          "aria-label": `${name} ${row.name}`,
          disabled: !may,
          onchange: (e: Event) => restart.set_leave(row.key, (e.target as HTMLSelectElement).value === "leave"),
        },
        ...(["set", "leave"] as const).map((v) => {
          const o = h("option", { value: v }, t(`restart_${v}`));
          o.selected = (v === "leave") === leaves;
          return o;
        }),
      )
    : h("span", { class: "dim" }, row.by && t(`restart_by_${row.by}` as TextKey));
  return h(
    "tr",
    { class: row.by && !leaves ? "differs" : "" },
    h("th", { scope: "row" }, `${name} ${of_an_axis.includes(row.kind) ? axis_name(row.name, of) : row.name}`),
    h("td", null, written(row, row.wanted, of)),
    h("td", null, written(row, row.now, of)),
    h("td", null, how),
  );
}
