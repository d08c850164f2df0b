// Tests the client on a fake socket: numbers, promises, events, frames, lost connections.
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Client, Lost, Refused, wait_before, type Socket } from "../src/protocol/client";

class Fake implements Socket {
  binaryType = "";
  readyState = 0;
  sent: { id: number; do: string }[] = [];
  onopen: ((e: unknown) => void) | null = null;
  onclose: ((e: unknown) => void) | null = null;
  onmessage: ((e: { data: unknown }) => void) | null = null;
  send(text: string): void {
    this.sent.push(JSON.parse(text));
  }
  close(): void {
    this.readyState = 3;
    this.onclose?.({});
  }
  open(): void {
    this.readyState = 1;
    this.onopen?.({});
  }
  say(message: unknown): void {
    this.onmessage?.({ data: message instanceof ArrayBuffer ? message : JSON.stringify(message) });
  }
}

let sockets: Fake[] = [];
const settle = async (): Promise<void> => {
  for (let i = 0; i < 5; i++) await Promise.resolve();
};
async function connected(): Promise<{ client: Client; socket: Fake; lines: string[] }> {
  const client: Client = new Client(
    () => {
      const s = new Fake();
      sockets.push(s);
      return s;
    },
    async (c) => {
      await c.ask("hello", { lang: "en" });
    },
  );
  const lines: string[] = [];
  client.line.on((l) => lines.push(l));
  client.connect();
  const socket = sockets[0]!;
  socket.open();
  socket.say({ re: 1, version: "1" });
  await settle();
  return { client, socket, lines };
}
beforeEach(() => {
  sockets = [];
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

test("says hello first, then the line is open", async () => {
  const { socket, lines } = await connected();
  expect(socket.sent).toEqual([{ id: 1, do: "hello", lang: "en" }]);
  expect(socket.binaryType).toBe("arraybuffer");
  expect(lines).toEqual(["connecting", "open"]);
});

test("each answer goes to its question, in whatever order they come", async () => {
  const { client, socket } = await connected();
  const a = client.ask("files", { folder: "" }),
    b = client.ask("stop", {});
  socket.say({ re: 3 });
  socket.say({ re: 2, entries: [] });
  expect(await b).toEqual({ re: 3 });
  expect((await a).entries).toEqual([]);
});

test("a refusal has its text and says whether the file was changed", async () => {
  const { client, socket } = await connected();
  const a = client.ask("save", { file: "a", text: "", digest: "1" });
  socket.say({ re: 2, error: { text: "changed", changed: true } });
  const e = await a.catch((x) => x);
  expect(e).toBeInstanceOf(Refused);
  expect([e.message, e.changed]).toEqual(["changed", true]);
});

test("events and frames go to their listeners; what is neither is left alone", async () => {
  const { client, socket } = await connected();
  const got: unknown[] = [];
  client.event.on((e) => got.push(e.name));
  client.frame.on((f) => got.push(f.kind));
  socket.say({ event: "progress", part: 0.5 });
  socket.say(new Uint32Array([3, 0, 0, 0]).buffer); // an empty part
  socket.say(new ArrayBuffer(20));
  for (const data of ["no json", "null", "7", "[]", "{}", undefined]) socket.onmessage?.({ data });
  socket.say({ re: 99 });
  expect(got).toEqual(["progress", "part"]);
});

test("a lost line fails what waits, and is sought again after a while", async () => {
  const { client, socket, lines } = await connected();
  const a = client.ask("sheet", {}).catch((e) => e);
  socket.close();
  expect(await a).toBeInstanceOf(Lost);
  expect(await client.ask("sheet", {}).catch((e) => e)).toBeInstanceOf(Lost);
  vi.advanceTimersByTime(249);
  expect(sockets.length).toBe(1);
  vi.advanceTimersByTime(1);
  expect(sockets.length).toBe(2);
  sockets[1]!.open();
  sockets[1]!.say({ re: sockets[1]!.sent[0]!.id });
  await settle();
  expect(lines).toEqual(["connecting", "open", "lost", "connecting", "open"]);
});

test("a hello that is refused is not repeated", async () => {
  const client: Client = new Client(
    () => {
      const s = new Fake();
      sockets.push(s);
      return s;
    },
    async (c) => {
      await c.ask("hello", { lang: "en" });
    },
  );
  const lines: string[] = [];
  client.line.on((l) => lines.push(l));
  client.connect();
  sockets[0]!.open();
  sockets[0]!.say({ re: 1, error: { text: "no" } });
  await settle();
  sockets[0]!.close();
  vi.advanceTimersByTime(60_000);
  expect(sockets.length).toBe(1);
  expect(lines).toEqual(["connecting", "refused"]);
});

test("tries grow apart, up to eight seconds", () => {
  expect([0, 1, 2, 5, 50].map(wait_before)).toEqual([250, 500, 1000, 8000, 8000]);
});
