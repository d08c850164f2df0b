// The layout of the panes, and the bars between them that are dragged or moved by the arrow keys; sizes are
// remembered.
import { remember, remembered } from "../model/memory";
import { on_language, t, type TextKey } from "../texts/texts";
import { fill, h } from "./dom";

const sizes: Record<string, [number, number, number]> = {
  left: [380, 200, 900],
  right: [340, 260, 800],
  bottom: [150, 110, 400],
  lower: [260, 80, 900],
}; // px: initial, least, greatest

export interface Panes {
  top: HTMLElement;
  banner: HTMLElement;
  files: HTMLElement;
  source: HTMLElement;
  scene: HTMLElement;
  state: HTMLElement;
  tabs: HTMLElement;
  bottom: HTMLElement;
}

export function layout(p: Panes): HTMLElement {
  const left = h("div", { class: "left" }, p.files, p.source),
    right = h("div", { class: "right" }, p.state, bar("lower", "y", -1), p.tabs);
  const main = h("main", { class: "main-panes" }, left, bar("left", "x", 1), p.scene, bar("right", "x", -1), right);
  return h("div", { class: "page" }, p.top, p.banner, main, bar("bottom", "y", -1), p.bottom);
}

/// `way`: whether the pane grows with the mouse or against it.
function bar(name: string, direction: "x" | "y", way: 1 | -1): HTMLElement {
  const [first, least, most] = sizes[name]!;
  let size = remembered(`size.${name}`, first);
  const e = h("div", {
    class: `splitter ${direction}`,
    role: "separator",
    tabindex: "0",
    "aria-orientation": direction === "x" ? "vertical" : "horizontal",
    "aria-valuemin": least,
    "aria-valuemax": most,
  });
  const set = (v: number): void => {
    size = Math.min(most, Math.max(least, v));
    document.documentElement.style.setProperty(`--${name}`, `${size}px`);
    e.setAttribute("aria-valuenow", String(Math.round(size)));
    e.setAttribute("aria-label", t("resize"));
    remember(`size.${name}`, size);
  };
  let from = 0,
    before = 0;
  e.addEventListener("pointerdown", (event) => {
    e.setPointerCapture(event.pointerId);
    from = direction === "x" ? event.clientX : event.clientY;
    before = size;
  });
  e.addEventListener("pointermove", (event) => {
    if (e.hasPointerCapture(event.pointerId))
      set(before + way * ((direction === "x" ? event.clientX : event.clientY) - from));
  });
  e.addEventListener("dblclick", () => set(first));
  e.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -16, ArrowUp: -16, ArrowRight: 16, ArrowDown: 16 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    set(size + way * step);
  });
  set(size);
  return e;
}

export interface Tab {
  name: TextKey;
  element: HTMLElement;
  badge?: () => string;
  whole?: () => boolean;
} // whole: it replaces the pane above

/// Tabs as ARIA defines them: one is in the tab order, arrows move between them.
export class Tabs {
  readonly element = h("section", { class: "pane tabs" });
  private list = h("div", { class: "tab-list", role: "tablist" });
  private host = h("div", { class: "pane-body", role: "tabpanel", tabindex: "0" });
  private chosen: TextKey;

  constructor(
    private tabs: Tab[],
    private chose: (name: TextKey) => void = () => {},
  ) {
    this.chosen = tabs[0]!.name;
    this.element.append(this.list, this.host);
    this.list.addEventListener("keydown", (e) => {
      const way = e.key === "ArrowRight" ? 1 : e.key === "ArrowLeft" ? -1 : 0;
      if (!way) return;
      e.preventDefault();
      e.stopPropagation();
      const i = tabs.findIndex((x) => x.name === this.chosen);
      this.choose(tabs[(i + way + tabs.length) % tabs.length]!.name);
      (this.list.querySelector("[aria-selected=true]") as HTMLElement).focus();
    });
    on_language(() => this.draw());
    this.draw();
  }

  choose(name: TextKey): void {
    this.chosen = name;
    this.draw();
    this.chose(name);
  }

  draw(): void {
    fill(
      this.list,
      ...this.tabs.map((x) => {
        const on = x.name === this.chosen,
          badge = x.badge?.();
        return h(
          "button",
          {
            type: "button",
            role: "tab",
            "aria-selected": String(on),
            tabindex: on ? "0" : "-1",
            "data-tab": x.name,
            onclick: () => this.choose(x.name),
          },
          t(x.name),
          badge ? h("span", { class: "count" }, badge) : null,
        );
      }),
    );
    const tab = this.tabs.find((x) => x.name === this.chosen)!;
    this.element.classList.toggle("whole", Boolean(tab.whole?.()));
    if (this.host.firstChild !== tab.element) this.host.replaceChildren(tab.element);
    this.host.setAttribute("aria-label", t(tab.name));
  }
}

/// Moves the focus to the next pane that is shown, or to the previous one; a pane without a field takes it itself.
export function next_pane(way: 1 | -1): void {
  const panes = [...document.querySelectorAll<HTMLElement>(".files, .source, .scene, .state, .tabs, .timeline")].filter(
    (e) => e.checkVisibility(),
  );
  const here = panes.findIndex((e) => e.contains(document.activeElement)),
    next = panes[(here + way + panes.length) % panes.length];
  if (!next) return;
  const fields = next.querySelectorAll<HTMLElement>(
    "[contenteditable=true], [tabindex='0'], button:not(:disabled), select, input, canvas",
  );
  for (const field of fields) {
    field.focus();
    if (document.activeElement === field) return;
  }
  next.tabIndex = -1;
  next.focus();
}
