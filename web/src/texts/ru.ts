// Тексты страницы по-русски, словами цеха. Если ключа нет, сборка останавливается.
import { alone_ru } from "./ru/alone";
import { bar_ru } from "./ru/bar";
import { cut_ru } from "./ru/cut";
import { edit_ru } from "./ru/edit";
import { empty_ru } from "./ru/empty";
import { files_ru } from "./ru/files";
import { making_ru } from "./ru/making";
import { operator_ru } from "./ru/operator";
import { outline_ru } from "./ru/outline";
import { panel_ru } from "./ru/panel";
import { report_ru } from "./ru/report";
import { restart_ru } from "./ru/restart";
import { setup_ru } from "./ru/setup";
import { start_ru } from "./ru/start";
import { state_ru } from "./ru/state";
import { tables_ru } from "./ru/tables";
import { view_ru } from "./ru/view";
import type { TextKey } from "./en";

export const ru: Record<TextKey, string> = {
  ...bar_ru,
  ...view_ru,
  ...state_ru,
  ...start_ru,
  ...empty_ru,
  ...cut_ru,
  ...tables_ru,
  ...setup_ru,
  ...restart_ru,
  ...outline_ru,
  ...panel_ru,
  ...operator_ru,
  ...files_ru,
  ...making_ru,
  ...edit_ru,
  ...report_ru,
  ...alone_ru,
};
