// Pictures of the page that a person has looked at: the operator's screen, files, the page at work, the set-up; in both
// languages and both themes. Used by page.mjs.
import { at_screen } from "./at_screen.mjs";
import { looks_at, until } from "./browser.mjs";
import { compares } from "./pictures.mjs";

export function picture_steps(place) {
  const { kadr, page } = place,
    { count, ended } = looks_at(() => page),
    screen = at_screen(place),
    { compare, must_be_same } = compares(place);
  const skipped = "skipped: the made-up session has no machine";
  async function speak(lang) {
    await page.evaluate((to) => {
      const text = to === "en" ? "EN" : "РУ";
      [...document.querySelectorAll(".topbar .switch button")].find((b) => b.textContent === text).click();
    }, lang);
    await page.waitForTimeout(600);
  }
  const theme = (name) =>
    page.evaluate((to) => {
      document.documentElement.dataset.theme = to;
    }, name);
  /// What comes and goes by itself; the view, which depends on the driver; the folder, which has another name each time.
  const hide = () =>
    page.addStyleTag({
      content: ".toasts { display: none } .scene-host canvas, .flags, .crumbs { visibility: hidden }",
    });
  const operator_tab = (name) => page.click(`.operator-screen [data-tab=op_${name}]`);
  const program_text = async () => {
    await operator_tab("program");
    await page.click(".program-tab > .switch button >> nth=1"); // the text: a 3D view depends on the driver
  };

  return {
    async "the operator's screen looks as a person has seen it"() {
      if (!process.env.KADR) return skipped;
      await screen.open("zero.nc");
      await hide();
      for (const lang of ["en", "ru"]) {
        await speak(lang);
        await program_text();
        await compare(`operator_program_${lang}`);
        for (const tab of ["manual", "tool_zero", "restart"]) {
          await operator_tab(tab);
          await compare(`operator_${tab}_${lang}`);
        }
      }
      await theme("dark");
      await operator_tab("manual");
      await compare("operator_manual_dark_ru");
      await theme("light");
      await speak("en");
      must_be_same();
    },
    async "the operator's screen of 1920 by 1080 looks as a person has seen it"() {
      if (!process.env.KADR) return skipped;
      await screen.open("zero.nc");
      await page.setViewportSize({ width: 1920, height: 1080 });
      await hide();
      await program_text();
      await compare("operator_wide_program_en");
      await operator_tab("manual");
      await compare("operator_wide_manual_en");
      await page.keyboard.press("o");
      await page.setViewportSize({ width: 1600, height: 1000 });
      must_be_same();
    },
    async "files, the page at work and the set-up look as a person has seen them, in Russian and in the dark"() {
      if (!process.env.KADR) return skipped;
      await page.goto(`${new URL(kadr.address()).origin}/`);
      await until("the files", () => count(".file-row"));
      await ended(); // the program that was open last
      await page.click(".crumbs button >> nth=0");
      for (const name of ["cut", "plate.nc"]) await page.click(`.file-row:has(.file-name:text-is("${name}"))`);
      await until("its text", async () =>
        (await page.locator(".source .pane-title").textContent()).includes("plate.nc"),
      );
      await ended();
      await hide();
      const tab = (name) => page.click(`.tabs:visible [data-tab=${name}]`);
      for (const [lang, look] of [
        ["ru", "light"],
        ["ru", "dark"],
      ]) {
        await speak(lang);
        await theme(look);
        await ended();
        await tab("summary");
        await page.locator(".slider").focus();
        await page.keyboard.press("End");
        await compare(`work_${look}_${lang}`);
        await tab("setup_tab");
        await until("the form", () => count(".setup-form .setup-table"));
        await compare(`setup_${look}_${lang}`);
      }
      must_be_same();
    },
  };
}
