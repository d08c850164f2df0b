// The view follows a machine that is on: the tool at its position, the line that it executes, the path that it will take.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import type { Restart } from "../model/restart";
import type { Scene } from "../scene/scene";
import type { SourcePane } from "../source/pane";
import { t } from "../texts/texts";
import { MachineSource } from "./machine_source";
import { toast } from "./toast";

const until_shown = 120; // ms in which the effect of a key is shown before the view uses the browser's time

/// `switched`: the machine has been switched on or off.
export function follow_machine(
  app: App,
  operator: Operator,
  restart: Restart,
  source: SourcePane,
  scene: Scene | null,
  switched: () => void,
): void {
  const machine_source = new MachineSource(app, operator, source);
  let was_on = false,
    panel_line = 0;
  restart.on_change.on(() => scene?.showWay(app.opened?.file === operator.name ? restart.tips() : []));
  operator.on_error.on((text) => toast(text, true));
  operator.on_queued.on(() => toast(t("op_queued")));
  operator.on_press.on(() => scene?.hush(until_shown));
  operator.on_panel.on((p) => {
    if (Boolean(p) !== was_on) {
      was_on = Boolean(p);
      switched();
    }
    const here = p && app.done && app.opened?.file === operator.name;
    if (!here) return scene?.showMachine(null);
    const at = (axis: string): number => (p.position[axis] ?? 0) + (p.zero[axis] ?? 0);
    scene?.showMachine({ at: [at("X"), at("Y"), at("Z")], tool: p.tool ?? 0 });
    if (p.line === panel_line || p.file !== 0 || !machine_source.same) return;
    panel_line = p.line;
    scene?.highlight(p.line, 0);
  });
}
