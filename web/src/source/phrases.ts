// CodeMirror's own texts in Russian: its search panels, its folded ranges, its names for screen readers.
import { Compartment, EditorState, type Extension } from "@codemirror/state";
import { language } from "../texts/texts";

const russian: Record<string, string> = {
  Find: "Найти",
  Replace: "Заменить на",
  next: "дальше",
  previous: "назад",
  all: "все",
  "match case": "регистр",
  "by word": "слово целиком",
  regexp: "рег. выражение",
  replace: "заменить",
  "replace all": "заменить все",
  close: "закрыть",
  "current match": "текущее совпадение",
  "on line": "в строке",
  "replaced match on line $": "заменено в строке $",
  "replaced $ matches": "заменено: $",
  "Go to line": "Перейти к строке",
  go: "перейти",
  "$ unchanged lines": "без изменений, строк: $",
  "Control character": "Управляющий символ",
  "Selection deleted": "Выделенное удалено",
  Diagnostics: "Ошибки",
  "No diagnostics": "Ошибок нет",
};

export const phrases = new Compartment();
export const phrases_now = (): Extension => EditorState.phrases.of(language() === "ru" ? russian : {});
