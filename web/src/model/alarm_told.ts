// The text of an alarm with its number, unless the text of the control begins with it.
import type { Problem } from "../protocol/types";

export const alarm_told = ({ number, text }: Pick<Problem, "number" | "text">): string =>
  number && !text.slice(0, 12).includes(String(number)) ? `${number} ${text}` : text;
