// Marks in the view over the picture: start, end, alarms, stops, dwells, where they happen; figures of the extents,
// names of zones.
import type { Mark } from "../protocol/types";
import type { Point, View } from "../scene/types";
import { t, type TextKey } from "../texts/texts";
import { h, svg } from "./dom";
import { clock } from "./figures";

export type FlagKind = Mark["kind"] | "start" | "figure" | "zone" | "anchor";
export interface Flag {
  kind: FlagKind;
  at: Point;
  text: string;
  time?: number;
}

const most_flags = 150;
// Kinds in order of priority, if there are too many.
const grave: FlagKind[] = ["alarm", "start", "end", "stop", "warning", "optional_stop", "tool", "dwell"];
const signs: Partial<Record<FlagKind, string>> = {
  start: "M3 2 11 7 3 12Z",
  end: "M3 3h8v8H3Z",
  alarm: "M4.5 1h5L13 4.5v5L9.5 13h-5L1 9.5v-5Z",
  warning: "M7 1.5 13.5 12.5H.5Z",
  stop: "M4.5 1h5L13 4.5v5L9.5 13h-5L1 9.5v-5Z",
  optional_stop: "M4.5 1h5L13 4.5v5L9.5 13h-5L1 9.5v-5Z",
  tool: "M4.5 1h5v6H8.6v3L7 13l-1.6-3V7H4.5Z",
  dwell: "M3 1h8L7.8 7 11 13H3l3.2-6Z",
};

/// Returns the flags of a program; if there are too many, the most severe are kept. `place` returns the position of
/// the tool at an instant.
export function flags_of(marks: readonly Mark[], seconds: number, place: (at: number) => Point | null): Flag[] {
  const all: Flag[] = [];
  const add = (kind: FlagKind, time: number, text: string): void => {
    const at = place(time);
    if (at)
      all.push({
        kind,
        at,
        time,
        text: `${clock(time)}  ${t((kind === "start" ? "mark_start" : `mark_${kind}`) as TextKey)}${text ? `: ${text}` : ""}`,
      });
  };
  add("start", 0, "");
  const wanted = marks
    .filter((m) => grave.includes(m.kind) && m.kind !== "end")
    .sort((a, b) => grave.indexOf(a.kind) - grave.indexOf(b.kind))
    .slice(0, most_flags);
  for (const m of wanted) add(m.kind, m.at, m.text);
  if (!marks.some((m) => m.kind === "alarm")) add("end", seconds, "");
  return all;
}

/// One element per flag; their positions follow the view.
export class Flags {
  readonly element = h("div", { class: "flags" });
  private groups = new Map<string, { flag: Flag; element: HTMLElement }[]>();

  constructor(private go: (time: number) => void) {}

  set(group: string, flags: Flag[]): void {
    for (const f of this.groups.get(group) ?? []) f.element.remove();
    this.groups.set(
      group,
      flags.map((flag) => {
        const element = this.make(flag);
        this.element.append(element);
        return { flag, element };
      }),
    );
  }

  place(view: View, width: number, height: number): void {
    for (const group of this.groups.values())
      for (const { flag, element } of group) {
        const at = view.place(flag.at),
          seen = at && at[0] > -20 && at[1] > -20 && at[0] < width + 20 && at[1] < height + 20;
        element.style.visibility = seen ? "" : "hidden";
        if (seen) element.style.transform = `translate(${Math.round(at[0])}px, ${Math.round(at[1])}px)`;
      }
  }

  private make(flag: Flag): HTMLElement {
    const sign = signs[flag.kind],
      { time } = flag;
    if (!sign) return h("span", { class: `flag flag-${flag.kind}` }, flag.text);
    return h(
      "div",
      {
        class: `flag flag-sign flag-${flag.kind}`,
        title: flag.text,
        role: "img",
        "aria-label": flag.text,
        onclick: () => {
          if (time !== undefined) this.go(time);
        },
      },
      svg("svg", { viewBox: "0 0 14 14", "aria-hidden": "true" }, svg("path", { d: sign })),
    );
  }
}
