// The engine of a page without a server, with a made-up worker: sockets, files, stop, failures.
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Engine } from "../src/engine/engine";
import type { EngineSocket } from "../src/engine/socket";
import type { FileBytes, FromWorker, ToWorker } from "../src/engine/messages";

class MadeUpWorker {
  heard: ToWorker[] = [];
  ended = false;
  onmessage: ((e: { data: FromWorker }) => void) | null = null;
  onerror: unknown = null;
  postMessage(message: ToWorker): void {
    this.heard.push(message);
  }
  terminate(): void {
    this.ended = true;
  }
  says(data: FromWorker): void {
    this.onmessage?.({ data });
  }
  last<K extends ToWorker["do"]>(what: K): Extract<ToWorker, { do: K }> {
    return this.heard.filter((m): m is Extract<ToWorker, { do: K }> => m.do === what).at(-1)!;
  }
}

const bytes = (text: string): ArrayBuffer => new TextEncoder().encode(text).buffer as ArrayBuffer;
const parts = { script: "", module: {} as WebAssembly.Module, viewer: "", licences: "" };
let workers: MadeUpWorker[], kept: [FileBytes[], string[]][], failures: string[], revoked: string[];

beforeEach(() => {
  vi.useFakeTimers();
  [workers, kept, failures, revoked] = [[], [], [], []];
  let n = 0;
  vi.spyOn(URL, "createObjectURL").mockImplementation(() => `blob:${++n}`);
  vi.spyOn(URL, "revokeObjectURL").mockImplementation((address) => void revoked.push(address));
});
afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
});

function engine(files: FileBytes[] = []): Engine {
  return new Engine(
    () => Promise.resolve(parts),
    "Files",
    files,
    { keep: (changed, gone) => (kept.push([changed, gone]), Promise.resolve(true)) },
    { memory: () => "too much", broken: () => "broken", stopped: () => "stopped" },
    (text) => failures.push(text),
    () => {
      const worker = new MadeUpWorker();
      workers.push(worker);
      return worker as unknown as Worker;
    },
  );
}

/// A socket whose worker, the last one, is ready.
async function ready(
  made: Engine,
  stops = true,
): Promise<{ socket: EngineSocket; worker: MadeUpWorker; got: unknown[]; state: string[] }> {
  const socket = made.socket(),
    { got, state } = listened(socket);
  await vi.advanceTimersByTimeAsync(0);
  const worker = workers.at(-1)!;
  worker.says({ is: "ready", stops });
  await vi.advanceTimersByTimeAsync(0);
  return { socket, worker, got, state };
}

function listened(socket: EngineSocket): { got: unknown[]; state: string[] } {
  const got: unknown[] = [],
    state: string[] = [];
  socket.onopen = () => state.push("open");
  socket.onclose = () => state.push("closed");
  socket.onmessage = (e) => got.push(e.data);
  return { got, state };
}

test("each session has a worker of its own, and opens when that is ready", async () => {
  const made = engine(),
    a = await ready(made),
    b = await ready(made);
  expect([workers.length, a.state, b.state]).toEqual([2, ["open"], ["open"]]);
  a.socket.send('{"id":1,"do":"files","folder":""}');
  expect(a.worker.last("take")).toMatchObject({ text: '{"id":1,"do":"files","folder":""}' });
  expect(b.worker.last("take")).toBeUndefined();
  b.worker.says({ is: "out", data: "for b" });
  expect([a.got, b.got]).toEqual([[], ["for b"]]);
  a.socket.close();
  expect([a.state, a.worker.ended, b.worker.ended]).toEqual([["open", "closed"], true, false]);
});

test("a session that is closed before its worker is made needs none", async () => {
  const made = engine();
  made.socket().close();
  await vi.advanceTimersByTimeAsync(0);
  expect(workers.length).toBe(0);
});

test("a stop withdraws the address of what was asked before it", async () => {
  const { socket, worker } = await ready(engine());
  socket.send('{"id":1,"do":"open","file":"a.nc"}');
  const { flag } = worker.last("take");
  socket.send('{"id":2,"do":"stop"}');
  expect(revoked).toContain(flag);
  expect(worker.last("take").flag).not.toBe(flag);
  await vi.advanceTimersByTimeAsync(5000);
  expect(worker.ended).toBe(false);
});

test("a worker that cannot be told is replaced when it does not end by itself, and gets the files", async () => {
  const made = engine([["a.nc", bytes("M30")]]),
    first = await ready(made, false),
    other = await ready(made, false);
  first.socket.send('{"id":1,"do":"open","file":"a.nc"}');
  first.socket.send('{"id":2,"do":"stop"}');
  await vi.advanceTimersByTimeAsync(100);
  expect(first.worker.ended).toBe(false);
  await vi.advanceTimersByTimeAsync(2000);
  expect([first.worker.ended, first.state, other.worker.ended]).toEqual([true, ["open", "closed"], false]);
  const again = await ready(made, false);
  expect(again.worker.last("begin").files).toEqual([["a.nc", bytes("M30")]]);
  again.socket.send('{"id":4,"do":"open","file":"a.nc"}'); // the page opens again what was open, and must not run it again
  await vi.advanceTimersByTimeAsync(0);
  expect(JSON.parse(String(again.got[0]))).toEqual({ re: 4, error: { text: "stopped" } });
  again.socket.send('{"id":5,"do":"open","file":"a.nc"}'); // the user runs it
  expect(again.worker.last("take").text).toContain('"id":5');
});

test("a conversion that was stopped may be asked again", async () => {
  const made = engine(),
    first = await ready(made, false);
  first.socket.send('{"id":1,"do":"convert","file":"a.nc","to":"haas"}');
  first.socket.send('{"id":2,"do":"stop"}');
  await vi.advanceTimersByTimeAsync(2000);
  const again = await ready(made, false);
  again.socket.send('{"id":2,"do":"convert","file":"a.nc","to":"haas"}');
  expect(again.worker.last("take").text).toContain("convert");
});

test("one that ends by itself in time is kept", async () => {
  const { socket, worker } = await ready(engine(), false);
  socket.send('{"id":1,"do":"open","file":"a.nc"}');
  socket.send('{"id":2,"do":"stop"}');
  worker.says({ is: "taken", end: "", text: "" });
  await vi.advanceTimersByTimeAsync(5000);
  expect(worker.ended).toBe(false);
});

test("what the memory is not sufficient for is told, and not asked again", async () => {
  const made = engine(),
    first = await ready(made);
  first.socket.send('{"id":7,"do":"open","file":"big.nc"}');
  first.worker.says({ is: "taken", end: "memory", text: "" });
  expect(JSON.parse(String(first.got[0]))).toEqual({ event: "closed", text: "too much" });
  expect([first.state, first.worker.ended]).toEqual([["open", "closed"], true]);
  const again = await ready(made);
  again.socket.send('{"id":9,"do":"open","file":"big.nc"}');
  await vi.advanceTimersByTimeAsync(0);
  expect(again.worker.last("take")).toBeUndefined();
  expect(JSON.parse(String(again.got[0]))).toEqual({ re: 9, error: { text: "too much" } });
  again.socket.send('{"id":10,"do":"open","file":"small.nc"}');
  expect(again.worker.last("take").text).toContain("small.nc");
});

test("files that a session changes are kept, and the other sessions get them", async () => {
  const made = engine([["a.nc", bytes("M30")]]),
    a = await ready(made),
    b = await ready(made);
  a.worker.says({ is: "files", changed: [["a.nc", bytes("M30")]], gone: ["never.nc"] });
  expect(kept).toEqual([]);
  a.worker.says({ is: "files", changed: [["a.nc", bytes("M02")]], gone: [] });
  a.worker.says({ is: "files", changed: [], gone: ["a.nc"] });
  expect(kept).toEqual([
    [[["a.nc", bytes("M02")]], []],
    [[], ["a.nc"]],
  ]);
  expect(b.worker.heard.slice(1)).toEqual([
    { do: "put", files: [["a.nc", bytes("M02")]], gone: [] },
    { do: "put", files: [], gone: ["a.nc"] },
  ]);
  expect(a.worker.last("put")).toBeUndefined();
  expect(made.bytes_of("a.nc")).toBeUndefined();
});

test("files that the user puts are kept, and reach every session before its next question", async () => {
  const made = engine(),
    a = await ready(made);
  made.put([["sub/x.nc", bytes("M30")]]);
  a.socket.send('{"id":1,"do":"files","folder":""}');
  expect(a.worker.heard.map((m) => m.do)).toEqual(["begin", "put", "take"]);
  expect(kept).toEqual([[[["sub/x.nc", bytes("M30")]], []]]);
  const b = await ready(made);
  expect(b.worker.last("begin").files).toEqual([["sub/x.nc", bytes("M30")]]);
});

test("an engine that cannot begin says why", async () => {
  const { worker } = await ready(engine());
  worker.says({ is: "failed", text: "no exceptions" });
  expect(failures).toEqual(["no exceptions"]);
});
