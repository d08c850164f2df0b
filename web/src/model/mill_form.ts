// The milling form as it is typed: texts by the names of the options of kadr mill, and the question that they give.
import type { MillQuestion, MillTask } from "../protocol/types";

export const tasks = ["pocket", "face", "slot"] as const satisfies readonly MillTask[];
export const schemes = [
  "",
  "spiral-out",
  "spiral-in",
  "zigzag",
  "1zigzag",
  "2zigzag",
  "comb",
  "1comb",
  "2comb",
] as const; // "": the usual one for the task
export const plunges = ["ramp", "tangential", "hole"] as const;
export const directions = ["", "ccw", "cw"] as const; // "": climb milling
export const marks = ["", "ПС", "LF"] as const;

export const needed = ["tool_diameter", "depth"] as const;
export const lengths = ["tool_diameter", "depth", "pass", "allowance", "top", "clearance", "overrun", "width"] as const;
export const figures = [...lengths, "ramp_angle", "angle", "feed", "plunge_feed", "speed", "tool"] as const;
export type Figure = (typeof figures)[number];
export type Field =
  | Figure
  | "drawing"
  | "control"
  | "task"
  | "scheme"
  | "direction"
  | "stepover"
  | "plunge"
  | "hole"
  | "coolant"
  | "mark";
export type MillForm = Partial<Record<Field, string>>;

/// True if the field has a meaning for the current choices: other fields are neither shown nor sent.
export function is_asked(form: MillForm, field: Field): boolean {
  const scheme = form.scheme || (form.task === "face" ? "zigzag" : "spiral-out");
  if (field === "width") return form.task === "slot";
  if (field === "ramp_angle") return (form.plunge || "ramp") === "ramp";
  if (field === "hole") return form.plunge === "hole";
  if (field === "angle") return !scheme.startsWith("spiral");
  return true;
}

/// Returns the question, or the fields that are wrong (not numbers) and those that are still missing.
export function question_of(form: MillForm): { question: MillQuestion } | { wrong: Field[]; missing: Field[] } {
  const wrong: Field[] = [],
    missing: Field[] = (["drawing", "control", ...needed] as Field[]).filter((f) => !form[f]?.trim());
  const question: Record<string, unknown> = {
    drawing: form.drawing,
    control: form.control,
    task: form.task || "pocket",
  };
  for (const field of ["scheme", "direction", "stepover", "plunge", "mark"] as const)
    if (form[field]?.trim()) question[field] = form[field].trim().replace(",", ".");
  for (const field of figures) {
    const typed = form[field]?.trim();
    if (!typed || !is_asked(form, field)) continue;
    const value = number_of(typed);
    if (value === null || (field === "tool" && !/^\d+$/.test(typed))) wrong.push(field);
    else question[field] = value;
  }
  if (form.hole?.trim() && is_asked(form, "hole")) {
    const place = place_of(form.hole);
    if (place) question.hole = place;
    else wrong.push("hole");
  }
  if (form.coolant === "on") question.coolant = true;
  return wrong.length || missing.length ? { wrong, missing } : { question: question as unknown as MillQuestion };
}

/// Reads a number; a comma is a decimal point, as people type both.
export function number_of(typed: string): number | null {
  const plain = typed.trim().replace(",", ".");
  return /^[+-]?(\d+\.?\d*|\.\d+)$/.test(plain) ? Number(plain) : null;
}

/// "X12.5 Y-3", "12,5 -3".
function place_of(typed: string): [number, number] | null {
  const parts = typed.trim().replace(/[xX;]/g, " ").replace(/[yY]/g, " ").trim().split(/\s+/).map(number_of);
  return parts.length === 2 && parts.every((p) => p !== null) ? (parts as [number, number]) : null;
}
