// Creates elements. Text is added as text nodes only: the text of a program can never become markup.
type Child = Node | string | number | null | undefined | false;
type Attributes = Record<string, unknown>;

/// `class`, `aria-…`, any attribute; a function under `onclick` … becomes a listener; `false` and null omit the
/// attribute.
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes?: Attributes | null,
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const e = document.createElement(tag);
  set_attributes(e, attributes);
  add(e, children);
  return e;
}

export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes?: Attributes | null,
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const e = document.createElementNS("http://www.w3.org/2000/svg", tag);
  set_attributes(e, attributes);
  add(e, children);
  return e;
}

export function fill(e: Element, ...children: Child[]): void {
  e.replaceChildren();
  add(e, children);
}

function set_attributes(e: Element, attributes?: Attributes | null): void {
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (value === null || value === undefined || (value === false && !name.startsWith("aria-"))) continue; // aria-pressed="false" is kept
    if (typeof value === "function") e.addEventListener(name.slice(2), value as EventListener);
    else e.setAttribute(name, value === true && !name.startsWith("aria-") ? "" : String(value));
  }
}

function add(e: Element, children: Child[]): void {
  for (const c of children)
    if (c !== null && c !== undefined && c !== false) e.append(c instanceof Node ? c : String(c));
}

export function button(text: string | Node, action: () => void, attributes?: Attributes): HTMLButtonElement {
  return h("button", { type: "button", onclick: action, ...attributes }, text);
}

export function option(value: string, text: string, chosen: boolean): HTMLOptionElement {
  const o = h("option", { value }, text);
  o.selected = chosen;
  return o;
}

/// Draws again; text that is being typed in fields of `root` stays, and so does the cursor. Fields are identified by
/// their names.
export function redraw(root: HTMLElement, draw: () => void): void {
  const name = (i: Element): string => i.getAttribute("aria-label") ?? "",
    active = document.activeElement;
  const typed = new Map(
    [...root.querySelectorAll("input")]
      .filter((i) => i.type !== "range" && i.value !== i.defaultValue)
      .map((i) => [name(i), i.value]),
  );
  const focused = active && active !== root && root.contains(active) ? `${active.tagName} ${name(active)}` : null;
  draw();
  for (const i of root.querySelectorAll("input"))
    if (typed.has(name(i))) {
      i.value = typed.get(name(i))!;
      keep_change(i);
    }
  if (focused)
    [...root.querySelectorAll<HTMLElement>("input, select, button")]
      .find((e) => `${e.tagName} ${name(e)}` === focused)
      ?.focus();
}

/// The browser reports no change for text that was typed before the field was drawn again: this reports it, when the
/// field loses the focus or Enter is pressed.
function keep_change(input: HTMLInputElement): void {
  let told = false;
  const tell = (): void => {
    if (!told && input.value !== input.defaultValue) input.dispatchEvent(new Event("change"));
  };
  input.addEventListener("change", () => {
    told = true;
  });
  input.addEventListener("keydown", (e) => {
    if (e.key === "Enter") tell();
  });
  input.addEventListener("blur", tell);
}
