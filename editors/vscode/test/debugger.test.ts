// Tests `kadr dap` with the public client for tests of debug adapters (@vscode/debugadapter-testsupport).
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, beforeEach, test } from "node:test";
import { DebugClient } from "@vscode/debugadapter-testsupport";

const kadr = process.env.KADR,
  skip = kadr ? false : "KADR names no program";
const folder = mkdtempSync(join(tmpdir(), "kadr-debugger-"));
after(() => rmSync(folder, { recursive: true, force: true }));
const path = join(folder, "part.nc"),
  wrong = join(folder, "wrong.nc");
const text = ["O0001", "G21 G90 G54", "#101=0", "N10 #101=#101+1", "G1 X#101 F100", "M98 P0200", "IF[#101LT3]GOTO 10"];
writeFileSync(path, [...text, "G0 Z50.", "M30", "O0200", "#102=#101*2", "M99", ""].join("\n"));
writeFileSync(wrong, "O0002\nG21 G90 G54\nG1 X5. Q\nM30\n");
const launch = { program: path, control: "fanuc", stopOnEntry: false };
const thread = { threadId: 1 };

let client: DebugClient;
beforeEach(async () => {
  if (skip) return;
  client = new DebugClient(kadr!, "dap", "kadr");
  await client.start();
});
afterEach(async () => {
  if (!skip) await client.stop();
});
async function value(expression: string): Promise<number> {
  const frameId = (await client.stackTraceRequest(thread)).body.stackFrames[0]!.id;
  const { result } = (await client.evaluateRequest({ expression, frameId })).body;
  return Number(result.replace(/[^-\d.]/g, ""));
}

test("a program runs to its end", { skip }, async () => {
  await Promise.all([client.configurationSequence(), client.launch(launch), client.waitForEvent("terminated")]);
});

test("it stops at a breakpoint, also at one with a condition", { skip }, async () => {
  await client.hitBreakpoint(launch, { path, line: 5 });
  assert.equal(await value("#101"), 1);
  await client.setBreakpointsRequest({ source: { path }, breakpoints: [{ line: 5, condition: "#101 EQ 3" }] });
  await Promise.all([client.continueRequest(thread), client.assertStoppedLocation("breakpoint", { path, line: 5 })]);
  assert.equal(await value("#101"), 3);
});

test("steps go into a call, out of it, over it and back", { skip }, async () => {
  await client.hitBreakpoint(launch, { path, line: 6 });
  await Promise.all([client.stepInRequest(thread), client.waitForEvent("stopped")]);
  const { stackFrames } = (await client.stackTraceRequest(thread)).body;
  assert.equal(stackFrames.length, 2, "the call has a frame of its own");
  await Promise.all([client.stepOutRequest(thread), client.waitForEvent("stopped")]);
  assert.equal((await client.stackTraceRequest(thread)).body.stackFrames[0]!.line, 7);
  await Promise.all([client.stepBackRequest(thread), client.waitForEvent("stopped")]);
  assert.ok((await client.stackTraceRequest(thread)).body.stackFrames[0]!.line !== 7, "a step back leaves the line");
});

test("values are shown, and can be set", { skip }, async () => {
  await client.hitBreakpoint(launch, { path, line: 5 });
  const frameId = (await client.stackTraceRequest(thread)).body.stackFrames[0]!.id;
  const { scopes } = (await client.scopesRequest({ frameId })).body;
  assert.ok(scopes.length >= 2);
  for (const { variablesReference } of scopes) {
    const { variables } = (await client.variablesRequest({ variablesReference })).body;
    if (!variables.some((v) => v.name === "#101")) continue;
    await client.setVariableRequest({ variablesReference, name: "#101", value: "7" });
    assert.equal(await value("#101"), 7);
    return;
  }
  assert.fail("no scope has #101");
});

test("an alarm stops the run and says why", { skip }, async () => {
  const stopped = client.waitForEvent("stopped");
  await Promise.all([client.configurationSequence(), client.launch({ ...launch, program: wrong })]);
  assert.equal((await stopped).body.reason, "exception");
});

test("a program that does not exist is refused", { skip }, async () => {
  await client.initializeRequest();
  await assert.rejects(client.launchRequest({ ...launch, program: join(folder, "none.nc") } as never));
});
