// Every text of the page in English: the keys that all other tables must have. Each area has a file of its own.
import { alone_en } from "./en/alone";
import { bar_en } from "./en/bar";
import { cut_en } from "./en/cut";
import { edit_en } from "./en/edit";
import { empty_en } from "./en/empty";
import { files_en } from "./en/files";
import { making_en } from "./en/making";
import { operator_en } from "./en/operator";
import { outline_en } from "./en/outline";
import { panel_en } from "./en/panel";
import { report_en } from "./en/report";
import { restart_en } from "./en/restart";
import { setup_en } from "./en/setup";
import { start_en } from "./en/start";
import { state_en } from "./en/state";
import { tables_en } from "./en/tables";
import { view_en } from "./en/view";

export const en = {
  ...bar_en,
  ...view_en,
  ...state_en,
  ...start_en,
  ...empty_en,
  ...cut_en,
  ...tables_en,
  ...setup_en,
  ...restart_en,
  ...outline_en,
  ...panel_en,
  ...operator_en,
  ...files_en,
  ...making_en,
  ...edit_en,
  ...report_en,
  ...alone_en,
};
export type TextKey = keyof typeof en;
