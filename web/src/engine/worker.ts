// The worker in which a session runs: Kadr itself as WebAssembly (src/web/engine.cpp), with the files of the page in its
// memory. It gets the messages that a server would get by WebSocket, and answers them in their order.
import type { FileBytes, FromWorker, ToWorker } from "./messages";

interface Node {
  mode: number;
  timestamp: number;
  usedBytes?: number;
}
interface Engine {
  FS: {
    mkdirTree(path: string): void;
    writeFile(path: string, bytes: Uint8Array): void;
    readFile(path: string): Uint8Array;
    unlink(path: string): void;
    readdir(path: string): string[];
    isDir(mode: number): boolean;
    lookupPath(path: string): { node: Node };
  };
  lengthBytesUTF8(text: string): number;
  stringToUTF8(text: string, at: number, size: number): void;
  _malloc(size: number): number;
  _free(at: number): void;
  _kadr_begin(folder: number, html: number, licences: number): number;
  _kadr_open(): number;
  _kadr_take(session: number, text: number, size: number, stopped: number): number;
}
declare const kadr_engine: (of: object) => Promise<Engine>;

const changing =
  /"do":\s*"(save|rename|copy|delete|restore|empty_trash|take_example|new_program|keep_setup|keep_tools|open)"/;
const waits = 20; // ms: a message that came so long ago may have been stopped meanwhile

let engine: Engine,
  folder = "",
  stops = false,
  session = 0,
  working = { flag: "", changes: false }; // the message that is answered
const known = new Map<string, string>(); // path of a file → its state that the page knows

const tell = (message: FromWorker, hand_over: Transferable[] = []): void =>
  (self as unknown as Worker).postMessage(message, hand_over);

/// The page can say nothing to a worker that works. So it withdraws a blob: address, which then cannot be read.
function is_withdrawn(flag: string): boolean {
  try {
    const request = new XMLHttpRequest();
    request.open("GET", flag, false);
    request.send();
    return false;
  } catch {
    return true;
  }
}

/// Gives the engine a text. The engine must not keep it.
function with_text<T>(text: string, use: (at: number, size: number) => T): T {
  const size = engine.lengthBytesUTF8(text),
    at = engine._malloc(size + 1);
  if (!at) throw new RangeError("memory");
  try {
    engine.stringToUTF8(text, at, size + 1);
    return use(at, size);
  } finally {
    engine._free(at);
  }
}

/// Writes files that the page has sent, and deletes those that are gone.
function put(files: FileBytes[], gone: string[]): void {
  for (const [path, bytes] of files) {
    const whole = `${folder}/${path}`;
    engine.FS.mkdirTree(whole.slice(0, whole.lastIndexOf("/")));
    engine.FS.writeFile(whole, new Uint8Array(bytes));
  }
  for (const path of gone) if (known.has(path)) engine.FS.unlink(`${folder}/${path}`);
  changes();
}

/// Returns the paths of the files that are new, other or gone since the last call.
function changes(): { changed: string[]; gone: string[] } {
  const { FS } = engine,
    changed: string[] = [],
    there = new Set<string>();
  const visit = (at: string): void => {
    for (const name of FS.readdir(`${folder}${at}`)) {
      if (name === "." || name === "..") continue;
      const path = `${at}/${name}`,
        { node } = FS.lookupPath(folder + path);
      if (FS.isDir(node.mode)) {
        visit(path);
        continue;
      }
      const state = `${node.timestamp}-${node.usedBytes ?? 0}`,
        file = path.slice(1);
      there.add(file);
      if (known.get(file) === state) continue;
      known.set(file, state);
      changed.push(file);
    }
  };
  visit("");
  const gone = [...known.keys()].filter((file) => !there.has(file));
  for (const file of gone) known.delete(file);
  return { changed, gone };
}

/// Tells the page which files the session has changed, so that it keeps them and other sessions get them.
function tell_files(): void {
  const { changed, gone } = changes();
  if (!changed.length && !gone.length) return;
  const files = changed.map((file): FileBytes => {
    const bytes = engine.FS.readFile(`${folder}/${file}`).slice().buffer as ArrayBuffer;
    return [file, bytes];
  });
  tell(
    { is: "files", changed: files, gone },
    files.map(([, bytes]) => bytes),
  );
}

async function begin(of: Extract<ToWorker, { do: "begin" }>): Promise<void> {
  stops = !is_withdrawn(of.flag);
  engine = await kadr_engine({
    instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) {
      WebAssembly.instantiate(of.module, imports).then(done, (e) => tell({ is: "failed", text: String(e) }));
      return {};
    },
    kadr_out(_: number, data: string | ArrayBuffer) {
      if (working.changes && typeof data === "string") tell_files(); // before the answer, after which the page asks others
      tell({ is: "out", data }, typeof data === "string" ? [] : [data]);
    },
    kadr_stops: () => stops && is_withdrawn(working.flag),
  });
  folder = `/${of.folder}`;
  engine.FS.mkdirTree(folder);
  put(of.files, []);
  const begun = with_text(folder, (at) =>
    with_text(of.viewer, (html) => with_text(of.licences, (licences) => engine._kadr_begin(at, html, licences))),
  );
  if (!begun) return tell({ is: "failed", text: folder });
  session = engine._kadr_open();
  tell({ is: "ready", stops });
}

function take(of: Extract<ToWorker, { do: "take" }>): void {
  const { text, flag, at } = of;
  working = { flag, changes: changing.test(text.slice(0, 300)) };
  let end: "" | "closed" | "memory" | "broken" = "",
    why = "";
  try {
    const stopped = stops && Date.now() - at > waits && is_withdrawn(flag);
    const how = with_text(text, (place, size) => engine._kadr_take(session, place, size, stopped ? 1 : 0));
    end = how === 0 ? "" : how === 1 ? "closed" : "memory";
  } catch (e) {
    why = String(e);
    end = /memory|out of bounds/i.test(why) ? "memory" : "broken";
  }
  if (end === "" && working.changes) tell_files();
  tell({ is: "taken", end, text: why });
}

async function hear(message: ToWorker): Promise<void> {
  if (message.do === "begin") await begin(message);
  else if (message.do === "take") take(message);
  else put(message.files, message.gone);
}

let before: Promise<void> = Promise.resolve(); // what came first, such as the beginning, has been done
self.onmessage = (e: MessageEvent<ToWorker>): void => {
  before = before.then(() => hear(e.data)).catch((failure) => tell({ is: "failed", text: String(failure) }));
};
