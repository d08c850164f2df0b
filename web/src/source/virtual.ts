// A program too long to be held in the page: only the visible lines are requested and drawn. The number of elements is
// the same for any length.
import { debounce } from "../model/latest";
import { t } from "../texts/texts";
import { h } from "../ui/dom";
import type { SourceView } from "./editor";
import { token_at } from "./tokens";
import { ScrollMap } from "./virtual_map";

export type Fetch = (from: number, count: number) => Promise<string[]>;
const window_lines = 500,
  windows_kept = 40; // 20,000 lines are kept, some 1 MB

export function virtual_view(
  host: HTMLElement,
  lines: number,
  fetch: Fetch,
  picked: (line: number) => void,
  hover?: (line: number, text: string) => Promise<string>,
): SourceView {
  const rows = h("div", { class: "virtual-rows" });
  const space = h("div", { class: "virtual-space" });
  const box = h(
    "div",
    { class: "virtual", tabindex: "0", role: "listbox", "aria-label": t("source"), "aria-readonly": "true" },
    space,
    rows,
  );
  host.append(box);
  const kept = new Map<number, string[]>(),
    asked = new Set<number>();
  let map = new ScrollMap(lines, 20, 100),
    top = 0,
    running = 0,
    cursor = 1;

  const row_height = (): number => parseFloat(getComputedStyle(box).getPropertyValue("--row")) || 20;
  const measure = (): void => {
    map = new ScrollMap(lines, row_height(), box.clientHeight);
    space.style.height = `${map.height}px`;
    go(top);
  };
  const go = (to: number): void => {
    top = map.bounded(to);
    const scroll = map.scroll_of(top);
    if (Math.abs(box.scrollTop - scroll) > 0.5) box.scrollTop = scroll;
    draw();
  };
  const draw = (): void => {
    const { first, count } = map.seen(top);
    while (rows.childElementCount < count)
      rows.append(
        h(
          "div",
          { class: "virtual-row", role: "option" },
          h("span", { class: "virtual-number" }),
          h("span", { class: "virtual-text" }),
        ),
      );
    while (rows.childElementCount > count) rows.lastElementChild!.remove();
    rows.style.transform = `translateY(${box.scrollTop - (top % map.row)}px)`;
    for (let i = 0; i < count; i++) draw_row(rows.children[i] as HTMLElement, first + i);
    want(first, count);
  };
  const draw_row = (row: HTMLElement, line: number): void => {
    const text = kept.get(Math.floor((line - 1) / window_lines))?.[(line - 1) % window_lines];
    row.dataset.line = String(line);
    row.classList.toggle("cm-running", line === running);
    row.classList.toggle("virtual-cursor", line === cursor);
    row.setAttribute("aria-selected", String(line === cursor));
    row.children[0]!.textContent = String(line);
    row.children[1]!.replaceChildren(...coloured(text ?? "…"));
  };
  // During fast scrolling no lines are requested: only where it stops.
  const want = debounce(40, (first: number, count: number) => {
    for (let w = Math.floor((first - 1) / window_lines); w <= Math.floor((first + count - 2) / window_lines); w++)
      void get(w);
  });
  const get = async (w: number): Promise<void> => {
    if (kept.has(w) || asked.has(w)) return;
    asked.add(w);
    try {
      kept.set(w, await fetch(w * window_lines + 1, Math.min(window_lines, lines - w * window_lines)));
      if (kept.size > windows_kept) kept.delete(kept.keys().next().value!);
      draw();
    } catch {
      /* lost: requested again when it is drawn next */
    }
    asked.delete(w);
  };
  const move = (line: number): void => {
    cursor = Math.min(Math.max(1, line), lines);
    go(map.top_showing(cursor, top));
    picked(cursor);
  };

  box.addEventListener("scroll", () => {
    if (Math.abs(map.scroll_of(top) - box.scrollTop) > 0.5) top = map.bounded(map.top_of(box.scrollTop));
    draw();
  });
  box.addEventListener(
    "wheel",
    (e) => {
      if (map.scaled) {
        e.preventDefault();
        go(top + e.deltaY * (e.deltaMode ? map.row : 1));
      }
    },
    { passive: false },
  );
  box.addEventListener("click", (e) => {
    const row = (e.target as Element).closest<HTMLElement>(".virtual-row");
    if (row) move(Number(row.dataset.line));
  });
  box.addEventListener("keydown", (e) => {
    const page = Math.max(1, Math.floor(map.view / map.row) - 1);
    const to = {
      ArrowDown: cursor + 1,
      ArrowUp: cursor - 1,
      PageDown: cursor + page,
      PageUp: cursor - page,
      Home: 1,
      End: lines,
    }[e.key];
    if (to !== undefined) {
      e.preventDefault();
      e.stopPropagation();
      move(to);
    }
  });
  box.addEventListener("mouseover", (e) => {
    const row = (e.target as Element).closest<HTMLElement>(".virtual-row");
    if (row && hover) explain(row);
  });
  const explain = debounce(350, async (row: HTMLElement) => {
    const line = row.dataset.line,
      said = await hover!(Number(line), row.children[1]!.textContent ?? "").catch(() => "");
    for (const r of rows.children) r.removeAttribute("title");
    if (row.dataset.line === line && said) row.title = said;
  });
  const watch = new ResizeObserver(measure);
  watch.observe(box);
  measure();
  return {
    show_line(line) {
      running = line;
      go(map.top_showing(line, top));
    },
    go_to: move,
    focus: () => box.focus(),
    close: () => {
      watch.disconnect();
      box.remove();
    },
  };
}

function coloured(text: string): Node[] {
  const out: Node[] = [];
  const shown = text.length > 2000 ? `${text.slice(0, 2000)}…` : text;
  for (let i = 0, plain = ""; i <= shown.length;) {
    const { kind, length } = i < shown.length ? token_at(shown, i) : { kind: "" as const, length: 1 };
    if ((kind || i === shown.length) && plain) {
      out.push(document.createTextNode(plain));
      plain = "";
    }
    if (kind) out.push(h("span", { class: `tok-${kind}` }, shown.slice(i, i + length)));
    else plain += shown[i] ?? "";
    i += length;
  }
  return out;
}
