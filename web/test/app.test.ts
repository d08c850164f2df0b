// Tests the state of the page for a program, on a fake socket: the last request counts, however late an answer comes.
import { expect, test, vi } from "vitest";
import { App } from "../src/model/app";
import type { Socket } from "../src/protocol/client";

class Fake implements Socket {
  binaryType = "";
  readyState = 0;
  sent: { id: number; do: string; [key: string]: unknown }[] = [];
  onopen: ((e: unknown) => void) | null = null;
  onclose: ((e: unknown) => void) | null = null;
  onmessage: ((e: { data: unknown }) => void) | null = null;
  send(text: string): void {
    this.sent.push(JSON.parse(text));
  }
  close(): void {
    this.readyState = 3;
  }
  say(message: unknown): void {
    this.onmessage?.({ data: JSON.stringify(message) });
  }
}

vi.mock("../src/protocol/token", () => ({ token: () => undefined }));
const settle = async (): Promise<void> => {
  for (let i = 0; i < 20; i++) await Promise.resolve();
};
/// An App whose program has run for 100 s in 50 blocks. `answer(what, body)` answers the newest question of that type.
async function run_over(): Promise<{ app: App; socket: Fake; answer: (what: string, body: object) => Promise<void> }> {
  const socket = new Fake();
  const app = new App(() => socket);
  const answer = async (what: string, body: object): Promise<void> => {
    const asked = socket.sent.filter((q) => q.do === what).at(-1);
    if (!asked) throw new Error(`nobody asked ${what}`);
    socket.say({ re: asked.id, ...body });
    await settle();
  };
  app.client.connect();
  socket.readyState = 1;
  socket.onopen?.({});
  await settle();
  await answer("hello", { version: "1", controls: [], machines: [] });
  void app.open({ file: "a.nc" });
  await answer("open", { file: "a.nc", text: "G1 X1", digest: "1" });
  socket.say({ event: "done", seconds: 100, blocks: 50, marks: [] });
  await settle();
  return { app, socket, answer };
}

test("an answer to an older wish does not take the slider back", async () => {
  const { app, answer } = await run_over();
  await answer("state", { number: 1, at: 0 });
  app.step(10);
  app.seek(50);
  await answer("state", { number: 11, at: 20 });
  expect(app.instant).toBe(50);
  await answer("state", { number: 30, at: 50 });
  expect([app.instant, app.state?.number]).toEqual([50, 30]);
});

test("stepping while answers are under way goes on from where it aims", async () => {
  const { app, answer } = await run_over();
  await answer("state", { number: 1, at: 0 });
  app.step(10);
  app.step(10);
  await answer("state", { number: 11, at: 20 });
  expect(app.instant).toBe(20);
  await answer("state", { number: 21, at: 40 });
  expect([app.instant, app.state?.number]).toEqual([40, 21]);
});

test("a click on a line counts no more once the slider was taken", async () => {
  const { app, socket, answer } = await run_over();
  await answer("state", { number: 1, at: 0 });
  const clicked = app.seek_line(7, 0);
  await settle();
  app.seek(50);
  await answer("passes", { passes: [{ number: 7, from: 10, to: 12 }] });
  await clicked;
  await answer("state", { number: 30, at: 50 });
  expect([app.instant, socket.sent.filter((q) => q.do === "state").at(-1)!.at]).toEqual([50, 50]);
});

test("steps go on from where the slider stands, whatever was told before", async () => {
  const { app, socket, answer } = await run_over();
  await answer("state", { number: 50, at: 100 });
  app.seek(0);
  app.step(10); // its state has not arrived yet
  await answer("state", { number: 1, at: 0 });
  expect(socket.sent.filter((q) => q.do === "state").at(-1)!.number).toBe(10);
});

test("a cut is of the text that is shown: it is run first, unless it was run", async () => {
  const { app, socket, answer } = await run_over();
  const asked = (): string[] => socket.sent.map((q) => q.do).filter((what) => ["open", "cut"].includes(what));
  const question = { stock: "box:0,0,0,1,1,1", tools: [] };
  void app.run_cut(question);
  await settle();
  expect(asked()).toEqual(["open", "cut"]);
  await answer("cut", {});
  app.set_text("G1 X2");
  void app.run_cut(question);
  await settle();
  expect(asked()).toEqual(["open", "cut", "open"]);
  expect(socket.sent.filter((q) => q.do === "open").at(-1)!.text).toBe("G1 X2");
  await answer("open", { file: "a.nc", text: "G1 X2", digest: "1" });
  expect(asked()).toEqual(["open", "cut", "open", "cut"]);
});

test("a cut that a run of a new text ends is made after this run", async () => {
  const { app, socket, answer } = await run_over();
  const cuts = (): number => socket.sent.filter((q) => q.do === "cut").length;
  const follow = async (text: string): Promise<void> => {
    app.set_text(text);
    void app.follow_text();
    await settle();
    await answer("open", { file: "a.nc", text, digest: "1" });
    socket.say({ event: "done", seconds: 100, blocks: 50, marks: [] });
    await settle();
  };
  app.opened!.editable = true;
  void app.run_cut({ stock: "box:0,0,0,1,1,1", tools: [] });
  await settle();
  expect(cuts()).toBe(1);
  await follow("G1 X2");
  expect(cuts()).toBe(2);
  socket.say({ event: "cut", marks: [] });
  await follow("G1 X3");
  expect(cuts()).toBe(2);
});

test("what is typed while the session opens the same program is not lost", async () => {
  const { app, socket, answer } = await run_over();
  app.opened!.editable = true;
  app.set_text("G1 X2");
  void app.follow_text();
  await settle();
  expect(socket.sent.filter((q) => q.do === "open").at(-1)!.text).toBe("G1 X2");
  app.set_text("G1 X23"); // before the answer
  await answer("open", { file: "a.nc", text: "G1 X2", digest: "1", editable: true });
  expect([app.text, app.ran, app.dirty]).toEqual(["G1 X23", "G1 X2", true]);
});

test("a newer text cancels the run of an older one, and what is shown stays meanwhile", async () => {
  const { app, socket, answer } = await run_over();
  app.opened!.editable = true;
  await answer("state", { number: 30, at: 50 });
  app.set_text("G1 X2");
  void app.follow_text();
  await settle();
  expect(app.done?.seconds).toBe(100);
  await answer("open", { file: "a.nc", text: "G1 X2", digest: "1", editable: true });
  app.set_text("G1 X3");
  void app.follow_text();
  await settle();
  expect(socket.sent.slice(-2).map((q) => q.do)).toEqual(["stop", "open"]);
  expect(socket.sent.at(-1)!.text).toBe("G1 X3");
});

test("a file that is gone from the disk leaves its text unsaved; taken from the disk, it is not", async () => {
  const { app } = await run_over();
  app.lost_on_disk();
  expect([app.dirty, app.digest]).toEqual([true, null]);
  await app.changed_on_disk({ text: "G1 X1", digest: "2" }, false);
  expect([app.dirty, app.digest]).toEqual([false, "2"]);
  await app.changed_on_disk({ text: "G1 X9", digest: "3" }, false);
  expect([app.dirty, app.text]).toEqual([true, "G1 X1"]);
});
