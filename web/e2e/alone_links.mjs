// The examples of the documentation open in Kadr: node e2e/alone_links.mjs SITE [PART]. SITE: the folder that `make site`
// has built after `make web`; PART: only links to programs with this text in their names. Every link is opened on a
// simple host, and one from the disk. Exit status 1 if one does not run.
import { readFileSync, readdirSync } from "node:fs";
import { join, relative, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { browser, looks_at, must, until } from "./browser.mjs";
import { simple_host } from "./simple_host.mjs";

const site = process.argv[2] ?? "../build/site",
  part = process.argv[3] ?? "";
const links = new Map(); // address after the folder of the page → where it is, and the program's name
for (const entry of readdirSync(site, { recursive: true, withFileTypes: true })) {
  if (!entry.name.endsWith(".html")) continue;
  const path = join(entry.parentPath ?? entry.path, entry.name);
  const text = readFileSync(path, "utf8");
  for (const [, , files, name] of text.matchAll(/class="open-in-kadr" href="([^"#]*)#([^"]*)">[^<]*?: ([^<]*)</g))
    if (name.includes(part)) links.set(files, { page: relative(site, path), name });
}
const host = await simple_host(site, "/docs/"),
  { page, errors, close } = await browser();
const { text, count } = looks_at(() => page);
let passed = 0,
  failed = 0;
const run = async (name, step) => {
  try {
    await step();
    passed++;
  } catch (e) {
    failed++;
    console.log(`FAIL  ${name}: ${e.message.split("\n")[0]}`);
  }
};
const runs = async (name) => {
  await until(
    "it has run",
    async () =>
      (await count(".run-told.ended, .run-told.stopped")) === 1 && (await text(".topbar .file")).endsWith(name),
    60_000,
  );
  must((await text(".state .positions")).length > 10, "no state");
};
for (const [files, { page: from, name }] of links)
  await run(`${name}, of ${from}`, async () => {
    await page.goto("about:blank");
    await page.goto(`${host.address}kadr/index.html#${files}`);
    await runs(name);
  });
await run("from the disk", async () => {
  await page.goto(pathToFileURL(resolve(site, "examples/index.html")).href);
  const link = page.locator("a.open-in-kadr").first(),
    name = /: (.*)/.exec(await link.textContent())[1];
  must(/kadr\/kadr\.html#/.test(await link.getAttribute("href")), "it leads to the page that only a host shows");
  await link.click();
  await runs(name);
});
must(part || links.size > 50, `only ${links.size} links`);
if (errors.length) console.log("errors:", errors, ++failed && "");
await close();
await host.close();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
