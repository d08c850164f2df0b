// What outlives a reload: choices of the user in localStorage, what this tab had open in sessionStorage. Both may be forbidden; then nothing is remembered.
export function remembered<T>(name: string, otherwise: T, store: "local" | "tab" = "local"): T {
  try {
    const s = storage(store).getItem(`kadr.${name}`);
    return s === null ? otherwise : (JSON.parse(s) as T);
  } catch { return otherwise; }
}

export function remember(name: string, value: unknown, store: "local" | "tab" = "local"): void {
  try { storage(store).setItem(`kadr.${name}`, JSON.stringify(value)); } catch { /* full or forbidden */ }
}

const storage = (store: "local" | "tab"): Storage => (store === "local" ? localStorage : sessionStorage);
