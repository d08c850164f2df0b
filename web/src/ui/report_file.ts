// "Report": the file of `kadr report` for the open program, with the cut that the page shows, as a download.
import type { App } from "../model/app";
import { t } from "../texts/texts";
import { h } from "./dom";
import { toast } from "./toast";

const kept = 60_000; // ms that the browser may need to take the file

export async function save_report(app: App): Promise<void> {
  try {
    if (!(await app.run_shown())) return;
    const { html, name } = await app.client.ask("report", {});
    const address = URL.createObjectURL(new Blob([html], { type: "text/html" }));
    h("a", { href: address, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(address), kept);
    toast(t("report_made", { file: name }));
  } catch (e) {
    app.tell(e);
  }
}
