// Bundles the extension, and writes the notices of the packages inside it; a licence that may not be embedded stops the
// build (web/bundling/notices.ts has the same rule for the page).
import { build } from "esbuild";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const allowed = ["MIT", "ISC", "BSD-2-Clause", "BSD-3-Clause", "Apache-2.0", "0BSD"];
const { metafile } = await build({
  entryPoints: ["src/extension.ts"],
  bundle: true,
  platform: "node",
  target: "node18",
  external: ["vscode"],
  minify: true,
  metafile: true,
  outfile: "dist/extension.js",
});
const folders = new Set();
for (const name of Object.keys(metafile.inputs)) {
  const found = /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(name);
  if (found) folders.add(found[1]);
}
const rule = `${"-".repeat(80)}\n`;
const notices = [...folders].sort().map((folder) => {
  const about = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  if (!allowed.includes(about.license))
    throw new Error(`${about.name}: its licence may not be embedded: ${about.license}`);
  const file = readdirSync(folder).find((name) => /^(licen[cs]e|copying)/i.test(name));
  if (!file) throw new Error(`${about.name}: no text of its licence in ${folder}`);
  return `${rule}${about.name} ${about.version} (${about.license})\n\n${readFileSync(join(folder, file), "utf8").trim()}\n\n`;
});
writeFileSync("NOTICES.txt", `Packages inside dist/extension.js.\n\n${notices.join("")}`);
