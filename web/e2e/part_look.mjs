import { spawn } from "node:child_process";
import { browser, until } from "./browser.mjs";
const kadr = process.env.KADR, folder = process.argv[2], pictures = process.argv[3], file = process.argv[4] ?? "plate.nc", shares = (process.argv[5] ?? "0.3,0.6,1").split(",").map(Number);
const p = spawn(kadr, ["serve", folder, "--port", "0", "--no-browser", "--lang", "en"], { stdio: ["ignore", "pipe", "inherit"] });
const address = await new Promise((r) => { let s = ""; p.stdout.on("data", (d) => { s += d; const m = /http:\S+/.exec(s); if (m) r(m[0]); }); });
const { page, errors, close } = await browser();
const shot = (n) => page.screenshot({ path: `${pictures}/${n}.png` });
try {
  await page.goto(address);
  await until("files", () => page.locator(".file-row").count(), 60000);
  await page.locator(".file-row", { has: page.locator(`.file-name:text-is("${file}")`) }).click();
  await until("the end", () => page.locator(".run-told.ended, .run-told.stopped").count(), 60000);
  await page.click("[data-tab=cut_tab]");
  await until("proposals", () => page.locator(".tool-form").count(), 60000);
  await page.waitForTimeout(1500);
  await shot("1_proposed");
  await page.click(".cut-run button");
  await until("cut", () => page.locator(".cut .facts").count(), 120000);
  await page.waitForTimeout(4000);
  await shot("2_cut");
  const box = await page.locator(".slider").boundingBox();
  for (const s of shares) { await page.mouse.click(box.x + 2 + s * (box.width - 4), box.y + box.height / 2); await page.waitForTimeout(5000); await shot(`3_at_${s}`); }
} catch (e) { console.log(String(e)); await shot("failed"); } finally { console.log("errors", errors); await close(); p.kill("SIGINT"); }
