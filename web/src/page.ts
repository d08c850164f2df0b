// Assembles the page: one app, its panes, and their connections.
import "./style/page";
import { App } from "./model/app";
import { Live } from "./model/live";
import { is_of_cut } from "./model/listed";
import { shape_of, with_inserts, type Shape } from "./model/tool_shape";
import { DiskWatch } from "./model/disk_watch";
import { remember, remembered } from "./model/memory";
import { alone, socket } from "./protocol/way";
import type { Problem } from "./protocol/types";
import type { SceneBox } from "./scene/scene";
import { of_program } from "./source/problems_of";
import { SetupPanel } from "./setup/setup_panel";
import { OutlinePane } from "./source/outline_pane";
import { SourcePane } from "./source/pane";
import { editor_view } from "./source/editor";
import { apply_fix } from "./source/problems";
import { language, on_language, set_language, t, type TextKey } from "./texts/texts";
import { EditDialog } from "./editing/edit_dialog";
import { banner } from "./ui/banner";
import { show_compare } from "./ui/compare";
import { ConvertDialog } from "./ui/converting";
import { CutPanel } from "./ui/cut_panel";
import { disk_notice } from "./ui/disk_notice";
import { FilesDrawer } from "./ui/files";
import { h } from "./ui/dom";
import { show_help } from "./ui/help";
import { listen_keys, step_mark } from "./ui/keys";
import { MakingDialog } from "./ui/making";
import { layout, next_pane, Tabs } from "./ui/layout";
import { follow_machine } from "./ui/machine_view";
import { Operator } from "./model/operator";
import { OperatorPanel } from "./ui/operator_panel";
import { operator_screen } from "./operator/assemble";
import { Player } from "./ui/player";
import { ProblemsPanel } from "./ui/problems_panel";
import { ScenePane } from "./ui/scene_pane";
import { save } from "./ui/save";
import { show_sheet } from "./ui/sheet";
import { Start } from "./ui/start";
import { StatePane } from "./ui/state_pane";
import { SummaryPanel } from "./ui/summary";
import { show_from_tape, show_to_tape } from "./ui/tape";
import { timeline } from "./ui/timeline";
import { toast } from "./ui/toast";
import { show_tour } from "./ui/tour";
import { Topbar } from "./ui/topbar";
import { offer_unsaved } from "./ui/unsaved";

set_language(language());
const app = new App(socket, alone?.open ?? null);
const player = new Player(app);
const operator = new Operator(socket);
let shapes: Shape[] = [],
  stock: SceneBox[] = [],
  shown_file = "";

const scene_pane = new ScenePane(app, (v) => {
  if (v.which & 1) return; // the path of the other version has no time on this program's slider
  app.seek(v.time);
  if (v.file === 0) source.show(v.line);
});
const scene = scene_pane.scene;
const source = new SourcePane(app, (line, file) => void go_to_line(line, file), {
  view: editor_view,
  fix: apply_fix,
  save_as: () => files.save_as(),
});
new OutlinePane(app, source);
const state = new StatePane(app, (line, file) => void go_to_line(line, file));
const problems = new ProblemsPanel(app, jump_to, (fix) => source.fix(fix));
const cut = new CutPanel(
  app,
  (box, tools, inserts) => {
    shapes = tools.map((tool) => with_inserts(shape_of(tool), inserts));
    scene?.setTools(shapes);
    stock = box ? [{ name: t("stock"), kind: "stock", box }] : [];
    show_boxes();
  },
  jump_to,
);
const operator_panel = new OperatorPanel(
  app,
  operator,
  (line) => source.show(line),
  (touched) => scene_pane.ask_touch(touched),
);
const tabs = new Tabs([
  { name: "problems", element: problems.element, badge: () => problems.badge() },
  { name: "summary", element: new SummaryPanel(app).element },
  {
    name: "setup_tab",
    element: new SetupPanel(
      app,
      (line) => source.show(line),
      () => tabs.choose("cut_tab"),
    ).element,
    whole: () => true,
  },
  { name: "cut_tab", element: cut.element, badge: () => cut.badge() },
  {
    name: "panel",
    element: alone ? note("alone_panel") : operator_panel.element,
    badge: () => (operator.panel ? "●" : ""),
    whole: () => Boolean(operator.panel),
  },
]);
const files = new FilesDrawer(app, {
  from_drawing: (folder, drawing) => {
    new MakingDialog(app, socket, folder, drawing);
  },
  to_tape: () => show_to_tape(app),
  from_tape: (folder) => show_from_tape(app, folder),
  convert: () => {
    new ConvertDialog(app, socket, (line, file) => {
      if (file === 0) source.show(line);
      void go_to_line(line, file);
    });
  },
});
const compared = { begin: () => scene?.clearPath(1), line: (n: number) => void go_to_line(n, 0) };
source.tell_above(disk_notice(app, new DiskWatch(app), (name, text) => show_compare(app, compared, { name, text })));
const top = new Topbar(app, {
  files: () => {
    files.element.hidden = !files.element.hidden;
    remember("files_hidden", files.element.hidden);
  },
  sheet: () => void show_sheet(app, () => scene_pane.picture(), shapes),
  edit: () => {
    new EditDialog(app, socket, {
      take: (text) => source.take(text),
      insert: (lines) => source.insert(lines),
      selected: () => source.selected(),
      line: (n) => source.show(n),
      end_paths: () => scene?.clearPath(1),
    });
  },
  compare: () => show_compare(app, compared),
  setup: () => tabs.choose("setup_tab"),
  help: () => show_help(show_tour),
  operator: alone ? undefined : () => mode?.set(true),
  theme: (dark) => scene?.setTheme(dark),
});
files.element.hidden = remembered("files_hidden", false);
const banner_pane = banner(app);
document.body.append(
  layout({
    top: top.element,
    banner: banner_pane,
    files: files.element,
    source: source.element,
    scene: scene_pane.element,
    state: state.element,
    tabs: tabs.element,
    bottom: timeline(app, player, (way) => step_mark(app, ["tool"], way)),
  }),
);

app.on_path.on((frame) => scene?.addPath(frame));
app.on_part.on((frame) => scene?.setPart(frame));
app.on_opening.on((file) => {
  if (file === shown_file) return scene?.replacePath(); // the program runs again: the old picture stays until the new path arrives
  shown_file = file;
  scene?.clearPath();
  scene?.view("fit");
  scene?.setPart(null);
  scene?.setBoxes([]);
});
app.on_done.on(() => {
  show_boxes();
  scene?.endPath();
});
app.on_instant.on((at) => scene?.setInstant(at));
app.on_state.on((s) => s && scene?.highlight(s.line, s.file ?? 0));
for (const s of [app.on_problems, app.on_cut]) s.on(() => tabs.draw());
app.on_opened.on((o) => void (document.title = `${o.file} · Kadr`));
app.on_error.on((text) => toast(text, true));
follow_machine(app, operator, operator_panel.restart.restart, source, scene, () => tabs.draw());

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

/// A sentence in place of a pane.
function note(key: TextKey): HTMLElement {
  const element = h("p", { class: "note" }, t(key));
  on_language(() => (element.textContent = t(key)));
  return element;
}

function show_boxes(): void {
  const all = app.done?.extents.cutting;
  scene?.setBoxes([...stock, ...(all ? [{ name: t("extents"), kind: "extents" as const, box: all }] : [])]);
}

const mode = alone
  ? null
  : operator_screen(app, operator, {
      panel: operator_panel,
      banner: banner_pane,
      files: files.element,
      scene: scene_pane.element,
      source: source.element,
      problems: problems.element,
      show_line: (line) => source.show(line),
      help: () => show_help(show_tour),
    });
listen_keys(app, player, {
  view: (name) => scene?.view(name),
  measure: () => scene_pane.toggle_measure(),
  rapids: () => scene_pane.toggle_rapids(),
  help: () => show_help(show_tour),
  save: () => void save(app),
  save_as: () => files.save_as(),
  leave: () => scene_pane.leave(),
  next_pane,
});
const start = new Start(app, {
  new_program: () => files.new_program(),
  upload: () => files.upload.choose(),
  tour: show_tour,
});
source.tell_above(start.element);
const live = new Live(app);
live.on_old.on((old) => scene_pane.tell_old(old));
files.upload.listen(document.body);
app.on_line.on((line) => {
  if (line === "open") alone?.on_launch((launched) => void files.upload.take(launched));
});
offer_unsaved(app);
window.addEventListener("beforeunload", (e) => {
  app.keep_place();
  if (app.dirty) e.preventDefault(); // the browser asks the user: the tab may be closing
});
app.client.connect();
