// The worker in which the engine runs: Kadr itself as WebAssembly (src/web/engine.cpp), with the files of the page in its
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
  _kadr_close(session: number): void;
}
declare const kadr_engine: (of: object) => Promise<Engine>;

const changing =
  /"do":\s*"(save|rename|copy|delete|restore|empty_trash|take_example|new_program|keep_setup|keep_tools|open)"/;
const waits = 20; // ms: a message that came so long ago may have been stopped meanwhile

let engine: Engine,
  folder = "",
  stops = false,
  working = { session: 0, flag: "" };
const sessions = new Map<number, number>(), // the page's number of a session → the engine's
  known = new Map<string, string>(); // path of a file → its state that the page received last

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

function put(files: FileBytes[]): void {
  for (const [path, bytes] of files) {
    const whole = `${folder}/${path}`;
    engine.FS.mkdirTree(whole.slice(0, whole.lastIndexOf("/")));
    engine.FS.writeFile(whole, new Uint8Array(bytes));
  }
}

/// Tells the page which files are new, other or gone, so that it keeps them.
function tell_files(): void {
  const { FS } = engine,
    changed: FileBytes[] = [],
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
      changed.push([file, FS.readFile(folder + path).slice().buffer as ArrayBuffer]);
    }
  };
  visit("");
  const gone = [...known.keys()].filter((file) => !there.has(file));
  for (const file of gone) known.delete(file);
  if (changed.length || gone.length)
    tell(
      { is: "files", changed, gone },
      changed.map(([, bytes]) => bytes),
    );
}

async function begin(of: Extract<ToWorker, { do: "begin" }>): Promise<void> {
  stops = !is_withdrawn(of.flag);
  engine = await kadr_engine({
    instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) {
      WebAssembly.instantiate(of.module, imports).then(done, (e) => tell({ is: "failed", text: String(e) }));
      return {};
    },
    kadr_out(session: number, data: string | ArrayBuffer) {
      const { session: asks } = working;
      if (sessions.get(asks) !== session) return;
      tell({ is: "out", session: asks, data }, typeof data === "string" ? [] : [data]);
    },
    kadr_stops: () => stops && is_withdrawn(working.flag),
  });
  folder = `/${of.folder}`;
  engine.FS.mkdirTree(folder);
  put(of.files);
  tell_files();
  const begun = with_text(folder, (at) =>
    with_text(of.viewer, (html) => with_text(of.licences, (licences) => engine._kadr_begin(at, html, licences))),
  );
  if (!begun) return tell({ is: "failed", text: folder });
  tell({ is: "ready", stops });
}

function take(of: Extract<ToWorker, { do: "take" }>): void {
  const { session, text, flag, at } = of,
    of_engine = sessions.get(session);
  if (of_engine === undefined) return;
  working = { session, flag };
  let end: "" | "closed" | "memory" | "broken" = "",
    why = "";
  try {
    const stopped = stops && Date.now() - at > waits && is_withdrawn(flag);
    const how = with_text(text, (place, size) => engine._kadr_take(of_engine, place, size, stopped ? 1 : 0));
    end = how === 0 ? "" : how === 1 ? "closed" : "memory";
  } catch (e) {
    why = String(e);
    end = /memory|out of bounds/i.test(why) ? "memory" : "broken";
  }
  if (end) sessions.delete(session);
  if (end === "" && changing.test(text.slice(0, 300))) tell_files();
  tell({ is: "taken", session, end, text: why });
}

self.onmessage = (e: MessageEvent<ToWorker>): void => {
  const message = e.data;
  switch (message.do) {
    case "begin":
      begin(message).catch((failure) => tell({ is: "failed", text: String(failure) }));
      break;
    case "open":
      sessions.set(message.session, engine._kadr_open());
      break;
    case "take":
      take(message);
      break;
    case "put":
      put(message.files);
      tell_files();
      tell({ is: "put", id: message.id });
      break;
    case "close": {
      const of_engine = sessions.get(message.session);
      sessions.delete(message.session);
      if (of_engine !== undefined) engine._kadr_close(of_engine);
    }
  }
};
