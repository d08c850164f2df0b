// A small menu below a button, as ARIA defines it: arrows move, Escape closes and returns the focus.
import { button, h } from "./dom";

export type MenuRow = { name: string; go: () => void; disabled?: boolean };

export function open_menu(below: HTMLElement, label: string, rows: MenuRow[]): void {
  const close = (): void => {
    menu.remove();
    document.removeEventListener("pointerdown", outside, true);
  };
  const outside = (e: Event): void => {
    if (!menu.contains(e.target as Node)) close();
  };
  const menu = h(
    "div",
    { class: "row-menu", role: "menu", "aria-label": label },
    ...rows.map((row) =>
      button(
        row.name,
        () => {
          close();
          row.go();
        },
        { role: "menuitem", disabled: row.disabled ?? false },
      ),
    ),
  );
  document.body.append(menu);
  const at = below.getBoundingClientRect(),
    size = menu.getBoundingClientRect();
  menu.style.left = `${Math.max(4, Math.min(at.left, innerWidth - size.width - 4))}px`;
  menu.style.top = `${at.bottom + size.height < innerHeight ? at.bottom : Math.max(4, at.top - size.height)}px`;
  const items = [...menu.querySelectorAll<HTMLButtonElement>("button:not(:disabled)")];
  menu.addEventListener("keydown", (e) => {
    const here = items.indexOf(document.activeElement as HTMLButtonElement),
      way = { ArrowDown: 1, ArrowUp: -1 }[e.key];
    if (way) items[(here + way + items.length) % items.length]?.focus();
    else if (e.key === "Escape" || e.key === "Tab") {
      close();
      below.focus();
    } else return;
    e.preventDefault();
    e.stopPropagation();
  });
  document.addEventListener("pointerdown", outside, true);
  items[0]?.focus();
}
