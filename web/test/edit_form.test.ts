import { describe, expect, it } from "vitest";
import { blocks_question, holes_of, motion_at, with_lines } from "../src/editing/blocks_form";
import { edit_question, edits, figure_of, words_of, wrong_field, type EditName } from "../src/editing/edit_form";

describe("the words of an edit", () => {
  it("are those of kadr edit", () => {
    expect(words_of("feed", { percent: "80", tool: "3" })).toEqual({ feed: ["T3=80%"] });
    expect(words_of("feed", { percent: "80" })).toEqual({ feed: ["80%"] });
    expect(words_of("mirror", { axis: "Y", line: "−2,5" })).toEqual({ mirror: "Y=-2.5" });
    expect(words_of("rotate", { degrees: "30", x: "1", y: "2" })).toEqual({ rotate: "30@1,2" });
    expect(words_of("shift", { x: "0", y: "1.5", z: "-0.2" })).toEqual({ shift: ["Y1.5", "Z-0.2"] });
    expect(words_of("copy", { columns: "3", rows: "2", dx: "30", dy: "20" })).toEqual({ copy: "3x2:30,20" });
    expect(words_of("copy_around", { count: "6", step: "60" })).toEqual({ copy: "6@60:0,0" });
    expect(words_of("reverse", { from: "4", to: "9" })).toEqual({ reverse: "4-9" });
    expect(words_of("tidy", { comments: "on", apart: "on" })).toEqual({ strip: ["comments"], add: "spaces" });
    expect(words_of("replace_zero", { from: "g54", to: "g54.1p3" })).toEqual({ "replace-zero": ["G54=G54.1P3"] });
  });
  it("are none where nothing is asked for", () => {
    expect(words_of("shift", {})).toBeNull();
    expect(words_of("tidy", {})).toBeNull();
  });
  it("are none while a field is wrong, and the field is named", () => {
    expect(wrong_field("feed", { percent: "much" })).toBe("percent");
    expect(words_of("feed", { percent: "much" })).toBeNull();
    expect(wrong_field("renumber", { first: "1.5" })).toBe("first");
    expect(wrong_field("replace_tool", { from: "3", to: "" })).toBe("to");
    expect(wrong_field("feed", { percent: "80", tool: "" })).toBeNull();
  });
  it("exist for every edit with its usual values or ask for what is missing", () => {
    for (const name of Object.keys(edits) as EditName[]) {
      const missing = wrong_field(name, {});
      expect(missing === null || edits[name].some((f) => f.name === missing && f.usual === "")).toBe(true);
    }
  });
});

it("reads figures as people type them", () => {
  expect(figure_of(" 1,5 ")).toBe(1.5);
  expect(figure_of("-.5")).toBe(-0.5);
  expect(figure_of("1e5")).toBeNull();
  expect(figure_of("")).toBeNull();
});

it("asks with the text of the editor and the choices of the program", () => {
  const app = {
    opened: { file: "a.nc", control: { id: "fanuc" } },
    choice: { setup: "a.json" },
    tables: null,
    text: "G0 X1\n",
  } as unknown as Parameters<typeof edit_question>[0];
  expect(edit_question(app, { mirror: "X=0" })).toEqual({
    file: "a.nc",
    control: "fanuc",
    setup: "a.json",
    text: "G0 X1\n",
    edits: { mirror: "X=0" },
  });
  expect(edit_question(app, null)).toBeNull();
  expect(edit_question({ ...app, text: null }, { mirror: "X=0" })).toBeNull();
});

describe("written blocks", () => {
  it("ask with all figures, or not at all", () => {
    const cycle = {
      code: "G83",
      title: "",
      words: [
        { letter: "Z", needed: true },
        { letter: "P", needed: false },
      ],
    };
    const values = { Z: "-5", holes: "1 2\nX3 Y4,5\n" };
    expect(blocks_question("cycle", values, cycle, "mm")).toEqual({
      what: "cycle",
      code: "G83",
      retract: "",
      values: { Z: -5 },
      holes: [
        [1, 2],
        [3, 4.5],
      ],
      unit: "mm",
    });
    expect(blocks_question("cycle", { ...values, Z: "" }, cycle, "mm")).toBeNull();
    expect(blocks_question("cycle", { ...values, P: "x" }, cycle, "mm")).toBeNull();
    expect(blocks_question("arc", { from_x: "0", from_y: "0" }, undefined, "mm")).toBeNull();
    expect(holes_of("1 2 3")).toBeNull();
    expect(holes_of("")).toBeNull();
  });
  it("stand after their line, and put the motion code in force again", () => {
    expect(with_lines("a\nb\n", 1, ["x", "y"])).toBe("a\nx\ny\nb\n");
    const modal = [{ group: "1", code: "G0" }] as Parameters<typeof motion_at>[0] extends infer S
      ? S extends { modal: infer M }
        ? M
        : never
      : never;
    expect(motion_at({ line: 5, modal }, 5)).toBe("G0");
    expect(motion_at({ line: 5, modal }, 6)).toBeNull();
    expect(motion_at({ line: 5, file: 1, modal }, 5)).toBeNull();
    expect(motion_at(null, 5)).toBeNull();
  });
});
