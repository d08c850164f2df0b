// The engine of a page without a server, with a made-up worker: sockets, files, stop, failures.
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Engine, type EngineSocket } from "../src/engine/engine";
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

async function engine(stops = true, files: FileBytes[] = []): Promise<Engine> {
  const made = new Engine(
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
  await vi.advanceTimersByTimeAsync(0);
  workers[0]!.says({ is: "ready", stops });
  return made;
}

function listened(socket: EngineSocket): { got: unknown[]; state: string[] } {
  const got: unknown[] = [],
    state: string[] = [];
  socket.onopen = () => state.push("open");
  socket.onclose = () => state.push("closed");
  socket.onmessage = (e) => got.push(e.data);
  return { got, state };
}

test("a socket opens when the worker is ready, and each session has its own messages", async () => {
  const made = await engine();
  const [a, b] = [made.socket(), made.socket()];
  const [of_a, of_b] = [listened(a), listened(b)];
  await vi.advanceTimersByTimeAsync(0);
  expect([of_a.state, of_b.state]).toEqual([["open"], ["open"]]);
  a.send('{"id":1,"do":"files","folder":""}');
  expect(workers[0]!.last("take")).toMatchObject({ session: a.session, text: '{"id":1,"do":"files","folder":""}' });
  workers[0]!.says({ is: "out", session: b.session, data: "for b" });
  expect([of_a.got, of_b.got]).toEqual([[], ["for b"]]);
  a.close();
  expect(of_a.state).toEqual(["open", "closed"]);
  expect(workers[0]!.last("close").session).toBe(a.session);
});

test("a stop withdraws the address of what was asked before it", async () => {
  const made = await engine(),
    socket = made.socket();
  listened(socket);
  await vi.advanceTimersByTimeAsync(0);
  socket.send('{"id":1,"do":"open","file":"a.nc"}');
  const { flag } = workers[0]!.last("take");
  socket.send('{"id":2,"do":"stop"}');
  expect(revoked).toContain(flag);
  expect(workers[0]!.last("take").flag).not.toBe(flag);
  await vi.advanceTimersByTimeAsync(5000);
  expect(workers.length).toBe(1);
});

test("a worker that cannot be told is replaced when it does not end by itself, and gets the files", async () => {
  const made = await engine(false, [["a.nc", bytes("M30")]]),
    socket = made.socket();
  const { state } = listened(socket);
  await vi.advanceTimersByTimeAsync(0);
  socket.send('{"id":1,"do":"open","file":"a.nc"}');
  socket.send('{"id":2,"do":"stop"}');
  await vi.advanceTimersByTimeAsync(100);
  expect(workers[0]!.ended).toBe(false);
  await vi.advanceTimersByTimeAsync(2000);
  expect(workers[0]!.ended).toBe(true);
  expect(state).toEqual(["open", "closed"]);
  expect(workers[1]!.last("begin").files).toEqual([["a.nc", bytes("M30")]]);
  workers[1]!.says({ is: "ready", stops: false });
  const again = made.socket(),
    of_again = listened(again);
  await vi.advanceTimersByTimeAsync(0);
  again.send('{"id":4,"do":"open","file":"a.nc"}'); // the page opens again what was open, and must not run it again
  await vi.advanceTimersByTimeAsync(0);
  expect(JSON.parse(String(of_again.got[0]))).toEqual({ re: 4, error: { text: "stopped" } });
  again.send('{"id":5,"do":"open","file":"a.nc"}'); // the user runs it
  expect(workers[1]!.last("take").text).toContain('"id":5');
});

test("one that ends by itself in time is kept", async () => {
  const made = await engine(false),
    socket = made.socket();
  listened(socket);
  await vi.advanceTimersByTimeAsync(0);
  socket.send('{"id":1,"do":"open","file":"a.nc"}');
  socket.send('{"id":2,"do":"stop"}');
  workers[0]!.says({ is: "taken", session: socket.session, end: "", text: "" });
  await vi.advanceTimersByTimeAsync(5000);
  expect(workers.length).toBe(1);
});

test("what the memory is not sufficient for is told, and not asked again", async () => {
  const made = await engine(),
    first = made.socket();
  const { got, state } = listened(first);
  await vi.advanceTimersByTimeAsync(0);
  first.send('{"id":7,"do":"open","file":"big.nc"}');
  workers[0]!.says({ is: "taken", session: first.session, end: "memory", text: "" });
  expect(JSON.parse(String(got[0]))).toEqual({ event: "closed", text: "too much" });
  expect([state, workers[0]!.ended]).toEqual([["open", "closed"], true]);
  await vi.advanceTimersByTimeAsync(0);
  workers[1]!.says({ is: "ready", stops: true });
  const again = made.socket();
  const of_again = listened(again);
  await vi.advanceTimersByTimeAsync(0);
  again.send('{"id":9,"do":"open","file":"big.nc"}');
  await vi.advanceTimersByTimeAsync(0);
  expect(workers[1]!.last("take")).toBeUndefined();
  expect(JSON.parse(String(of_again.got[0]))).toEqual({ re: 9, error: { text: "too much" } });
  again.send('{"id":10,"do":"open","file":"small.nc"}');
  expect(workers[1]!.last("take").text).toContain("small.nc");
});

test("files that the worker reports are kept, and only those that differ", async () => {
  const made = await engine(true, [["a.nc", bytes("M30")]]);
  workers[0]!.says({ is: "files", changed: [["a.nc", bytes("M30")]], gone: [] });
  expect(kept).toEqual([]);
  workers[0]!.says({ is: "files", changed: [["a.nc", bytes("M02")]], gone: ["b.nc"] });
  expect(kept).toEqual([[[["a.nc", bytes("M02")]], ["b.nc"]]]);
  expect(made.bytes_of("a.nc")).toEqual(bytes("M02"));
});

test("files that are put are there when the worker says so", async () => {
  const made = await engine();
  let done = false;
  void made.put([["sub/x.nc", bytes("M30")]]).then(() => (done = true));
  await vi.advanceTimersByTimeAsync(0);
  expect(done).toBe(false);
  workers[0]!.says({ is: "put", id: workers[0]!.last("put").id });
  await vi.advanceTimersByTimeAsync(0);
  expect(done).toBe(true);
});

test("an engine that cannot begin says why", async () => {
  await engine();
  workers[0]!.says({ is: "failed", text: "no exceptions" });
  expect(failures).toEqual(["no exceptions"]);
});
