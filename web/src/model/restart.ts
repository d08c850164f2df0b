// Restarting in the middle of a program: the server finds the position; the approach is shown, changed, and executed.
import type { Axes, ChannelWay, RestartPlace, RestartSheet, WayPoint } from "../protocol/types";
import type { Operator } from "./operator";
import { Signal } from "./signal";

const ask_again = 100; // ms between requests during the search

export interface WayRules {
  clearance?: number;
  above: number;
  feed: number;
}

export class Restart {
  sheet: RestartSheet | null = null;
  ways: ChannelWay[] = []; // in the order in which they will be executed
  leave = new Set<string>(); // keys of what is not changed
  searching = false;
  place: RestartPlace | null = null;
  rules: WayRules = { above: 2, feed: 300 };
  readonly on_change = new Signal<void>();
  private search = 0; // a new search ends the one before

  constructor(private operator: Operator) {
    operator.on_panel.on((p) => {
      if (!p && (this.sheet || this.searching)) this.forget();
    });
  }

  /// The approach of a channel; 0: the program's own.
  way(channel = 0): WayPoint[] {
    return this.ways.find((w) => w.channel === (channel || this.sheet?.number))?.way ?? [];
  }

  /// `by_control`: also requests the control's own block search.
  async find(place: RestartPlace, by_control = false): Promise<void> {
    const mine = ++this.search;
    this.place = place;
    this.searching = true;
    this.on_change.emit();
    while (true) {
      const answer = await this.operator.ask(
        "restart",
        { ...place, ...this.rules, ...(by_control || this.sheet?.search ? { by_control: true } : {}) },
        false,
      );
      if (mine !== this.search) return;
      if (answer && !answer.ready) {
        await new Promise((go) => setTimeout(go, ask_again));
        continue;
      }
      this.searching = false;
      if (answer?.ready) this.take(answer as RestartSheet);
      return this.on_change.emit();
    }
  }

  /// Changes the rules; the approach is computed again.
  set_rules(rules: Partial<WayRules>): void {
    this.rules = { ...this.rules, ...rules };
    if (this.place) void this.find(this.place);
  }

  set_point(i: number, axis: string, work: number, channel = 0): void {
    const point = this.way(channel)[i],
      of = this.sheet?.beside.find((b) => b.number === channel) ?? this.sheet;
    if (!point || !of || !Number.isFinite(work)) return;
    point.to[axis] = work + (of.zero[axis] ?? 0);
    this.on_change.emit();
  }

  /// Moves this channel's approach before those of the others.
  go_first(channel: number): void {
    this.ways.sort((a, b) => Number(b.channel === channel) - Number(a.channel === channel));
    this.on_change.emit();
  }

  set_leave(key: string, leaves: boolean): void {
    if (leaves) this.leave.add(key);
    else this.leave.delete(key);
    this.on_change.emit();
  }

  async go(): Promise<void> {
    if (!this.place || !this.sheet) return;
    const went = await this.operator.ask("go_there", {
      ...this.place,
      ...(this.sheet.search ? { by_control: true } : {}),
      leave: [...this.leave],
      ways: this.ways,
    });
    if (went) this.forget();
  }

  forget(): void {
    this.search++;
    this.sheet = this.place = null;
    this.searching = false;
    this.ways = [];
    this.leave.clear();
    this.on_change.emit();
  }

  /// Positions of the tool's tip along the approach, in the coordinates of the path's frames.
  tips(): [number, number, number][] {
    const { sheet } = this,
      from = this.operator.panel?.machine;
    if (!sheet || !from || !this.way().length) return [];
    const origin: Axes = {};
    for (const r of sheet.rows) if (r.kind === "origin" && typeof r.wanted === "number") origin[r.name] = r.wanted;
    const at = { ...from };
    const tip = (axis: string): number => (at[axis] ?? 0) - (sheet.zero[axis] ?? 0) + (origin[axis] ?? 0);
    const tips: [number, number, number][] = [[tip("X"), tip("Y"), tip("Z")]];
    for (const p of this.way()) {
      Object.assign(at, p.to);
      tips.push([tip("X"), tip("Y"), tip("Z")]);
    }
    return tips;
  }

  private take(sheet: RestartSheet): void {
    const order = this.ways.map((w) => w.channel),
      copy = (way: WayPoint[]): WayPoint[] => way.map((p) => ({ ...p, to: { ...p.to } }));
    this.sheet = sheet;
    this.ways = [sheet, ...sheet.beside].map((s) => ({ channel: s.number, way: copy(s.way) }));
    if (order.length === this.ways.length)
      this.ways.sort((a, b) => order.indexOf(a.channel) - order.indexOf(b.channel)); // keeps the chosen order
    const rows = [sheet, ...sheet.beside].flatMap((s) => s.rows);
    for (const key of [...this.leave]) if (!rows.some((r) => r.key === key && r.may_be_left)) this.leave.delete(key);
  }
}
