// Русские тексты: структура программы.
import type { outline_en } from "../en/outline";

export const outline_ru: Record<keyof typeof outline_en, string> = {
  outline: "Структура",
  outline_more: "первые {count} записей",
};
