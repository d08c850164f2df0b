// Which parts of the path are shown: a small panel that opens from the tool bar of the view.
import type { App } from "../model/app";
import type { SceneFilter } from "../scene/scene";
import { t } from "../texts/texts";
import { button, h } from "./dom";
import { icon } from "./icons";

export function filter_form(app: App, now: SceneFilter, change: (f: Partial<SceneFilter>) => void): HTMLElement {
  const tick = (key: "rapids" | "hideDone" | "programmed" | "other" | "bounds" | "turned"): HTMLElement => {
    const box = h("input", { type: "checkbox", onchange: () => change({ [key]: box.checked }) });
    box.checked = now[key];
    return h("label", { class: "tick" }, box, t(`filter_${key}`));
  };
  return h(
    "details",
    { class: "filters" },
    h("summary", null, t("filters")),
    h(
      "div",
      { class: "filter-body" },
      tick("rapids"),
      tick("hideDone"),
      tick("programmed"),
      tick("other"),
      tick("bounds"),
      Boolean(app.done?.joints.length) && tick("turned"),
      range(t("filter_depth"), now.depth, (depth) => change({ depth })),
      range(t("filter_lines"), now.lines, (lines) => change({ lines })),
      tools(app, now, change),
    ),
  );
}

function range(name: string, now: [number, number] | null, change: (r: [number, number] | null) => void): HTMLElement {
  const field = (v: number | undefined, label: string): HTMLInputElement =>
    h("input", {
      type: "text",
      inputmode: "decimal",
      size: "6",
      value: v !== undefined && Number.isFinite(v) ? String(v) : "",
      placeholder: label,
      "aria-label": `${name} ${label}`,
      onchange: () => go(),
    });
  const from = field(now?.[0], t("from")),
    to = field(now?.[1], t("to"));
  const value = (e: HTMLInputElement, otherwise: number): number =>
    e.value.trim() === "" || Number.isNaN(Number(e.value.replace(",", ".")))
      ? otherwise
      : Number(e.value.replace(",", "."));
  const go = (): void => {
    const r: [number, number] = [value(from, -Infinity), value(to, Infinity)];
    change(r[0] === -Infinity && r[1] === Infinity ? null : r);
  };
  return h("div", { class: "row range" }, h("span", null, name), from, to);
}

function tools(app: App, now: SceneFilter, change: (f: Partial<SceneFilter>) => void): HTMLElement | null {
  const all = [...new Set(app.done?.tools.map((x) => x.tool) ?? [])];
  if (!all.length) return null;
  const boxes = all.map((n) => {
    const box = h("input", { type: "checkbox", onchange: () => go() });
    box.checked = !now.tools || now.tools.includes(n);
    return { n, box };
  });
  const go = (): void => {
    const on = boxes.filter((b) => b.box.checked).map((b) => b.n);
    change({ tools: on.length === all.length ? null : on });
  };
  return h(
    "div",
    { class: "filter-tools" },
    ...boxes.map(({ n, box }) =>
      h(
        "div",
        { class: "row" },
        h("label", { class: "tick" }, box, `T${n} ${app.done?.tools.find((x) => x.tool === n)?.name ?? ""}`),
        button(icon("go"), () => app.seek(app.done?.tools.find((x) => x.tool === n)?.from ?? 0), {
          class: "icon",
          title: t("go_to_start"),
          "aria-label": t("go_to_start"),
        }),
      ),
    ),
  );
}
