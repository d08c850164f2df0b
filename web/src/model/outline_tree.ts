// The outline of a program as a tree of which entries are open and closed: which rows are shown, which row a line belongs to, where a
// key leads. Without a browser.
import type { OutlineEntry } from "../protocol/types";

export class OutlineTree {
  private closed = new Set<string>(); // names of closed entries: they stay closed when the text changes
  private ends: number[] = []; // of each entry: the index after the last one inside it
  private parents: number[] = []; // -1: none
  private rows: number[] = [];

  constructor(private list: readonly OutlineEntry[] = []) {
    this.set(list);
  }

  set(list: readonly OutlineEntry[]): void {
    this.list = list;
    this.ends = list.map(() => list.length);
    this.parents = [];
    const open: number[] = [];
    list.forEach((entry, i) => {
      while (open.length && list[open.at(-1)!]!.depth >= entry.depth) this.ends[open.pop()!] = i;
      this.parents.push(open.at(-1) ?? -1);
      open.push(i);
    });
    this.find_rows();
  }

  get entries(): readonly OutlineEntry[] {
    return this.list;
  }
  /// The indices of the entries that are shown.
  get shown(): readonly number[] {
    return this.rows;
  }
  parent(i: number): number {
    return this.parents[i] ?? -1;
  }
  has_inside(i: number): boolean {
    return this.ends[i]! > i + 1;
  }
  is_open(i: number): boolean {
    return !this.closed.has(this.key(i));
  }
  /// Opens or closes an entry that has others inside.
  toggle(i: number): void {
    const key = this.key(i);
    if (!this.has_inside(i)) return;
    if (!this.closed.delete(key)) this.closed.add(key);
    this.find_rows();
  }
  /// The number of entries with the same parent, and the place of this one among them, from 1.
  among(i: number): { place: number; count: number } {
    const parent = this.parent(i);
    let place = 0,
      count = 0;
    for (let k = parent + 1; k < (parent < 0 ? this.list.length : this.ends[parent]!); k = this.ends[k]!) {
      count++;
      if (k <= i) place = count;
    }
    return { place, count };
  }

  /// Returns the innermost entry that is shown and contains the line; -1 if there is none.
  at_line(line: number): number {
    let found = -1;
    for (const i of this.rows) if (this.list[i]!.line <= line && line <= this.list[i]!.last) found = i;
    return found;
  }

  /// Returns where a key leads from an entry, and opens or closes it (ARIA, "Tree View"); null for any other key.
  press(key: string, from: number, page: number): number | null {
    const row = this.rows.indexOf(from),
      last = this.rows.length - 1;
    const to = (n: number): number => this.rows[Math.min(last, Math.max(0, n))] ?? from;
    switch (key) {
      case "ArrowDown":
        return to(row + 1);
      case "ArrowUp":
        return to(row - 1);
      case "PageDown":
        return to(row + page);
      case "PageUp":
        return to(row - page);
      case "Home":
        return to(0);
      case "End":
        return to(last);
      case "ArrowRight":
        if (!this.has_inside(from)) return from;
        if (this.is_open(from)) return from + 1;
        this.toggle(from);
        return from;
      case "ArrowLeft":
        if (!this.has_inside(from) || !this.is_open(from)) return this.parent(from) < 0 ? from : this.parent(from);
        this.toggle(from);
        return from;
      default:
        return null;
    }
  }

  private key(i: number): string {
    const entry = this.list[i]!,
      parent = this.parent(i);
    return `${parent < 0 ? "" : this.list[parent]!.name}/${entry.kind} ${entry.name}`;
  }
  private find_rows(): void {
    this.rows = [];
    for (let i = 0; i < this.list.length; i = this.is_open(i) ? i + 1 : this.ends[i]!) this.rows.push(i);
  }
}
