// The work offset in force, set so that axes read zero where they stand.
import type { Axes, Json, JsonTable } from "../protocol/types";
import type { Operator } from "./operator";

const table = (of: Json | undefined): JsonTable => (of && typeof of === "object" && !Array.isArray(of) ? of : {});

/// The code of the work offset in force that a table can set; null: there is none.
export const offset_code = (operator: Operator): string | null =>
  operator.panel?.modal.find((m) => /^G5[4-9]$/.test(m.code))?.code ?? null;

/// Sets the work offset in force so that these axes read these values, mm of true length. Returns false if it was refused.
export async function set_zero(operator: Operator, reads: Axes): Promise<boolean> {
  const code = offset_code(operator),
    tables = await operator.ask("tables", {}, false),
    p = operator.panel;
  if (!code || !tables || !p || !tables.sections.includes("work_offsets")) return false;
  const row: JsonTable = {};
  for (const [axis, value] of Object.entries(reads)) {
    const here = p.position[axis],
      old =
        table(table(tables.edited["work_offsets"])[code])[axis] ??
        table(table(tables.file["work_offsets"])[code])[axis] ??
        0;
    if (here !== undefined) row[axis] = Math.round(1e6 * (Number(old) + here - value)) / 1e6;
  }
  return (await operator.ask("edit", { tables: { work_offsets: { [code]: row } } })) !== null;
}
