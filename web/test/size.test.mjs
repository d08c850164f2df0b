// Checks that files are short enough to be read at once.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";

const web = fileURLToPath(new URL("..", import.meta.url));
const most = 250; // lines

test("no file has more than 250 lines", () => {
  const names = ["src", "test", "e2e", "bundling"].flatMap((folder) =>
    readdirSync(join(web, folder), { recursive: true }).map((name) => join(folder, String(name))),
  );
  const files = names.filter((name) => /\.(ts|mjs|css)$/.test(name));
  expect(files.length).toBeGreaterThan(120);
  const lines = (name) => readFileSync(join(web, name), "utf8").split("\n").length - 1;
  const too_long = files.map((name) => [name, lines(name)]).filter(([, count]) => count > most);
  expect(too_long.map(([name, count]) => `${name}: ${count}`)).toEqual([]);
});
