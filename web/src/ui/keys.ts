// Keys of the whole page. They have no effect while text is typed and while a dialogue is open.
import type { App } from "../model/app";
import { next_mark, slider_of, times_of } from "../model/time";
import type { Player } from "./player";

export interface KeyVerbs {
  view(name: "top" | "front" | "left" | "right" | "back" | "iso" | "fit"): void;
  measure(): void;
  rapids(): void;
  help(): void;
  save(): void;
  save_as?(): void;
  leave(): void;
  next_pane(way: 1 | -1): void;
}

export function step_mark(app: App, kinds: string[], way: 1 | -1): void {
  const m = next_mark(app.marks, kinds, app.instant, way);
  if (m) app.seek(m.at);
  else if (kinds[0] === "tool" && way < 0) app.seek(0);
}

export function listen_keys(app: App, player: Player, verbs: KeyVerbs): void {
  const views = ["top", "front", "left", "right", "back", "iso"] as const;
  window.addEventListener("keydown", (e) => {
    if (e.key === "F6") {
      e.preventDefault();
      return verbs.next_pane(e.shiftKey ? -1 : 1);
    }
    if (e.defaultPrevented) return;
    if ((e.ctrlKey || e.metaKey) && e.code === "KeyS") {
      e.preventDefault();
      return e.shiftKey && verbs.save_as ? verbs.save_as() : verbs.save();
    }
    if (document.querySelector("dialog[open]:not(.docked)") || typing(e.target) || e.altKey || e.metaKey) return;
    const act = step_of(e) ?? other(e);
    if (!act) return;
    e.preventDefault();
    act();
  });

  function step_of(e: KeyboardEvent): (() => void) | null {
    const way = e.key === "ArrowRight" ? 1 : e.key === "ArrowLeft" ? -1 : 0;
    if (way) return () => app.step(way * (e.ctrlKey ? 100 : e.shiftKey ? 10 : 1));
    switch (e.key) {
      case "PageDown":
        return () => step_mark(app, ["tool"], 1);
      case "PageUp":
        return () => step_mark(app, ["tool"], -1);
      case "Home":
        return () => app.seek(0);
      case "End":
        return () => app.seek(app.seconds);
      default:
        return null;
    }
  }

  // By the key's position, not by its letter: A is A on a Russian keyboard too.
  function other(e: KeyboardEvent): (() => void) | null {
    if (e.ctrlKey) return null;
    if (e.key === "?" || (e.shiftKey && (e.code === "Slash" || e.code === "Digit7"))) return verbs.help;
    const digit = /^Digit([0-6])$/.exec(e.code)?.[1];
    if (digit) return () => verbs.view(digit === "0" ? "fit" : views[Number(digit) - 1]!);
    const pace = (by: number): void =>
      player.set_times(times_of(Math.min(1, Math.max(0, slider_of(player.times) + by))));
    switch (e.code) {
      case "KeyA":
        return () => step_mark(app, ["alarm", "warning"], e.shiftKey ? -1 : 1);
      case "Space":
        return button_focused(e) ? null : () => player.toggle();
      case "KeyF":
        return () => verbs.view("fit");
      case "KeyM":
        return verbs.measure;
      case "KeyR":
        return verbs.rapids;
      case "Equal":
      case "NumpadAdd":
        return () => pace(0.25);
      case "Minus":
      case "NumpadSubtract":
        return () => pace(-0.25);
      case "Escape":
        return verbs.leave;
      default:
        return null;
    }
  }
}

function typing(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    (target.isContentEditable || ["INPUT", "SELECT", "TEXTAREA"].includes(target.tagName))
  );
}
const button_focused = (e: KeyboardEvent): boolean =>
  e.target instanceof HTMLElement && ["BUTTON", "SUMMARY", "A"].includes(e.target.tagName);
