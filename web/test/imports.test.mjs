// Checks that the imports of the files of src have no cycle, not even by types: each file can be read and tested with
// only the files below it.
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";

const src = fileURLToPath(new URL("../src", import.meta.url));

/// Returns our own files that a text names in `import … from "…"`, `export … from "…"`, `import "…"` and
/// `import("…")`.
function imported(file, text) {
  const names = [...text.matchAll(/(?:\bfrom|\bimport)\s*\(?\s*"(\.[^"]*)"/g)].map((m) => m[1]);
  return names
    .filter((name) => !name.endsWith(".css"))
    .map((name) => normalize(join(dirname(file), `${name.replace(/\.ts$/, "")}.ts`)));
}

/// `files`: texts by name. Returns a cycle as the names along it, with the first one repeated at the end; null if
/// there is none.
function circle_in(files) {
  const over = new Set(),
    way = [];
  const visit = (file) => {
    if (way.includes(file)) return [...way.slice(way.indexOf(file)), file];
    if (over.has(file)) return null;
    way.push(file);
    for (const next of imported(file, files.get(file))) {
      if (!files.has(next)) throw new Error(`${file} imports ${next}, which is not there`);
      const found = visit(next);
      if (found) return found;
    }
    way.pop();
    over.add(file);
    return null;
  };
  for (const file of files.keys()) {
    const found = visit(file);
    if (found) return found;
  }
  return null;
}

test("no file of src comes back to itself by its imports", () => {
  const names = readdirSync(src, { recursive: true })
    .map(String)
    .filter((name) => name.endsWith(".ts"));
  expect(names.length).toBeGreaterThan(80);
  const files = new Map(names.map((name) => [normalize(name), readFileSync(join(src, name), "utf8")]));
  expect([...files].flatMap(([name, text]) => imported(name, text)).length).toBeGreaterThan(300);
  expect(circle_in(files)).toBeNull();
});

test("a circle is found, whatever form its imports have", () => {
  const chain = [
    ["a.ts", 'import { b } from "./in/b";'],
    ["in/b.ts", 'import type { c } from "../c";\nimport "../style.css";'],
    ["c.ts", "export const c = 1;"],
  ];
  expect(circle_in(new Map(chain))).toBeNull();
  const back = [
    'import { a } from "./a";',
    'import {\n  type A,\n} from "./a";',
    'export { a } from "./a";',
    'import "./a";',
    'const a = await import("./a");',
    'let a: import("./a").A;',
    'import { a } from "./a.ts";',
  ];
  for (const text of back)
    expect(circle_in(new Map([...chain.slice(0, 2), ["c.ts", text]])), text).toEqual([
      "a.ts",
      "in/b.ts",
      "c.ts",
      "a.ts",
    ]);
  expect(circle_in(new Map([["a.ts", 'import type { A } from "./a";']]))).toEqual(["a.ts", "a.ts"]);
});
