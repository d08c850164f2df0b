// Values that outlive a reload: choices of the user in localStorage, what this tab had open in sessionStorage. Both
// may be forbidden; then nothing is remembered.
let tab_is_kept = true;
/// Used by a page that is a file: the files that a tab opens one after another are unrelated.
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

/// Returns false if the store is full or forbidden.
export function remember(name: string, value: unknown, store: "local" | "tab" = "local"): boolean {
  if (store === "tab" && !tab_is_kept) return false;
  try {
    storage(store).setItem(`kadr.${name}`, JSON.stringify(value));
    return true;
  } catch {
    return false;
  }
}

/// Removes a value from the local store.
export function forget(name: string): void {
  try {
    localStorage.removeItem(`kadr.${name}`);
  } catch {
    /* forbidden */
  }
}

/// Returns the names in the local store with this beginning.
export function names_kept(begins: string): string[] {
  try {
    return Object.keys(localStorage)
      .filter((name) => name.startsWith(`kadr.${begins}`))
      .map((name) => name.slice("kadr.".length));
  } catch {
    return [];
  }
}

const storage = (store: "local" | "tab"): Storage => (store === "local" ? localStorage : sessionStorage);
