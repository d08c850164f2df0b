// Titles of the columns of tables, in words, with their units: the form of the set-up and the tables of a machine.
import { t, type TextKey } from "../texts/texts";

/// Columns whose letter is the name of an axis only in some tables: on a lathe, X of an offset is a geometry.
const of_offsets: Record<string, TextKey> = {
  length: "column_length",
  length_wear: "column_length_wear",
  radius: "column_radius",
  radius_wear: "column_radius_wear",
  corner_radius: "column_corner_radius",
  corner_radius_wear: "column_corner_radius_wear",
  length_x: "column_length_x",
  length_x_wear: "column_length_x_wear",
  length_y: "column_length_y",
  length_y_wear: "column_length_y_wear",
  tip_position: "column_tip",
  tip: "column_tip",
  X: "column_x",
  X_wear: "column_x_wear",
  Y: "column_y",
  Y_wear: "column_y_wear",
  Z: "column_z",
  Z_wear: "column_z_wear",
};
const of_tool_table: Record<string, [TextKey, string]> = {
  T: ["column_type", ""],
  info: ["column_info", ""],
  form: ["column_form", ""],
  status: ["column_status", ""],
  counter: ["column_counter", ""],
  life: ["column_life", ""],
  warn: ["column_warn", ""],
  H: ["column_h", ""],
  D: ["column_d", ""],
  S: ["column_s", "rpm"],
  F: ["column_f", "feed"],
};
const without_unit = ["tip", "tip_position"];

export interface ColumnTitle {
  text: string;
  unit: string;
}

/// `key` "": the table has one value in each row.
export function column_title(table: string, key: string): ColumnTitle {
  if (key === "") return { text: t("value"), unit: table === "correctors" ? t("mm") : "" };
  if (table === "offsets" && of_offsets[key])
    return { text: t(of_offsets[key]), unit: without_unit.includes(key) ? "" : t("mm") };
  const of_row = table === "tool_table" ? of_tool_table[key] : undefined;
  if (of_row) return { text: t(of_row[0]), unit: of_row[1] && t(of_row[1] === "rpm" ? "unit_rpm" : "unit_feed") };
  if (!["work_offsets", "zeros"].includes(table)) return { text: key, unit: "" };
  return { text: key, unit: /^[ABC]|^G1[789]$/.test(key) ? "°" : t("mm") };
}
