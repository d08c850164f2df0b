// The comments of a line of a program: in brackets, or behind a semicolon.

/// Returns the texts of all comments of a line, joined; empty if it has none.
export function comments_of(line: string): string {
  const found: string[] = [];
  let rest = line;
  for (;;) {
    const bracket = rest.indexOf("("),
      semicolon = rest.indexOf(";");
    if (semicolon >= 0 && (bracket < 0 || semicolon < bracket)) {
      found.push(rest.slice(semicolon + 1));
      break;
    }
    if (bracket < 0) break;
    const end = rest.indexOf(")", bracket);
    found.push(rest.slice(bracket + 1, end < 0 ? undefined : end));
    if (end < 0) break;
    rest = rest.slice(end + 1);
  }
  return found
    .map((x) => x.trim())
    .filter(Boolean)
    .join(" ");
}
