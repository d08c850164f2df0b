// The values of a set-up form: what the user typed, else what the set-up file states, else what comments propose.
import type { Json, JsonTable, SetupForm, SetupRow } from "../protocol/types";

const as_table = (of: Json | undefined): JsonTable =>
  of && typeof of === "object" && !Array.isArray(of) ? (of as JsonTable) : {};

/// The name of a value: table, row and column; column "" for a row that is one value.
export const place_of = (table: string, row: string, column: string): string => `${table}\t${row}\t${column}`;

export type Origin = "typed" | "file" | "proposed" | "open";
export interface FormValue {
  text: string;
  origin: Origin;
}

/// A row of a table as the form shows it.
export interface FormRow {
  name: string;
  uses: SetupRow[]; // empty: the file states it, the program does not use it
}

/// On a lathe the lengths along the axes come before the nose.
const is_axis = (key: string): boolean => /^[XYZ](_wear)?$/.test(key);
const by_number = (a: string, b: string): number => a.localeCompare(b, "en", { numeric: true });

export class FormValues {
  private typed = new Map<string, string>();
  private added = new Map<string, Set<string>>(); // rows that the user has added, by table
  private skipped: Set<number> | null = null; // switches as the user has set them
  private stops: boolean | null = null;

  constructor(public form: SetupForm) {}

  /// Takes the file as it is now; what was typed stays.
  renew(form: SetupForm): void {
    this.form = form;
  }

  get touched(): boolean {
    return this.typed.size > 0 || this.skipped !== null || this.stops !== null;
  }
  forget(): void {
    this.typed.clear();
    this.added.clear();
    this.skipped = this.stops = null;
  }

  rows(table: string): FormRow[] {
    const names = new Set([
      ...this.form.rows.filter((r) => r.table === table).map((r) => r.row),
      ...Object.keys(as_table(this.form.stated[table])),
      ...(this.added.get(table) ?? []),
    ]);
    return [...names].sort(by_number).map((name) => ({
      name,
      uses: this.form.rows.filter((r) => r.table === table && r.row === name),
    }));
  }
  add_row(table: string, name: string): void {
    if (!this.added.has(table)) this.added.set(table, new Set());
    this.added.get(table)!.add(name);
  }

  /// The columns that some row uses or states, in the order of the control's table.
  columns(table: string): string[] {
    if (["correctors", "variables"].includes(table)) return [""];
    if (table !== "offsets") return this.axes_of(table);
    const wanted = new Set(this.form.rows.filter((r) => r.table === table).flatMap((r) => r.cells.map((c) => c.key)));
    for (const row of Object.values(as_table(this.form.stated[table])))
      for (const key of Object.keys(as_table(row))) wanted.add(key);
    for (const place of this.typed.keys()) if (place.startsWith(`${table}\t`)) wanted.add(place.split("\t")[2]!);
    const known = this.form.columns.map((c) => c.key).sort((a, b) => Number(is_axis(b)) - Number(is_axis(a)));
    return [...known.filter((k) => wanted.has(k)), ...[...wanted].filter((k) => !known.includes(k))];
  }
  private axes_of(table: string): string[] {
    const axes = new Set(this.form.rows.filter((r) => r.table === table).flatMap((r) => r.cells.map((c) => c.key)));
    for (const row of Object.values(as_table(this.form.stated[table])))
      for (const axis of Object.keys(as_table(row))) axes.add(axis);
    if (!axes.size) for (const axis of this.form.axes.slice(0, 3)) axes.add(axis);
    return [...this.form.axes.filter((a) => axes.has(a)), ...[...axes].filter((a) => !this.form.axes.includes(a))];
  }

  stated(table: string, row: string, column: string): Json | undefined {
    const of = as_table(this.form.stated[table])[row];
    return column === "" ? of : as_table(of)[column];
  }
  proposed(table: string, row: string, column: string): number | undefined {
    for (const use of this.form.rows)
      if (use.table === table && use.row === row)
        for (const cell of use.cells) if (cell.key === column && cell.proposed !== undefined) return cell.proposed;
    return undefined;
  }
  value(table: string, row: string, column: string): FormValue {
    const typed = this.typed.get(place_of(table, row, column));
    if (typed !== undefined) return { text: typed, origin: "typed" };
    const file = this.stated(table, row, column);
    if (file !== undefined && file !== null)
      return { text: typeof file === "object" ? JSON.stringify(file) : String(file), origin: "file" };
    const proposed = this.proposed(table, row, column);
    return proposed === undefined
      ? { text: "", origin: "open" }
      : { text: String(Math.round(1e6 * proposed) / 1e6), origin: "proposed" };
  }
  set(table: string, row: string, column: string, text: string): void {
    const place = place_of(table, row, column);
    this.typed.delete(place);
    if (text.trim() !== this.value(table, row, column).text) this.typed.set(place, text.trim());
  }
  /// Sets every value of a table's rows.
  set_all(table: string, text: string): void {
    for (const row of this.rows(table))
      for (const column of this.columns(table)) this.set(table, row.name, column, text);
  }

  skip(n: number): boolean {
    if (this.skipped) return this.skipped.has(n);
    const on = this.form.stated["skip"];
    return Array.isArray(on) && on.includes(n);
  }
  set_skip(n: number, on: boolean): void {
    if (!this.skipped) {
      const stated = this.form.stated["skip"];
      this.skipped = new Set(Array.isArray(stated) ? stated.map(Number) : []);
    }
    if (on) this.skipped.add(n);
    else this.skipped.delete(n);
  }
  get optional_stop(): boolean {
    return this.stops ?? this.form.stated["optional_stop"] === true;
  }
  set optional_stop(on: boolean) {
    this.stops = on;
  }

  /// Places whose text is no number.
  wrong(): string[] {
    return [...this.typed].filter(([, text]) => text !== "" && number_in(text) === null).map(([place]) => place);
  }
  /// Values that nobody has stated yet. Wear that is not stated is 0.
  open(): number {
    let n = 0;
    for (const use of this.form.rows)
      for (const cell of use.cells)
        if (
          this.form.tables.includes(use.table) &&
          !cell.key.endsWith("_wear") &&
          this.value(use.table, use.row, cell.key).origin === "open"
        )
          n++;
    return n;
  }

  /// What has to be merged into the file (RFC 7386): typed values and proposals.
  patch(): JsonTable {
    const patch: JsonTable = {};
    const put = (table: string, row: string, column: string, value: Json): void => {
      const rows = (patch[table] ??= {}) as JsonTable;
      if (column === "") rows[row] = value;
      else ((rows[row] ??= {}) as JsonTable)[column] = value;
    };
    for (const use of this.form.rows)
      for (const { key } of use.cells) {
        const { text, origin } = this.value(use.table, use.row, key);
        if (origin === "proposed") put(use.table, use.row, key, number_in(text));
      }
    for (const [place, text] of this.typed) {
      const [table, row, column] = place.split("\t") as [string, string, string];
      const gone = text === "" && this.stated(table, row, column) === undefined;
      if (!gone) put(table, row, column, number_in(text));
    }
    if (this.skipped) patch["skip"] = [...this.skipped].sort((a, b) => a - b);
    if (this.stops !== null) patch["optional_stop"] = this.stops;
    return patch;
  }

  /// For a reload of the page.
  kept(): [string, string][] {
    return [...this.typed];
  }
  take_kept(kept: [string, string][]): void {
    for (const [place, text] of kept) {
      this.typed.set(place, text);
      const [table, row] = place.split("\t") as [string, string];
      if (!this.rows(table).some((r) => r.name === row)) this.add_row(table, row);
    }
  }
}

/// Reads a number with a point or a comma; null for anything else.
export function number_in(text: string): number | null {
  const s = text.trim().replace(",", ".");
  return /^[+-]?(\d+\.?\d*|\.\d+)$/.test(s) ? Number(s) : null;
}
