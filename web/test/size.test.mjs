// Checks that files are short enough to be read at once. Files that were longer when this was written are listed with
// their length: the list may only shrink.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";

const web = fileURLToPath(new URL("..", import.meta.url));
const most = 250; // lines
const longer = {
  "e2e/panel_steps.mjs": 400,
  "src/scene/path_view.ts": 330,
  "src/style/operator_screen.css": 420,
  "src/ui/converting.ts": 345,
  "src/ui/making.ts": 385,
  "src/ui/restart_panel.ts": 364,
  "src/ui/scene_pane.ts": 299,
  "test/mock-session.mjs": 464,
  "test/scene.test.ts": 318,
};

test("no file has more than 250 lines, except those that are listed, which do not grow", () => {
  const names = ["src", "test", "e2e", "bundling"].flatMap((folder) =>
    readdirSync(join(web, folder), { recursive: true }).map((name) => join(folder, String(name))),
  );
  const lines = new Map(
    names
      .filter((name) => /\.(ts|mjs|css)$/.test(name))
      .map((name) => [name, readFileSync(join(web, name), "utf8").split("\n").length - 1]),
  );
  expect(lines.size).toBeGreaterThan(120);
  const too_long = [...lines]
    .filter(([name, count]) => count > (longer[name] ?? most))
    .map(([name, n]) => `${name}: ${n}`);
  expect(too_long).toEqual([]);
  const shorter = Object.keys(longer).filter((name) => (lines.get(name) ?? 0) <= most);
  expect(shorter, "these are short enough now: take them off the list").toEqual([]);
});
