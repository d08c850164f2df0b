// Decides which file a problem belongs to.
import type { Problem } from "../protocol/types";

/// Problems of called files belong to another text, which the editor does not show. `opened` is the program's own
/// name.
export function of_program(p: Problem, opened: string): boolean {
  if (typeof p.file !== "string") return !p.file;
  const name = (path: string): string => path.slice(path.lastIndexOf("/") + 1);
  return p.file === "" || name(p.file) === name(opened);
}
