// The mock session to look at the page without the server: answers by the protocol about a program that it creates
// itself; one function per question. `send` accepts text or an ArrayBuffer.
import { folder_answers } from "./mock-folder.mjs";
import { path_frame, program } from "./mock-program.mjs";
import { run, run_answers } from "./mock-run.mjs";
import { setup_answers } from "./mock-setup.mjs";
import { long_lines, text_answers } from "./mock-text.mjs";

export function session(send) {
  const s = {
    lang: "en",
    open: null,
    path: null,
    text: program,
    stopped: false,
    send,
    event: (name, body) => send(JSON.stringify({ event: name, ...body })),
  };
  const answers = {
    ...folder_answers(s),
    ...run_answers(s),
    ...setup_answers(s),
    ...text_answers(s),
    hello: (q) => {
      s.lang = q.lang;
      return {
        version: "0.9",
        folder: "examples",
        may_change: true,
        last: null,
        controls: [
          { id: "mach3", name: "Mach3" },
          { id: "fanuc", name: "Fanuc 0i" },
          { id: "linuxcnc", name: "LinuxCNC" },
          { id: "grbl", name: "Grbl 1.1" },
        ],
        machines: ["mill3"],
      };
    },
    language: (q) => {
      s.lang = q.lang;
      return {};
    },
    open: (q) => {
      s.open = q.file;
      s.text = q.text ?? program;
      s.path = path_frame();
      setTimeout(() => void run(s), 10);
      const long = s.open === "long.nc";
      return {
        file: q.file,
        size: s.text.length,
        digest: "d1",
        encoding: "utf-8",
        control: { id: q.control ?? "mach3", name: "Mach3", guessed: !q.control, why: "%" },
        machine: q.machine ?? null,
        setup: q.setup ?? null,
        editable: !long,
        lines: long ? long_lines : s.text.split("\n").length,
        ...(long ? {} : { text: s.text }),
      };
    },
    stop: () => {
      s.stopped = true;
      return {};
    },
  };
  return (message) => {
    const q = JSON.parse(message);
    try {
      send(JSON.stringify({ re: q.id, ...answers[q.do](q) }));
    } catch (e) {
      send(JSON.stringify({ re: q.id, error: { text: e.text ?? e.message, changed: e.changed } }));
    }
  };
}
