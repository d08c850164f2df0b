// A tour of five steps over the panes. It can be left at any time, and called again from the help.
import { on_language, t, type TextKey } from "../texts/texts";
import { button, fill, h } from "./dom";

const steps: { of: string; title: TextKey; text: TextKey }[] = [
  { of: ".left", title: "tour_1", text: "tour_1_long" },
  { of: ".scene", title: "tour_2", text: "tour_2_long" },
  { of: ".timeline", title: "tour_3", text: "tour_3_long" },
  { of: ".right", title: "tour_4", text: "tour_4_long" },
  { of: "[data-tab=panel]", title: "tour_5", text: "tour_5_long" },
];
const margin = 12; // px

let leave: (() => void) | null = null;

export function show_tour(): void {
  leave?.();
  let at = 0;
  const before = document.activeElement as HTMLElement | null,
    ring = h("div", { class: "tour-ring" }),
    card = h("div", { class: "tour", role: "dialog", "aria-live": "polite", tabindex: "-1" });
  const go = (way: 1 | -1): void => {
    at = Math.min(steps.length - 1, Math.max(0, at + way));
    draw();
  };
  const place = (): void => place_card(document.querySelector(steps[at]!.of), ring, card);
  const draw = (): void => {
    const step = steps[at]!,
      last = at === steps.length - 1;
    card.setAttribute("aria-label", t(step.title));
    fill(
      card,
      h("p", { class: "dim" }, t("tour_at", { n: at + 1, m: steps.length })),
      h("h2", null, t(step.title)),
      h("p", null, t(step.text)),
      h(
        "div",
        { class: "row end" },
        button(t(last ? "close" : "tour_leave"), () => leave?.(), { class: last ? "main" : "" }),
        at > 0 && button(t("tour_back"), () => go(-1)),
        !last && button(t("tour_next"), () => go(1), { class: "main" }),
      ),
    );
    place();
    card.focus();
  };
  const off = on_language(draw);
  card.addEventListener("keydown", (e) => {
    if (e.key === "Escape") leave?.();
    else if (e.key === "ArrowRight") go(1);
    else if (e.key === "ArrowLeft") go(-1);
    else return;
    e.preventDefault();
    e.stopPropagation();
  });
  window.addEventListener("resize", place);
  leave = () => {
    off();
    window.removeEventListener("resize", place);
    ring.remove();
    card.remove();
    leave = null;
    before?.focus();
  };
  document.body.append(ring, card);
  draw();
}

/// The ring is around the target, the card next to it; above it where there is no room.
function place_card(target: Element | null, ring: HTMLElement, card: HTMLElement): void {
  const box = target?.getBoundingClientRect() ?? new DOMRect(innerWidth / 2, innerHeight / 2, 0, 0),
    { width, height } = card.getBoundingClientRect();
  Object.assign(ring.style, {
    left: `${box.left}px`,
    top: `${box.top}px`,
    width: `${box.width}px`,
    height: `${box.height}px`,
  });
  const right = box.right + margin + width < innerWidth,
    left = box.left - margin - width > 0,
    x = right ? box.right + margin : left ? box.left - margin - width : box.left + margin,
    y = right || left ? box.top + margin : box.top - margin - height;
  card.style.left = `${Math.max(margin, Math.min(x, innerWidth - width - margin))}px`;
  card.style.top = `${Math.max(margin, Math.min(y, innerHeight - height - margin))}px`;
}
