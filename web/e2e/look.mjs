// The page with a mock session, to look at it: node e2e/look.mjs FOLDER writes pictures there.
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { serve_page } from "../test/mock-server.mjs";
import { session } from "../test/mock-session.mjs";
import { browser, until } from "./browser.mjs";

const folder = process.argv[2] ?? "/tmp/kadr-look";
mkdirSync(folder, { recursive: true });
const server = await serve_page(fileURLToPath(new URL("../dist", import.meta.url)));
const { page, errors, close } = await browser();
await page.routeWebSocket(/\/session$/, (ws) => {
  const answer = session((m) => ws.send(typeof m === "string" ? m : Buffer.from(m)));
  ws.onMessage(answer);
});
const shot = (name) => page.screenshot({ path: join(folder, `${name}.png`) });
try {
  await page.goto(`${server.address}#token=abc`);
  await page.click("text=plate.nc");
  await until("the run's end", () => page.locator(".run-told.ended").count());
  await page.click(".cm-line:has-text('N70')", { position: { x: 30, y: 8 } });
  await page.waitForTimeout(500);
  await shot("light");
  await page.click("[data-tab=cut_tab]");
  await page.click(".cut-run button");
  await until("the cut", () => page.locator(".cut .problem").count());
  await page.click("text=РУ");
  await page.click("[aria-label='Светлая или тёмная тема']");
  await page.waitForTimeout(600);
  await shot("dark_ru");
  await page.click("[data-tab=problems]");
  await page.click("text=Цех");
  await page.waitForTimeout(400);
  await shot("shop");
  await page.click("text=Цех");
  await page.click("[aria-label='Светлая или тёмная тема']");
  await page.click("text=Карта наладки");
  await page.waitForTimeout(300);
  await shot("sheet");
  await page.emulateMedia({ media: "print" });
  await page.waitForTimeout(200);
  await page.screenshot({ path: join(folder, "print.png"), fullPage: true });
  await page.emulateMedia({ media: "screen" });
  await page.keyboard.press("Escape");
  await page.click("text=Сравнить");
  await page.waitForTimeout(200);
  await page.selectOption(".compare select", "plate_2.nc");
  await page.click(".compare button.main");
  await page.waitForTimeout(600);
  await shot("compare");
  await page.click("dialog.docked button.icon");
  await page.click(".file-row:has-text('long.nc')");
  await until("long lines", async () => /N1 G1/.test((await page.locator(".virtual-row").first().textContent()) ?? ""));
  await until("its end", () => page.locator(".run-told.ended").count());
  await page.waitForTimeout(300);
  await page.locator(".virtual").evaluate((e) => {
    e.scrollTop = e.scrollHeight;
  });
  await page.waitForTimeout(300);
  await page.click("[data-tab=summary]");
  await shot("long");
  console.log(
    "rows",
    await page.locator(".virtual-row").count(),
    "last",
    await page.locator(".virtual-row").last().textContent(),
  );
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.waitForTimeout(300);
  await shot("small");
  await page.setViewportSize({ width: 480, height: 900 });
  await page.waitForTimeout(300);
  await page.screenshot({ path: join(folder, "narrow.png"), fullPage: true });
} finally {
  if (errors.length) console.log("errors:", errors);
  await close();
  server.close();
}
