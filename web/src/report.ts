// Assembles a report: the page's viewer without a server, with its data inside the file.
import "uplot/dist/uPlot.min.css";
import "./style/base.css";
import "./style/dialogs.css";
import "./style/panes.css";
import "./style/scene_pane.css";
import "./style/state.css";
import "./style/lists.css";
import "./style/cut.css";
import "./style/timeline.css";
import "./style/workshop.css";
import "./style/view.css";
import "./style/code.css";
import "./style/in_editor.css";
import "./style/print.css";
import { App } from "./model/app";
import { is_of_cut } from "./model/listed";
import { keep_nothing_of_tab } from "./model/memory";
import { with_inserts, type Shape } from "./model/tool_shape";
import type { Problem } from "./protocol/types";
import { unpack, type Report } from "./report/data";
import { EditorLink } from "./report/editor";
import { FindingsPanel } from "./report/findings";
import { show_licences } from "./report/licences";
import { ReportSocket } from "./report/socket";
import { SourcePane } from "./source/pane";
import { of_program } from "./source/problems_of";
import { language, on_language, set_language, t } from "./texts/texts";
import { fill, h } from "./ui/dom";
import { show_help } from "./ui/help";
import { listen_keys, step_mark } from "./ui/keys";
import { layout, next_pane, Tabs } from "./ui/layout";
import { Player } from "./ui/player";
import { ProblemsPanel } from "./ui/problems_panel";
import { ScenePane } from "./ui/scene_pane";
import { show_sheet } from "./ui/sheet";
import { StatePane } from "./ui/state_pane";
import { SummaryPanel } from "./ui/summary";
import { timeline } from "./ui/timeline";
import { toast } from "./ui/toast";
import { Topbar } from "./ui/topbar";
import { WorstPanel } from "./ui/worst_panel";

keep_nothing_of_tab(); // the tab may show another report next
const editor = EditorLink.of_window();
set_language(language());
const held = document.getElementById("kadr-data")?.textContent ?? "";
unpack(held).then(show, (e: unknown) => {
  document.body.append(
    h("p", { class: "banner", role: "alert" }, `${t("report_damaged")} ${e instanceof Error ? e.message : String(e)}`),
  );
});

function show(report: Report): void {
  let { data } = report;
  if (editor) set_language(data.language);
  let socket: ReportSocket | null = null;
  const app = new App(() => (socket = new ReportSocket(report)));
  const player = new Player(app);
  let shapes = shapes_of(report);
  const scene_pane = new ScenePane(app, (v) => {
    app.seek(v.time);
    if (v.file === 0) source.show(v.line);
    editor?.pick(v.line, v.file === 0 ? "" : (data.sources.find((s) => s.file === v.file)?.name ?? ""));
  });
  const { scene } = scene_pane;
  const source = new SourcePane(app, (line, file) => void go_to_line(line, file));
  const state = new StatePane(app, (line, file) => void go_to_line(line, file));
  const problems = new ProblemsPanel(app, jump_to, () => undefined);
  const part = new FindingsPanel(app, jump_to);
  const tabs = new Tabs([
    { name: "summary", element: new SummaryPanel(app).element },
    { name: "problems", element: problems.element, badge: () => problems.badge() },
    {
      name: "worst",
      element: new WorstPanel(app, (line, file) => {
        if (file === 0) source.show(line);
      }).element,
    },
    ...(data.en.cut
      ? [
          {
            name: "part" as const,
            element: part.element,
            badge: () => part.badge(),
          },
        ]
      : []),
  ]);
  const top = new Topbar(app, {
    sheet: () => void show_sheet(app, () => scene_pane.picture(), shapes),
    licences: () => show_licences(data.licences),
    help: () => show_help(),
    theme: (dark) => scene?.setTheme(dark),
  });
  const told = h("div", { class: "report-told note" });
  const tell = (): void =>
    fill(
      told,
      t("report_of", { file: data.file, date: data.made, version: data.version }),
      data.thinned > 0 && ` ${t("report_thinned", { by: data.thinned })}`,
      data.part && ` ${t("report_part", { off: Number(data.part.off.toFixed(3)) })}`,
    );
  on_language(tell);
  tell();
  document.body.append(
    layout({
      top: top.element,
      banner: told,
      files: h("div", { hidden: true }),
      source: source.element,
      scene: scene_pane.element,
      state: state.element,
      tabs: tabs.element,
      bottom: timeline(app, player, (way) => step_mark(app, ["tool"], way)),
    }),
  );

  app.on_path.on((frame) => scene?.addPath(frame));
  app.on_part.on((frame) => scene?.setPart(frame));
  let shown_whole = false;
  let replaced = false; // by the next report of the same program: the old path stays until the new one is there
  app.on_opening.on(() => {
    shown_whole = false;
    editor?.opening();
    if (replaced) scene?.replacePath();
    else scene?.clearPath();
    scene?.setPart(null);
    scene?.setBoxes([]);
  });
  let fitted = false;
  app.on_done.on((done) => {
    scene?.setTools(shapes);
    scene?.endPath();
    shown_whole = true;
    if (done.extents.cutting) scene?.setBoxes([{ name: t("extents"), kind: "extents", box: done.extents.cutting }]);
    if (!fitted) scene?.view("fit");
    fitted = true;
  });
  app.on_instant.on((at) => scene?.setInstant(at));
  app.on_state.on((s) => {
    if (s) scene?.highlight(s.line, s.file ?? 0);
    if (s && !s.file && shown_whole) editor?.show(s.line);
  });
  for (const s of [app.on_problems, app.on_cut]) s.on(() => tabs.draw());
  app.on_opened.on((o) => {
    document.title = `${o.file} · Kadr`;
  });
  app.on_error.on((text) => toast(text, true));
  listen_keys(app, player, {
    view: (name) => scene?.view(name),
    measure: () => scene_pane.toggle_measure(),
    rapids: () => scene_pane.toggle_rapids(),
    help: () => show_help(),
    save: () => undefined,
    leave: () => scene_pane.leave(),
    next_pane,
  });
  app.client.connect();
  editor?.on_theme((dark) => top.set_dark(dark));
  editor?.on_line.on((line) => void go_to_line(line, 0));
  editor?.on_report.on((text) => {
    unpack(text).then(
      (next) => {
        replaced = true;
        ({ data } = next);
        shapes = shapes_of(next);
        socket?.replace(next);
        set_language(data.language);
        void app.open({ file: next.data.file }, app.instant, true);
      },
      (e: unknown) => toast(String(e), true),
    );
  });

  /// Goes to the pass of a line that is nearest to the slider.
  async function go_to_line(line: number, file: number): Promise<void> {
    scene?.highlight(line, file);
    if (app.done) await app.seek_line(line, file);
  }
  function jump_to(p: Problem): void {
    if (p.at !== undefined) app.seek(p.at);
    if (is_of_cut(p)) void app.seek_line(p.line, p.file); // the block that hits is the one that starts there, not the one that ends
    if (of_program(p, app.opened?.file ?? "")) source.show(p.line);
  }
}

function shapes_of(report: Report): Shape[] {
  const { sheet, cut } = report.data.en;
  return sheet.tools.map((x) =>
    with_inserts({ number: x.number, cutting: x.outline ?? [], shank: [], holder: [] }, cut?.inserts ?? []),
  );
}
