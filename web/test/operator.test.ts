// Tests the connection to a machine: switched on, watched, refused, lost and restored.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { alarm_told } from "../src/model/alarm_told";
import { Operator } from "../src/model/operator";
import type { Socket } from "../src/protocol/client";

class FakeSocket implements Socket {
  binaryType = "";
  readyState = 0;
  onopen: Socket["onopen"] = null;
  onclose: Socket["onclose"] = null;
  onmessage: Socket["onmessage"] = null;
  asked: Record<string, unknown>[] = [];
  constructor(private answers: (q: Record<string, unknown>) => object) {}
  open(): void {
    this.readyState = 1;
    this.onopen?.({});
  }
  send(text: string): void {
    const q = JSON.parse(text) as Record<string, unknown>;
    this.asked.push(q);
    queueMicrotask(() => this.onmessage?.({ data: JSON.stringify({ re: q.id, ...this.answers(q) }) }));
  }
  close(): void {
    this.readyState = 3;
    this.onclose?.({});
  }
  said(what: string): number {
    return this.asked.filter((q) => q.do === what).length;
  }
}

let sockets: FakeSocket[] = [],
  mode = "standing",
  refuses = "";
const answers = (q: Record<string, unknown>): object =>
  q.do === refuses
    ? { error: { text: `no ${String(q.do)}` } }
    : q.do === "machine"
      ? { name: q.file, axes: ["X"], control: "mach3", machine: "generic", holds: true }
      : q.do === "panel"
        ? { mode, line: 1 }
        : {};
const made = (): FakeSocket => {
  const s = new FakeSocket(answers);
  sockets.push(s);
  return s;
};
const after = (ms: number): Promise<unknown> => vi.advanceTimersByTimeAsync(ms);

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("location", { hash: "", pathname: "/", search: "" });
  vi.stubGlobal("sessionStorage", { getItem: () => "t", setItem: () => undefined });
  ((sockets = []), (mode = "standing"), (refuses = ""));
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

async function switched_on(): Promise<Operator> {
  const operator = new Operator(made);
  void operator.switch_on({ file: "a.nc", text: "not saved" });
  sockets[0]!.open();
  await after(1);
  return operator;
}

describe("a machine's operator", () => {
  it("switches on what lies on the disk, and looks at it often while it moves", async () => {
    const operator = await switched_on(),
      line = sockets[0]!;
    expect(line.asked.find((q) => q.do === "machine")).toMatchObject({ file: "a.nc" });
    expect(line.asked.find((q) => q.do === "machine")).not.toHaveProperty("text");
    await after(1000);
    const seldom = line.said("panel");
    expect(operator.panel?.mode).toBe("standing");
    mode = "running";
    await after(1300);
    expect(line.said("panel")).toBeGreaterThan(seldom + 25);
  });
  it("looks at once after a key", async () => {
    const operator = await switched_on(),
      line = sockets[0]!;
    await after(10);
    const before = line.said("panel");
    operator.press("run");
    await after(5);
    expect(line.said("press")).toBe(1);
    expect(line.said("panel")).toBe(before + 1);
  });
  it("tells what is refused, and is off where the machine cannot be switched on", async () => {
    refuses = "machine";
    const operator = new Operator(made),
      told: string[] = [];
    operator.on_error.on((text) => told.push(text));
    void operator.switch_on({ file: "a.nc" });
    sockets[0]!.open();
    await after(10);
    expect(told).toEqual(["no machine"]);
    expect([operator.panel, operator.name]).toEqual([null, null]);
  });
  it("finds the machine again when the line was lost", async () => {
    const operator = await switched_on();
    const seen: boolean[] = [];
    await after(10);
    operator.on_panel.on((p) => seen.push(p !== null));
    sockets[0]!.close();
    expect(operator.panel).toBeNull();
    await after(300);
    sockets[1]!.open();
    await after(10);
    expect(sockets[1]!.said("machine")).toBe(1);
    expect(operator.panel?.mode).toBe("standing");
    expect(seen[0]).toBe(false);
  });
  it("looks no more at one that is off", async () => {
    const operator = await switched_on(),
      line = sockets[0]!;
    operator.press("off");
    await after(20);
    const before = line.said("panel");
    await after(2000);
    expect(line.said("panel")).toBe(before);
    expect(operator.panel).toBeNull();
  });
});

it("an alarm is told with its number once", () => {
  expect(alarm_told({ number: 1070, text: "No feed" })).toBe("1070 No feed");
  expect(alarm_told({ number: 10, text: "PS0010 IMPROPER G-CODE: G777" })).toBe("PS0010 IMPROPER G-CODE: G777");
  expect(alarm_told({ number: 0, text: "No feed" })).toBe("No feed");
  expect(alarm_told({ text: "No feed" })).toBe("No feed");
});
