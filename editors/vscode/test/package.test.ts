// Tests that the parts of package.json fit together, its texts in both languages, and its problem matchers.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

const root = process.env.EXTENSION!;
const read = (name: string): string => readFileSync(join(root, name), "utf8");
const about = JSON.parse(read("package.json"));
const { contributes } = about;
const source = readdirSync(join(root, "src"))
  .map((name) => read(join("src", name)))
  .join("\n");

test("each text is there in English and Russian, and is used", () => {
  const en = JSON.parse(read("package.nls.json")),
    ru = JSON.parse(read("package.nls.ru.json"));
  const used = new Set([...read("package.json").matchAll(/"%([\w.]+)%"/g)].map((m) => m[1]));
  assert.deepEqual(Object.keys(en).sort(), [...used].sort());
  assert.deepEqual(Object.keys(ru).sort(), [...used].sort());
  const bundle = JSON.parse(read("l10n/bundle.l10n.ru.json"));
  const said = new Set([...source.matchAll(/l10n\.t\("([^"]+)"/g)].map((m) => m[1]));
  assert.deepEqual(Object.keys(bundle).sort(), [...said].sort());
});

test("each command exists, and each setting is read", () => {
  for (const { command } of contributes.commands)
    assert.match(source, new RegExp(`\\b${command.replace("kadr.", "")}\\b`), command);
  for (const name of Object.keys(contributes.configuration.properties))
    assert.match(read("src/settings.ts"), new RegExp(`"${name.replace("kadr.", "")}"`), name);
});

test("messages of kadr check become problems", () => {
  const lines: [string, string, string[]][] = [
    ["kadr-alarm", "/w/a.nc:2:7: alarm number_missing: PS0005 NO DATA AFTER ADDRESS Q [5]", ["/w/a.nc", "2", "7"]],
    ["kadr-alarm", "a b.nc:2:7: ошибка number_missing: нет числа", ["a b.nc", "2", "7"]],
    ["kadr-warning", "C:\\w\\a.nc:12:1: warning feed_missing: F", ["C:\\w\\a.nc", "12", "1"]],
    ["kadr-note", "a.nc:3:1: note not_stated: No set-up states G54 (3): 0 is taken", ["a.nc", "3", "1"]],
    ["kadr-note", "a.nc:3:1: совет wear_sign: …", ["a.nc", "3", "1"]],
  ];
  for (const [name, line, place] of lines) {
    const matching = contributes.problemPatterns.filter((p: { regexp: string }) => new RegExp(p.regexp).test(line));
    assert.deepEqual(
      matching.map((p: { name: string }) => p.name),
      [name],
      line,
    );
    const found = new RegExp(matching[0].regexp).exec(line)!;
    assert.deepEqual(
      [matching[0].file, matching[0].line, matching[0].column].map((i) => found[i]),
      place,
    );
  }
  const patterns = contributes.problemPatterns.map((p: { name: string }) => `$${p.name}`);
  assert.deepEqual(
    contributes.problemMatchers.map((m: { pattern: string }) => m.pattern),
    patterns,
  );
});
