// Keys of the operator's screen (docs/operator.md). Hold and the emergency stop act always; nothing else acts while text
// is typed or a dialogue is open. Space never starts: it is the key that is hit by accident.
import type { Operator } from "../model/operator";
import { tab_names, type OperatorScreen } from "./screen";

export interface ScreenVerbs {
  shown(): boolean;
  leave(): void;
  enter(): void;
  help(): void;
}

const jog_keys: Record<string, [string, 1 | -1]> = {
  ArrowRight: ["X", 1],
  ArrowLeft: ["X", -1],
  ArrowUp: ["Y", 1],
  ArrowDown: ["Y", -1],
  PageUp: ["Z", 1],
  PageDown: ["Z", -1],
};

export function listen_operator_keys(operator: Operator, screen: OperatorScreen, verbs: ScreenVerbs): void {
  const spare_space = (e: KeyboardEvent): void => {
    if (e.code === "Space" && e.target instanceof Element && e.target.closest("[data-starts]")) e.preventDefault();
  };
  window.addEventListener("keyup", spare_space, true);
  window.addEventListener("keydown", spare_space, true);
  window.addEventListener(
    "keydown",
    (e) => {
      if (verbs.shown()) {
        const act = always(e) ?? (busy(e) ? null : here(e));
        if (!act) return;
        e.preventDefault();
        e.stopImmediatePropagation();
        act();
      } else if (e.code === "KeyO" && !busy(e) && plain(e)) {
        e.preventDefault();
        verbs.enter();
      }
    },
    true,
  );
  window.addEventListener("keyup", (e) => {
    if (e.key in jog_keys) screen.manual.release_held();
  });

  /// Also while text is typed.
  function always(e: KeyboardEvent): (() => void) | null {
    if (e.key === "F1") return () => screen.keys.press_stop();
    if (e.key === "Escape" && operator.panel?.mode === "running") return () => screen.keys.press_hold();
    return null;
  }

  function here(e: KeyboardEvent): (() => void) | null {
    const axis = jog_keys[e.key];
    if (axis && screen.tab === "op_manual" && !e.ctrlKey && !own_arrows(e.target)) {
      const [name, sign] = axis;
      // A key that repeats would count as many presses; held axes move anyway.
      return () => (e.repeat ? undefined : screen.manual.press(name, sign, e.shiftKey));
    }
    if (e.key === "?" || (e.shiftKey && (e.code === "Slash" || e.code === "Digit7"))) return verbs.help;
    if (e.key === "F6") return () => next_region(e.shiftKey ? -1 : 1);
    if (e.repeat || !plain(e)) return null;
    const tab = /^Digit([1-5])$/.exec(e.code)?.[1];
    if (tab) return () => screen.choose(tab_names[Number(tab) - 1]!);
    switch (e.code) {
      case "Escape":
        return operator.panel && operator.panel.mode !== "emergency" ? () => screen.keys.press_reset() : null;
      case "KeyR":
        return () => screen.keys.press_start();
      case "KeyP":
        return () => screen.keys.press_hold();
      case "KeyO":
        return verbs.leave;
      case "Equal":
      case "NumpadAdd":
        return () => screen.overrides.change("override", 10);
      case "Minus":
      case "NumpadSubtract":
        return () => screen.overrides.change("override", -10);
      case "Digit0":
        return () => screen.overrides.change("override", null);
      case "Space":
        return focused(e.target) ? null : () => {}; // the player of the page must not begin behind the screen
      default:
        return null;
    }
  }

  function next_region(way: 1 | -1): void {
    const regions = [
      ...screen.element.querySelectorAll<HTMLElement>(".screen-head, .override-rows, .tab-list, .pane-body, .big-keys"),
    ];
    const at = regions.findIndex((e) => e.contains(document.activeElement)),
      next = regions[(at + way + regions.length) % regions.length]!;
    (next.querySelector<HTMLElement>("button:not(:disabled):not([tabindex='-1']), input, select") ?? next).focus();
  }
}

const plain = (e: KeyboardEvent): boolean => !e.ctrlKey && !e.altKey && !e.metaKey && !e.shiftKey;

/// Text is typed, or a dialogue is open.
function busy(e: KeyboardEvent): boolean {
  if (document.querySelector("dialog[open]:not(.docked)")) return true;
  const { target } = e;
  return (
    target instanceof HTMLElement &&
    (target.isContentEditable || ["SELECT", "TEXTAREA"].includes(target.tagName) || is_text(target))
  );
}
const is_text = (e: HTMLElement): boolean =>
  e instanceof HTMLInputElement && !["checkbox", "range", "button"].includes(e.type);
/// These move between their own parts by arrows.
const own_arrows = (e: EventTarget | null): boolean =>
  e instanceof Element && Boolean(e.closest("[role=tablist], [role=slider], .splitter, input"));
const focused = (e: EventTarget | null): boolean =>
  e instanceof HTMLElement && ["BUTTON", "SUMMARY", "A", "INPUT"].includes(e.tagName);
