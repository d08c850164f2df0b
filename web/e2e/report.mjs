// Opens reports of `kadr report` as files, without a network: node e2e/report.mjs SMALL WRONG LONG (tests/report.py
// creates them).
import { pathToFileURL } from "node:url";
import { browser, until } from "./browser.mjs";

let passed = 0;
const failures = [];
const expect = (what, name) => {
  if (what) passed++;
  else {
    failures.push(name);
    console.log(`FAILED: ${name}`);
  }
};

const [small, wrong, long] = process.argv.slice(2);
const { context, page, errors, close } = await browser();
const asked = [];
await context.setOffline(true);
page.on("request", (r) => {
  if (!/^(file|blob):/.test(r.url())) asked.push(r.url());
});

/// Counts the pixels of the sheet's picture that differ from its background, to check that something is drawn.
async function drawn() {
  await page.getByRole("button", { name: /Set-up sheet|Карта наладки/ }).click();
  await until(
    "the picture is loaded",
    () => page.evaluate(() => (document.querySelector("img.sheet-picture")?.naturalWidth ?? 0) > 0),
    60_000,
  );
  const n = await page.evaluate(() => {
    const copy = Object.assign(document.createElement("canvas"), { width: 400, height: 300 }),
      c = copy.getContext("2d");
    c.drawImage(document.querySelector("img.sheet-picture"), 0, 0, 400, 300);
    const d = c.getImageData(0, 0, 400, 300).data;
    let n = 0;
    for (let i = 4; i < d.length; i += 4)
      if (Math.abs(d[i] - d[0]) + Math.abs(d[i + 1] - d[1]) + Math.abs(d[i + 2] - d[2]) > 30) n++;
    return n;
  });
  await page.keyboard.press("Escape");
  await until("the sheet is closed", async () => !(await page.locator("img.sheet-picture").count()));
  return n;
}
const text = (selector) => page.locator(selector).first().innerText();
async function open(file, ms = 60_000) {
  await page.goto(pathToFileURL(file).href);
  await until(
    `${file} is shown`,
    () => page.evaluate(() => /\d/.test(document.querySelector(".run-told")?.textContent ?? "")),
    ms,
  );
}

await open(small);
await page.getByRole("button", { name: "EN", exact: true }).click();
await until("English", async () => /Set-up sheet/.test(await text(".topbar")));
expect((await drawn()) > 200, "the path is drawn");
const cube = await page.locator(".view-cube").boundingBox();
expect(cube && cube.width <= 140 && cube.height <= 140, `the cube of the view is small: ${JSON.stringify(cube)}`);
expect(
  (await page.title()).startsWith("cover.nc"),
  `its title is the program's, not a comment's: ${await page.title()}`,
);
expect((await page.locator("img").count()) === 0, "a comment makes no image");
expect(/onerror/.test(await text(".virtual-rows")), "the source is shown as it is");
await page.keyboard.press("End");
await until("the end", async () => /left 0:00/.test(await text(".state")));
expect(true, "End goes to the end");
await page.locator(".virtual-row[data-line='8']").click();
await until("line 8", async () => /line 8/.test(await text(".state")));
expect(/G3 X0/.test(await text(".block-text")), "a click on a line goes to its instant");
for (const gone of ["Save", "Compare", "Run"])
  expect((await page.getByRole("button", { name: gone, exact: true }).count()) === 0, `there is no ${gone}`);
expect(
  (await page.locator("input[type=text], select[aria-label=Control]").count()) === 0 ||
    !(await page.locator(".choices").count()),
  "no choice of control",
);

await page.getByRole("button", { name: "Set-up sheet" }).click();
const sheet = page.locator(".sheet");
await sheet.waitFor();
expect(/G54/.test(await sheet.innerText()) && /X -100\.000/.test(await sheet.innerText()), "zeros on the sheet");
expect((await sheet.locator("svg.tool-picture polygon").count()) > 0, "tools have their shapes");
expect((await sheet.locator("img.sheet-picture").count()) === 1, "the picture is on the sheet");
await until("the picture is loaded", () =>
  page.evaluate(() => (document.querySelector("img.sheet-picture")?.naturalWidth ?? 0) > 0),
);
expect((await page.pdf({ format: "A4" })).length > 5000, "it can be printed");
await page.keyboard.press("Escape");
await page.getByRole("button", { name: "Licences" }).click();
expect(/three/.test(await text(".licences")), "the licences are shown");
await page.keyboard.press("Escape");
await page.getByRole("button", { name: "РУ" }).click();
await until("Russian", async () => /Карта наладки/.test(await text(".topbar")));
expect(
  await until("the Russian source", async () => /КРЕПИТЬ/.test(await text(".virtual-rows"))).catch(() => false),
  `Russian source: ${await page.locator(".source-host").innerText()}`,
);

await open(wrong);
await page.locator("[data-tab=problems]").click();
expect(
  (await page.locator(".problem.alarm").count()) >= 1 && (await page.locator(".problem .hint").count()) >= 1,
  "the alarm with its hint",
);

const begun = Date.now();
await open(long, 120_000);
console.log(`100,000 blocks: shown after ${((Date.now() - begun) / 1000).toFixed(1)} s`);
expect((await drawn()) > 2000, "100,000 blocks are drawn");
await page.locator("[data-tab=worst]").click();
expect((await page.locator(".worst").count()) === 1, "slow places");

expect(asked.length === 0, `nothing is asked of the network: ${asked}`);
expect(errors.length === 0, `no error on the page: ${errors.join("; ")}`);
await close();
console.log(`${passed} passed, ${failures.length} failed`);
process.exit(failures.length ? 1 : 0);
