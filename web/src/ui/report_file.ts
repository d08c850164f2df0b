// "Report": the file of `kadr report` for the open program, with the cut that the page shows, as a download.
import type { App } from "../model/app";
import { t } from "../texts/texts";
import { save_file } from "./download";
import { toast } from "./toast";

export async function save_report(app: App): Promise<void> {
  try {
    if (!(await app.run_shown())) return;
    const { html, name } = await app.client.ask("report", {});
    save_file(name, new Blob([html], { type: "text/html" }));
    toast(t("report_made", { file: name }));
  } catch (e) {
    app.tell(e);
  }
}
