// The comments of a line of a program: in brackets, or behind a semicolon. On a Sinumerik brackets are code, and a
// semicolon in quotation marks is text.

/// Returns true for a control whose comments stand behind a semicolon only.
export function only_semicolons(control: string | undefined): boolean {
  return control === "sinumerik";
}

function behind_semicolon(line: string): string {
  const quoted = /"[^"]*"?/g;
  const bare = line.replace(quoted, (text) => " ".repeat(text.length));
  const semicolon = bare.indexOf(";");
  return semicolon < 0 ? "" : line.slice(semicolon + 1).trim();
}

/// Returns the texts of all comments of a line, joined; empty if it has none.
export function comments_of(line: string, control?: string): string {
  if (only_semicolons(control)) return behind_semicolon(line);
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
