// Tests the tree of the structure: rows that are shown, the row of a line, where keys lead.
import { expect, test } from "vitest";
import { OutlineTree } from "../src/model/outline_tree";
import type { OutlineEntry } from "../src/protocol/types";

const entry = (depth: number, name: string, line: number, last: number): OutlineEntry => ({
  kind: depth === 0 ? "program" : depth === 1 ? "tool" : "cycle",
  name,
  line,
  last,
  depth,
});
const two_programs = [
  entry(0, "O1", 1, 30), // 0
  entry(1, "T1 FACE MILL", 3, 10), // 1
  entry(1, "T2 DRILL", 11, 30), // 2
  entry(2, "G81", 12, 20), // 3
  entry(2, "G83", 22, 30), // 4
  entry(0, "O200", 31, 40), // 5
];

test("a line belongs to the innermost entry around it", () => {
  const tree = new OutlineTree(two_programs);
  const at = [0, 1, 2, 3, 11, 15, 21, 22, 35, 41].map((line) => tree.at_line(line));
  expect(at).toEqual([-1, 0, 0, 1, 2, 3, 2, 4, 5, -1]);
});

test("in a closed entry it belongs to the entry that is shown", () => {
  const tree = new OutlineTree(two_programs);
  tree.toggle(2);
  expect(tree.shown).toEqual([0, 1, 2, 5]);
  expect(tree.at_line(15)).toBe(2);
  tree.toggle(0);
  expect(tree.shown).toEqual([0, 5]);
  expect(tree.at_line(15)).toBe(0);
  tree.toggle(0);
  expect(tree.shown).toEqual([0, 1, 2, 5]);
});

test("what is closed stays closed when lines are inserted before it", () => {
  const tree = new OutlineTree(two_programs);
  tree.toggle(2);
  tree.set([entry(0, "O0", 1, 1), ...two_programs.map((e) => ({ ...e, line: e.line + 1, last: e.last + 1 }))]);
  expect(tree.shown).toEqual([0, 1, 2, 3, 6]);
});

test("places among those with the same parent", () => {
  const tree = new OutlineTree(two_programs);
  const among = two_programs.map((_, i) => tree.among(i));
  expect(among.map(({ place, count }) => `${place}/${count}`)).toEqual(["1/2", "1/2", "2/2", "1/2", "2/2", "2/2"]);
});

test.each([
  ["ArrowDown", 0, 1],
  ["ArrowDown", 5, 5],
  ["ArrowUp", 5, 4],
  ["ArrowUp", 0, 0],
  ["Home", 4, 0],
  ["End", 0, 5],
  ["PageDown", 0, 3],
  ["PageUp", 5, 2],
  ["ArrowRight", 0, 1],
  ["ArrowRight", 1, 1],
  ["ArrowLeft", 3, 2],
  ["ArrowLeft", 1, 0],
  ["ArrowLeft", 5, 5],
  ["a", 0, null],
])("%s from %i leads to %s", (key, from, to) => {
  expect(new OutlineTree(two_programs).press(key, from, 3)).toBe(to);
});

test("arrows close and open", () => {
  const tree = new OutlineTree(two_programs);
  expect(tree.press("ArrowLeft", 2, 1)).toBe(2);
  expect([tree.is_open(2), tree.shown]).toEqual([false, [0, 1, 2, 5]]);
  expect(tree.press("ArrowDown", 2, 1)).toBe(5);
  expect(tree.press("ArrowRight", 2, 1)).toBe(2);
  expect(tree.is_open(2)).toBe(true);
});

test("nothing at all", () => {
  const tree = new OutlineTree();
  expect([tree.shown, tree.at_line(1), tree.press("ArrowDown", 0, 1)]).toEqual([[], -1, 0]);
});
