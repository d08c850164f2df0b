// The token of the printed address: read once from `#token=…`, kept for this tab, and removed from the address so that
// nobody copies it by accident.
const key = "kadr.token";

export function token(): string | undefined {
  const found = /(?:^#|&)token=([0-9A-Za-z_-]+)/.exec(location.hash);
  if (found) {
    sessionStorage.setItem(key, found[1]!);
    history.replaceState(null, "", location.pathname + location.search);
  }
  return sessionStorage.getItem(key) ?? undefined;
}
