// Checks that no line is too long for a screen. The formatter breaks code; this checks what it leaves: texts and
// comments.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";

const web = fileURLToPath(new URL("..", import.meta.url));
const most = 150; // characters

/// Returns the locations of longer lines.
const too_long = (name, text) =>
  text.split("\n").flatMap((line, i) => ([...line].length > most ? [`${name}:${i + 1}`] : []));

test("no line is longer than 150 characters", () => {
  const names = ["src", "test", "e2e", "bundling"].flatMap((folder) =>
    readdirSync(join(web, folder), { recursive: true }).map((name) => join(folder, String(name))),
  );
  const files = names.filter((name) => /\.(ts|mjs|css)$/.test(name));
  expect(files.length).toBeGreaterThan(120);
  expect(files.flatMap((name) => too_long(name, readFileSync(join(web, name), "utf8")))).toEqual([]);
});

test("a longer line is found", () => {
  expect(too_long("a.ts", `${"я".repeat(most)}\n${"x".repeat(most + 1)}`)).toEqual(["a.ts:2"]);
});
