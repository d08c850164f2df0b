// Puts the operator's screen next to the page, and shows one of the two.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import { listen_operator_keys } from "./keys";
import { OperatorMode } from "./mode";
import { OperatorScreen, type OperatorPanes } from "./screen";

export function operator_screen(app: App, operator: Operator, panes: OperatorPanes): OperatorMode {
  const mode = new OperatorMode(location.search),
    screen = new OperatorScreen(app, operator, panes, () => mode.set(false)),
    page = document.querySelector<HTMLElement>(".page")!;
  document.body.append(screen.element);
  const show = (on: boolean): void => {
    if (on) screen.open();
    else screen.close();
    page.hidden = on;
    document.body.classList.toggle("operates", on);
    dispatchEvent(new Event("resize")); // canvases measure their size again
  };
  mode.on_change.on(show);
  listen_operator_keys(operator, screen, {
    shown: () => mode.on,
    leave: () => mode.set(false),
    enter: () => mode.set(true),
    help: panes.help,
  });
  if (mode.on) show(true);
  return mode;
}
