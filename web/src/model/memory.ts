// What outlives a reload: choices of the user in localStorage, what this tab had open in sessionStorage. Both may be
// forbidden; then nothing is remembered.
let tab_is_kept = true;
/// Of a page that is a file: what one tab opens one after another has nothing to do with each other.
export function keep_nothing_of_tab(): void {
  tab_is_kept = false;
}

export function remembered<T>(name: string, otherwise: T, store: "local" | "tab" = "local"): T {
  if (store === "tab" && !tab_is_kept) return otherwise;
  try {
    const s = storage(store).getItem(`kadr.${name}`);
    return s === null ? otherwise : (JSON.parse(s) as T);
  } catch {
    return otherwise;
  }
}

export function remember(name: string, value: unknown, store: "local" | "tab" = "local"): void {
  if (store === "tab" && !tab_is_kept) return;
  try {
    storage(store).setItem(`kadr.${name}`, JSON.stringify(value));
  } catch {
    /* full or forbidden */
  }
}

const storage = (store: "local" | "tab"): Storage => (store === "local" ? localStorage : sessionStorage);
