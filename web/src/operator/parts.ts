// Small parts of the operator's screen. Its elements stay the same while the machine moves: a button that was drawn
// again would lose the finger that holds it.
import type { App } from "../model/app";
import { t } from "../texts/texts";
import { button, h } from "../ui/dom";

/// What to do to have a machine.
export const off_told = (app: App): string => t(app.opened ? "op_off_ready" : "op_off_long");

/// A button that shows whether it is on; `press` gets the wanted state.
export function toggle(press: (on: boolean) => void, attributes: Record<string, unknown> = {}): HTMLButtonElement {
  const b: HTMLButtonElement = button("", () => press(b.getAttribute("aria-pressed") !== "true"), {
    "aria-pressed": false,
    ...attributes,
  });
  return b;
}

/// An element of the page that the operator's screen shows for some time, and then gives back to its place.
export class Borrowed {
  private place = document.createComment("");

  constructor(private element: HTMLElement) {}

  take(into: HTMLElement): void {
    if (!this.place.isConnected && this.element.parentNode) this.element.replaceWith(this.place);
    if (this.element.parentNode !== into) into.append(this.element);
  }
  give_back(): void {
    if (this.place.parentNode) this.place.replaceWith(this.element);
  }
}

/// A heading for a part of a tab.
export const heading = (text: string): HTMLElement => h("h3", null, text);
