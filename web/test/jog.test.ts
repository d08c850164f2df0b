// Axes moved by hand: the dead man's key, and steps that add up.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { HeldJog, StepJog } from "../src/model/jog";
import type { Operator } from "../src/model/operator";
import { Signal } from "../src/model/signal";
import type { Panel } from "../src/protocol/types";

type Asked = { do: string } & Record<string, unknown>;
let asked: Asked[] = [],
  moves = true,
  refuses = false;
const panel = { mode: "standing", holds: true } as Panel;
const on_panel = new Signal<Panel | null>();
const operator = {
  get panel() {
    return panel;
  },
  on_panel,
  ask: (what: string, body: object) => {
    asked.push({ do: what, ...body });
    if (refuses && what === "jog") return Promise.resolve(null);
    return Promise.resolve(what === "jogging" ? { moves } : {});
  },
} as unknown as Operator;
const now = (mode: Panel["mode"]): void => {
  panel.mode = mode;
  on_panel.emit(panel);
};
const said = (what: string): Asked[] => asked.filter((q) => q.do === what);
const after = (ms: number): Promise<unknown> => vi.advanceTimersByTimeAsync(ms);

beforeEach(() => {
  vi.useFakeTimers();
  ((asked = []), (moves = true), (refuses = false), (panel.mode = "standing"), (panel.holds = true));
});
afterEach(() => vi.useRealTimers());

describe("a held key", () => {
  it("renews ten times a second, and tells that it is released", async () => {
    const jog = new HeldJog(operator);
    jog.press("X", -1, 500);
    expect(asked).toEqual([{ do: "jog", axis: "X", way: -1, feed: 500, held: true }]);
    now("running");
    await after(1050);
    expect(said("jogging").length).toBe(10);
    jog.release();
    expect(asked.at(-1)).toEqual({ do: "jogging", on: false });
    await after(1000);
    expect(said("jogging").length).toBe(11);
  });
  it("is over when the machine says that nothing moves", async () => {
    const jog = new HeldJog(operator);
    jog.press("X", 1, 0);
    now("running");
    moves = false;
    await after(100);
    now("standing");
    await after(1000);
    expect(said("jogging").length).toBe(1);
    expect(said("jog").length).toBe(1);
    expect(jog.busy).toBe(false);
  });
  it("begins after the axes have stopped, if it is still held then", async () => {
    const jog = new HeldJog(operator);
    jog.press("X", 1, 500);
    await after(0);
    now("running");
    jog.release();
    jog.press("X", -1, 500);
    expect(said("jog").length).toBe(1);
    now("standing");
    expect(said("jog").length).toBe(2);
    jog.release();
    await after(10);
  });
  it("does not take an old state for the end of its motion", async () => {
    const jog = new HeldJog(operator);
    jog.press("X", 1, 500);
    await after(0);
    jog.release();
    jog.press("X", -1, 500); // the state at hand is from before the motion
    expect(said("jog").length).toBe(1);
    now("running");
    now("standing");
    expect(said("jog").map((q) => q["way"])).toEqual([1, -1]);
    jog.release();
    await after(10);
  });
  it("does not begin later if it was released before the axes stood", async () => {
    const jog = new HeldJog(operator);
    jog.press("X", 1, 500);
    now("running");
    jog.release();
    jog.press("X", -1, 500);
    jog.release();
    now("standing");
    expect(said("jog").length).toBe(1);
  });
  it("moves nothing while a program runs, nor after it", async () => {
    const jog = new HeldJog(operator);
    panel.mode = "running";
    jog.press("X", 1, 500);
    now("standing");
    expect(asked).toEqual([]);
  });
});

describe("steps", () => {
  it("add up while the axis moves: none is lost", async () => {
    const jog = new StepJog(operator);
    jog.step("X", 1, 0.1, 500);
    now("running");
    await after(0);
    jog.step("X", 1, 0.1, 500);
    jog.step("X", 1, 0.1, 500);
    now("running");
    expect(said("jog").length).toBe(1);
    now("standing");
    expect(said("jog").map((q) => q["way"])).toEqual([0.1, 0.2]);
  });
  it("wait for a state that is newer than the last step", async () => {
    const jog = new StepJog(operator);
    jog.step("X", 1, 0.1, 500);
    await after(0);
    jog.step("X", 1, 0.1, 500); // the state at hand still says that the machine stands
    expect(said("jog").length).toBe(1);
    now("running");
    jog.step("X", 1, 0.1, 500);
    now("standing");
    expect(said("jog").map((q) => q["way"])).toEqual([0.1, 0.2]);
  });
  it("are forgotten when the machine refuses, or stops", async () => {
    const jog = new StepJog(operator);
    refuses = true;
    jog.step("X", 1, 1, 500);
    jog.step("X", 1, 1, 500);
    await after(0);
    refuses = false;
    now("standing");
    expect(said("jog").length).toBe(1);
    now("alarm");
    jog.step("X", 1, 1, 500);
    now("standing");
    expect(said("jog").length).toBe(1);
  });
  it("asked for while a program runs are not made when it ends", async () => {
    const jog = new StepJog(operator);
    panel.mode = "running";
    jog.step("X", 1, 1, 500);
    now("standing");
    expect(asked).toEqual([]);
  });
});
