// Tests the input for milling a drawing, the question that it gives, and which answers count.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Making } from "../src/model/making";
import { is_asked, number_of, question_of, type MillForm } from "../src/model/mill_form";
import { files_beneath, save_new } from "../src/model/new_file";
import { Refused } from "../src/protocol/client";
import type { Socket } from "../src/protocol/client";
import type { App } from "../src/model/app";
import type { MillQuestion } from "../src/protocol/types";

const full: MillForm = { drawing: "cover.txt", control: "mach3", task: "pocket", tool_diameter: "12", depth: "8" };

describe("the form", () => {
  it("makes a question of what is given, and of nothing else", () => {
    expect(question_of(full)).toEqual({
      question: { drawing: "cover.txt", control: "mach3", task: "pocket", tool_diameter: 12, depth: 8 },
    });
    expect(
      question_of({ ...full, pass: " 2,5 ", stepover: "40%", coolant: "on", feed: "", mark: "ПС", scheme: "" }),
    ).toEqual({
      question: {
        drawing: "cover.txt",
        control: "mach3",
        task: "pocket",
        tool_diameter: 12,
        depth: 8,
        pass: 2.5,
        stepover: "40%",
        coolant: true,
        mark: "ПС",
      },
    });
  });
  it("tells what is missing and what is no number", () => {
    expect(question_of({ control: "mach3", depth: " " })).toEqual({
      wrong: [],
      missing: ["drawing", "tool_diameter", "depth"],
    });
    for (const typed of ["1e9", "0x10", "NaN", "Infinity", "1.2.3", "-", "12 mm"])
      expect(question_of({ ...full, feed: typed })).toEqual({ wrong: ["feed"], missing: [] });
    expect([question_of({ ...full, tool: "1.5" }), question_of({ ...full, tool: "-1" })]).toEqual([
      { wrong: ["tool"], missing: [] },
      { wrong: ["tool"], missing: [] },
    ]);
    expect([number_of("-.5"), number_of("7."), number_of("."), number_of("")]).toEqual([-0.5, 7, null, null]);
  });
  it("sends no field that means nothing for what is chosen", () => {
    expect(
      question_of({ ...full, width: "20", ramp_angle: "5", plunge: "hole", hole: "X12,5 Y-3", angle: "30" }),
    ).toEqual({
      question: {
        drawing: "cover.txt",
        control: "mach3",
        task: "pocket",
        tool_diameter: 12,
        depth: 8,
        plunge: "hole",
        hole: [12.5, -3],
      },
    });
    expect(question_of({ ...full, plunge: "hole", hole: "somewhere" })).toEqual({ wrong: ["hole"], missing: [] });
    expect([
      is_asked({ task: "slot" }, "width"),
      is_asked({ task: "face" }, "angle"),
      is_asked({ scheme: "spiral-in" }, "angle"),
    ]).toEqual([true, true, false]);
  });
});

class Line implements Socket {
  binaryType = "";
  readyState = 0;
  asked: Record<string, unknown>[] = [];
  onopen: Socket["onopen"] = null;
  onclose: Socket["onclose"] = null;
  onmessage: Socket["onmessage"] = null;
  open(): void {
    this.readyState = 1;
    this.onopen?.({});
  }
  send(text: string): void {
    const q = JSON.parse(text) as Record<string, unknown>;
    this.asked.push(q);
    if (q.do !== "mill") this.answer(q, {});
  }
  close(): void {
    this.readyState = 3;
    this.onclose?.({});
  }
  answer(q: Record<string, unknown>, body: object): void {
    queueMicrotask(() => this.onmessage?.({ data: JSON.stringify({ re: q.id, ...body }) }));
  }
  get said(): unknown[] {
    return this.asked.map((q) => q.do);
  }
}
const settle = (): Promise<unknown> => vi.advanceTimersByTimeAsync(1);
const asked_for = (depth: number): MillQuestion => ({
  drawing: "a",
  control: "mach3",
  task: "pocket",
  tool_diameter: 4,
  depth,
});
const made = (text: string): object => ({ text, picture: "", summary: [], warning: "", name: "a.nc" });

describe("making", () => {
  beforeEach(() => {
    vi.useFakeTimers();
    vi.stubGlobal("location", { hash: "", pathname: "/", search: "" });
    vi.stubGlobal("sessionStorage", { getItem: () => "t", setItem: () => undefined });
  });
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });
  const opened = async (): Promise<[Making, Line]> => {
    const line = new Line(),
      making = new Making(() => line);
    line.open();
    await settle();
    return [making, line];
  };

  it("takes the newest answer only, and stops what is under way for it", async () => {
    const [making, line] = await opened();
    making.want(asked_for(1));
    making.want(asked_for(2));
    making.want(asked_for(3));
    await settle();
    expect(line.said).toEqual(["hello", "mill", "stop", "stop"]);
    line.answer(line.asked[1]!, { error: { text: "interrupted" } });
    await settle();
    expect([making.busy, making.refusal, making.program]).toEqual([true, "", null]);
    expect(line.asked.at(-1)).toMatchObject({ do: "mill", depth: 3 });
    line.answer(line.asked.at(-1)!, made("G1"));
    await settle();
    expect([making.busy, making.program?.text]).toEqual([false, "G1"]);
    making.want(asked_for(4));
    expect(making.program).toBeNull();
    making.want(null);
    line.answer(line.asked.at(-2)!, made("of something no longer wanted"));
    await settle();
    expect([making.busy, making.answer]).toEqual([false, null]);
  });
  it("asks again when a lost line is back, and tells a refusal", async () => {
    const lines: Line[] = [],
      making = new Making(() => {
        lines.push(new Line());
        return lines.at(-1)!;
      });
    making.want(asked_for(1));
    lines[0]!.open();
    await settle();
    lines[0]!.close();
    await vi.advanceTimersByTimeAsync(10_000);
    lines.at(-1)!.open();
    await settle();
    expect([making.busy, lines.at(-1)!.said]).toEqual([true, ["hello", "mill"]]);
    lines.at(-1)!.answer(lines.at(-1)!.asked[1]!, { error: { text: "no such drawing" } });
    await settle();
    expect([making.busy, making.refusal, making.program]).toEqual([false, "no such drawing", null]);
    making.want(asked_for(1), true);
    await settle();
    expect(lines.at(-1)!.said).toEqual(["hello", "mill", "mill"]);
  });
});

describe("a new file", () => {
  const app = (answers: (what: string, q: Record<string, unknown>) => unknown, opened: object = {}): App =>
    ({
      client: { ask: async (what: string, q: Record<string, unknown>) => answers(what, q) },
      tell: () => undefined,
      opened: null,
      ...opened,
    }) as unknown as App;
  const there = (what: string, q: Record<string, unknown>): unknown => {
    if (q.digest === null) throw new Refused("there is one", true);
    return { digest: "new", what };
  };

  it("never replaces what was not written here, and what was only when told", async () => {
    const yes = vi.fn(async () => true),
      no = vi.fn(async () => false);
    expect(await save_new(app(there), "other.nc", { text: "x" }, yes)).toContain("another name");
    expect(yes).not.toHaveBeenCalled();
    expect(
      await save_new(
        app(() => ({ digest: "d" })),
        "mine.nc",
        { text: "x" },
        yes,
      ),
    ).toBe("");
    expect(await save_new(app(there), "mine.nc", { text: "y" }, no)).toContain("another name");
    expect(await save_new(app(there), "mine.nc", { text: "y" }, yes)).toBe("");
    expect(
      await save_new(
        app(there, { opened: { file: "open.nc" }, digest: "o", dirty: false }),
        "open.nc",
        { text: "y" },
        yes,
      ),
    ).toBe("");
    expect(
      await save_new(
        app(there, { opened: { file: "open2.nc" }, digest: "o", dirty: true }),
        "open2.nc",
        { text: "y" },
        yes,
      ),
    ).toContain("another name");
  });
  it("tells why it was refused", async () => {
    expect(
      await save_new(
        app(() => {
          throw new Refused("a full disk");
        }),
        "x.nc",
        { text: "x" },
        async () => true,
      ),
    ).toBe("a full disk");
  });
  it("finds drawings in all folders, those of the shown one first, each once", async () => {
    const tree: Record<string, [string, string][]> = {
      "": [
        ["a.dxf", "other"],
        ["sub", "folder"],
        ["n.nc", "program"],
      ],
      sub: [
        ["b.svg", "other"],
        ["deep", "folder"],
      ],
      "sub/deep": [["c.txt", "program"]],
    };
    const a = app((_, q) => ({ entries: tree[q.folder as string]!.map(([name, kind]) => ({ name, kind })) }));
    expect(await files_beneath(a, "sub", (n) => !n.endsWith(".nc"))).toEqual(["sub/b.svg", "a.dxf", "sub/deep/c.txt"]);
  });
});
