// Runs the program `kadr`.
import { spawn } from "node:child_process";

export interface Ran {
  status: number | null; // null: it was ended
  out: string;
  told: string; // the messages, from standard error
}

/// Thrown if the program cannot be started, for example because it is not installed.
export class NoKadr extends Error {}

/// Runs the program to its end; `stop` ends it earlier.
export function run_kadr(path: string, words: string[], folder: string, stop?: AbortSignal): Promise<Ran> {
  return new Promise((resolve, reject) => {
    const process = spawn(path, words, { cwd: folder, stdio: ["ignore", "pipe", "pipe"], signal: stop });
    const ran: Ran = { status: null, out: "", told: "" };
    process.stdout.setEncoding("utf8").on("data", (text: string) => (ran.out += text));
    process.stderr.setEncoding("utf8").on("data", (text: string) => (ran.told += text));
    process.on("error", (e: NodeJS.ErrnoException) => {
      if (e.name === "AbortError") resolve(ran);
      else reject(new NoKadr(`${path}: ${e.message}`));
    });
    process.on("close", (status) => resolve({ ...ran, status }));
  });
}
