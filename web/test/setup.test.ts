// The values of the set-up form: what is shown, and what is merged into the file.
import { describe, expect, it } from "vitest";
import { FormValues, number_in } from "../src/setup/form_values";
import type { SetupForm } from "../src/protocol/types";

const form = (more: Partial<SetupForm> = {}): SetupForm => ({
  file: "part.json",
  digest: null,
  in_force: false,
  stated: {},
  setups: [],
  tables: ["work_offsets", "offsets", "variables"],
  columns: ["length", "length_wear", "radius", "corner_radius"].map((key) => ({ key, about: key, unit: "mm" })),
  axes: ["X", "Y", "Z", "A"],
  rows: [
    { table: "work_offsets", row: "G54", word: "G54", line: 3, cells: [{ key: "X" }, { key: "Y" }, { key: "Z" }] },
    { table: "offsets", row: "1", word: "H1", line: 5, tool: 1, cells: [{ key: "length" }] },
    {
      table: "offsets",
      row: "1",
      word: "D1",
      line: 6,
      tool: 1,
      cells: [{ key: "radius", proposed: 4 }],
      by: { line: 1, text: "T1 D8 ENDMILL" },
    },
    { table: "variables", row: "#500", word: "#500", line: 9, cells: [{ key: "" }] },
    { table: "skip", row: "1", word: "/", line: 8, cells: [] },
  ],
  faults: 0,
  not_executed: [],
  ...more,
});

describe("the set-up form", () => {
  it("shows proposals, and merges them with what was typed", () => {
    const values = new FormValues(form());
    expect(values.value("offsets", "1", "radius")).toEqual({ text: "4", origin: "proposed" });
    expect(values.open()).toBe(5);
    values.set("work_offsets", "G54", "X", "-100,5");
    values.set("variables", "#500", "", "3");
    values.set_skip(1, true);
    expect(values.patch()).toEqual({
      offsets: { 1: { radius: 4 } },
      work_offsets: { G54: { X: -100.5 } },
      variables: { "#500": 3 },
      skip: [1],
    });
    expect(values.open()).toBe(3);
  });

  it("prefers the file to a proposal, and leaves what it states alone", () => {
    const values = new FormValues(form({ stated: { offsets: { 1: { radius: 5 }, 7: { length: 1 } }, skip: [2] } }));
    expect(values.value("offsets", "1", "radius")).toEqual({ text: "5", origin: "file" });
    expect(values.rows("offsets").map((r) => [r.name, r.uses.length])).toEqual([
      ["1", 2],
      ["7", 0],
    ]);
    expect(values.patch()).toEqual({});
    values.set("offsets", "1", "radius", "6");
    values.set("offsets", "1", "radius", "5");
    expect(values.touched).toBe(false);
    expect(values.skip(2)).toBe(true);
    values.set_skip(1, true);
    expect(values.patch()).toEqual({ skip: [1, 2] });
  });

  it("an emptied field removes the value, an emptied proposal is not written", () => {
    const values = new FormValues(form({ stated: { offsets: { 1: { length: 95 } } } }));
    values.set("offsets", "1", "length", "");
    values.set("offsets", "1", "radius", "");
    expect(values.patch()).toEqual({ offsets: { 1: { length: null } } });
  });

  it("keeps entries while the file is read anew", () => {
    const values = new FormValues(form());
    values.set("work_offsets", "G54", "X", "-201");
    values.renew(form({ digest: "2", stated: { work_offsets: { G54: { X: -200, Y: 7 } } } }));
    expect(values.value("work_offsets", "G54", "X").text).toBe("-201");
    expect(values.value("work_offsets", "G54", "Y")).toEqual({ text: "7", origin: "file" });
    const again = new FormValues(form());
    again.take_kept(values.kept());
    expect(again.patch()).toMatchObject({ work_offsets: { G54: { X: -201 } } });
  });

  it("zeroes a table, adds rows, and takes no text for a number", () => {
    const values = new FormValues(form());
    values.add_row("offsets", "9");
    values.set_all("offsets", "0");
    expect(values.patch()).toEqual({ offsets: { 1: { length: 0, radius: 0 }, 9: { length: 0, radius: 0 } } });
    values.set("offsets", "9", "length", "8x");
    expect(values.wrong()).toHaveLength(1);
    expect(["1", "-2.5", "+3,25", ".5", "7."].map(number_in)).toEqual([1, -2.5, 3.25, 0.5, 7]);
    expect(["", "8x", "1e3", "--1", "1.2.3"].map(number_in)).toEqual([null, null, null, null, null]);
  });
});
