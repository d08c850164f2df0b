// Tests the question of a conversion, how the answer is shown and saved, and that a long conversion is stopped.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { App } from "../src/model/app";
import { beginning_of, by_reason, conversion_of, says_something, setup_name_of } from "../src/model/convert_form";
import { LongQuestion } from "../src/model/long_question";
import type { Socket } from "../src/protocol/client";
import type { ConvertQuestion } from "../src/protocol/types";

const app = (more: Partial<App> = {}): App =>
  ({
    opened: { file: "a/flange.nc", control: { id: "s2c42" } },
    choice: {},
    tables: null,
    text: "G1 X1",
    ...more,
  }) as unknown as App;
const form = { to: "mach3", flat: false, force: false };

describe("the question", () => {
  it("names the program with its choices, and only what is wanted", () => {
    expect(conversion_of(app(), form)).toEqual({ file: "a/flange.nc", control: "s2c42", to: "mach3" });
    expect(
      conversion_of(app({ choice: { control: "own.toml", machine: "mill3", setup: "flange.json" } }), {
        ...form,
        flat: true,
        force: true,
      }),
    ).toEqual({
      file: "a/flange.nc",
      control: "own.toml",
      machine: "mill3",
      setup: "flange.json",
      to: "mach3",
      flat: true,
      force: true,
    });
    expect([conversion_of(app(), { ...form, to: "" }), conversion_of(app({ opened: null }), form)]).toEqual([
      null,
      null,
    ]);
  });
  it("has the text as it stands here, and the tables of the machine", () => {
    const edited = app({ tables: { file: "a/flange.nc", edited: { offsets: { 1: { length: 2 } } } } });
    Object.assign(edited, { dirty: true });
    expect(conversion_of(edited, form)).toMatchObject({ text: "G1 X1", tables: { offsets: { 1: { length: 2 } } } });
    expect(conversion_of(app({ tables: { file: "another.nc", edited: { offsets: {} } } }), form)).not.toHaveProperty(
      "tables",
    );
    expect(conversion_of(app({ tables: { file: "a/flange.nc", edited: {} } }), form)).not.toHaveProperty("tables");
  });
});

it("the set-up stands beside the program, where there is anything to say", () => {
  expect([setup_name_of("a/flange-mach3.nc"), setup_name_of("a.b/flange"), setup_name_of("x.y.tap")]).toEqual([
    "a/flange-mach3.json",
    "a.b/flange.json",
    "x.y.json",
  ]);
  expect([says_something("{}\n"), says_something(" { }"), says_something('{"start": {}}')]).toEqual([
    false,
    false,
    true,
  ]);
});

it("a long text is shown by its beginning", () => {
  expect(beginning_of("a\nb\n", 10)).toEqual({ text: "a\nb\n", more: 0 });
  expect(beginning_of("aa\nbb\ncc\n", 4)).toEqual({ text: "aa\n", more: 2 });
  expect(beginning_of("aa\nbb\ncc", 6)).toEqual({ text: "aa\nbb\n", more: 1 });
  expect(beginning_of("x".repeat(9), 4)).toEqual({ text: "xxxx", more: 1 });
});

it("ways that one reason forbids are told together", () => {
  const one = (as: string, text: string, line = 4) => ({
    as,
    way: as,
    text,
    line,
    file: 0,
    file_name: "",
    line_text: "M6",
    written_line: 0,
    written_text: "",
  });
  expect(
    by_reason([one("as_it_stands", "a"), one("contours", "b"), one("lengths", "b"), one("plain", "b", 5)]).map(
      (g) => g.ways,
    ),
  ).toEqual([["as_it_stands"], ["contours", "lengths"], ["plain"]]);
  expect(by_reason([])).toEqual([]);
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
    if (q.do !== "convert") this.answer(q, {});
  }
  close(): void {
    this.readyState = 3;
    this.onclose?.({});
  }
  answer(q: Record<string, unknown>, body: object): void {
    queueMicrotask(() => this.onmessage?.({ data: JSON.stringify({ re: q.id, ...body }) }));
  }
}
const question: ConvertQuestion = { file: "a.nc", control: "fanuc", to: "haas" };
const settle = (): Promise<unknown> => vi.advanceTimersByTimeAsync(1);

describe("asking", () => {
  beforeEach(() => {
    vi.useFakeTimers();
    vi.stubGlobal("location", { hash: "", pathname: "/", search: "" });
    vi.stubGlobal("sessionStorage", { getItem: () => "t", setItem: () => undefined });
  });
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  it("is given up at once, and what comes late is not taken", async () => {
    const line = new Line(),
      asking = new LongQuestion(() => line, "convert");
    line.open();
    await settle();
    asking.want(question, true);
    await settle();
    expect([asking.busy, line.asked.map((q) => q.do)]).toEqual([true, ["hello", "convert"]]);
    asking.want(null);
    expect([asking.busy, line.asked.at(-1)!.do]).toEqual([false, "stop"]);
    line.answer(line.asked[1]!, { text: "equal", tolerance: 1, written: null, tries: [] });
    await settle();
    expect([asking.answer, asking.refusal]).toEqual([null, ""]);
    asking.want(question, true); // the same question again
    await settle();
    line.answer(line.asked.at(-1)!, { error: { text: "no such control" } });
    await settle();
    expect([asking.busy, asking.answer, asking.refusal]).toEqual([false, null, "no such control"]);
  });
});
