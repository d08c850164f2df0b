// Tests the virtual view and the words of the source.
import { expect, test } from "vitest";
import { greatest_height, ScrollMap } from "../src/source/virtual_map";
import { token_at } from "../src/source/tokens";

test("a short text is not scaled", () => {
  const m = new ScrollMap(1000, 20, 400);
  expect([m.height, m.scaled, m.top_of(300), m.scroll_of(300)]).toEqual([20000, false, 300, 300]);
  expect(m.seen(30)).toEqual({ first: 2, count: 21 });
});

test("of five million lines the first and the last are reached, and every one is", () => {
  const m = new ScrollMap(5_000_000, 20, 400);
  expect(m.height).toBe(greatest_height);
  expect(m.seen(m.top_of(0)).first).toBe(1);
  const end = m.seen(m.bounded(m.top_of(m.height - m.view)));
  expect(end.first + end.count - 1).toBe(5_000_000);
  for (const line of [1, 2, 77, 2_345_678, 4_999_999, 5_000_000]) {
    const seen = m.seen(m.top_showing(line, 0));
    expect(line >= seen.first && line < seen.first + seen.count).toBe(true);
  }
  for (const top of [0, 12345, 99_999_600]) expect(m.top_of(m.scroll_of(top))).toBeCloseTo(top, 4);
});

test("a line that is seen does not make the text jump", () => {
  const m = new ScrollMap(1000, 20, 400);
  expect(m.top_showing(10, 100)).toBe(100);
  expect(m.top_showing(900, 100)).toBe(899 * 20 - 190);
});

test("fewer lines than the view holds; none at all", () => {
  expect(new ScrollMap(3, 20, 400).seen(0)).toEqual({ first: 1, count: 3 });
  expect(new ScrollMap(0, 20, 400).seen(0)).toEqual({ first: 1, count: 0 });
});

const words = (line: string): string[] => {
  const out: string[] = [];
  for (let i = 0; i < line.length;) {
    const { kind, length } = token_at(line, i);
    if (kind) out.push(`${kind}:${line.slice(i, i + length)}`);
    i += length;
  }
  return out;
};

test("parentheses of a block with names are no comments", () => {
  expect(words("N10 MCALL CYCLE81(20,0) ; holes")).toEqual([
    "label:N10",
    "keyword:MCALL",
    "keyword:CYCLE81",
    "number:20",
    "number:0",
    "comment:; holes",
  ]);
  expect(words("G2 X=IC(5) CR=3")).toEqual([
    "motion:G2",
    "axis:X",
    "keyword:IC",
    "number:5",
    "variable:CR",
    "number:3",
  ]);
  expect(words('MSG("a (b) X1")')).toEqual(["keyword:MSG", 'program:"a (b) X1"']);
  for (const line of ["G0 X10(home)", "M6 (T1)", "#1=5 (depth)", "END1 (end)", "G91G28Z0(up)"])
    expect(words(line).at(-1)).toMatch(/^comment:\(/);
});

test("conversational blocks", () => {
  expect(words("12 L X+10 IY-5.5 R0 FMAX M3 ; to the start")).toEqual([
    "label:12",
    "motion:L",
    "axis:X+10",
    "axis:IY-5.5",
    "axis:R0",
    "feed:FMAX",
    "function:M3",
    "comment:; to the start",
  ]);
  expect(words("C X+Q5 Y+0 DR-")).toEqual(["motion:C", "axis:X", "variable:+Q5", "axis:Y+0", "axis:DR-"]);
  expect(words("CALL LBL 5 REP 2")).toEqual(["keyword:CALL LBL", "number:5", "keyword:REP", "number:2"]);
  expect(words("* - ROUGHING")).toEqual(["comment:* - ROUGHING"]);
  expect(words("C90 L1 X5")).toEqual(["axis:C90", "axis:L1", "axis:X5"]);
});

test("words of a line", () => {
  expect(words("N10 G1 X-1.5 F200 M8 (note) ; end")).toEqual([
    "label:N10",
    "motion:G1",
    "axis:X-1.5",
    "feed:F200",
    "function:M8",
    "comment:(note)",
    "comment:; end",
  ]);
  expect(words("IF [#<x> GT 3] GOTO 20")).toEqual([
    "keyword:IF",
    "variable:#<x>",
    "keyword:GT",
    "number:3",
    "keyword:GOTO",
    "number:20",
  ]);
  expect(words("O<sub> CALL [#5]")).toEqual(["program:O<sub>", "keyword:CALL", "variable:#5"]);
  expect(words("(open")).toEqual(["comment:(open"]);
  expect(words("Ю&!")).toEqual([]);
  expect(words(`(${"x".repeat(1000)})G1`)[1]).toBe("motion:G1");
});
