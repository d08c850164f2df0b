// Tests the extension's runs of the program. KADR: the program; without it this is skipped.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { NoKadr, run_kadr } from "../src/kadr";
import { control_of_folder, controls_in, language_found, language_of } from "../src/languages";
import { data_of, made_report } from "../src/report";
import { settings_of } from "../src/settings";

const kadr = process.env.KADR,
  skip = kadr ? false : "KADR names no program";
const folder = mkdtempSync(join(tmpdir(), "kadr-extension-test-"));
after(() => rmSync(folder, { recursive: true, force: true }));
const path = join(folder, "part.nc");
writeFileSync(path, "G21 G90 G17 G94\nG0 X0 Y0 Z5 F100\nG1 X5\nM30\n");
writeFileSync(join(folder, ".kadr.toml"), '# of the shop\ncontrol = "haas"\n');
const settings = settings_of((name) => (name === "path" ? kadr : undefined), folder, "en");
const never = (): AbortSignal => new AbortController().signal;

/// The JSON inside a report: its length in four bytes, then the text.
async function inside(html: string): Promise<{ file: string; en: { opened: { control: { id: string } } } }> {
  const stream = new Blob([Buffer.from(data_of(html)!, "base64")])
    .stream()
    .pipeThrough(new DecompressionStream("deflate"));
  const bytes = Buffer.from(await new Response(stream as unknown as BodyInit).arrayBuffer());
  return JSON.parse(bytes.subarray(4, 4 + bytes.readUInt32LE(0)).toString("utf8"));
}

test("a report has the path of the program on the disk", { skip }, async () => {
  const made = await made_report({ path }, settings, never());
  assert.ok(made && "html" in made, JSON.stringify(made));
  const { file, en } = await inside(made.html);
  assert.equal(file, "part.nc");
  assert.equal(en.opened.control.id, "haas");
});

test("a text that is not saved has the control of its folder too", { skip }, async () => {
  const made = await made_report({ path, text: "G21 G90\nG0 X7\nM30\n" }, settings, never());
  assert.ok(made && "html" in made, JSON.stringify(made));
  const { file, en } = await inside(made.html);
  assert.equal(file, "part.nc");
  assert.equal(en.opened.control.id, "haas");
});

test("what cannot run says why", { skip }, async () => {
  const made = await made_report({ path }, { ...settings, control: "nothing" }, never());
  assert.ok(made && "told" in made && /nothing/.test(made.told), JSON.stringify(made));
  await assert.rejects(run_kadr(join(folder, "no-kadr"), [], folder), NoKadr);
});

test("a run can be ended", { skip }, async () => {
  const stop = new AbortController();
  stop.abort();
  assert.equal(await made_report({ path }, settings, stop.signal), null);
});

test("the controls of the program have names and colours", { skip }, async () => {
  const listed = controls_in((await run_kadr(kadr!, ["controls", "--lang", "en"], folder)).out);
  assert.ok(listed.length >= 15 && listed.some((x) => x.id === "fanuc" && /^Fanuc/.test(x.name)));
});

test("the colours are those of the control of the folder", () => {
  assert.equal(control_of_folder(path), "haas");
  assert.equal(language_of("haas", ["nc", "nc-haas"]), "nc-haas");
  assert.equal(language_of("own.toml", ["nc", "nc-haas"]), "nc");
  assert.equal(language_of("", ["nc", "nc-"]), "nc");
});

test("a control that the server has found gives colours to a program without any", () => {
  const known = ["nc", "nc-haas", "nc-fanuc"];
  assert.equal(language_found("nc", "haas", known), "nc-haas");
  assert.equal(language_found("nc-fanuc", "haas", known), "nc-fanuc");
  assert.equal(language_found("nc", "", known), "nc");
  assert.equal(language_found("nc", "own", known), "nc");
});
