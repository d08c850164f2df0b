// What the page and the worker of the engine say to each other.

/// A file beneath the folder of the page: its path with `/`, and its bytes.
export type FileBytes = [path: string, bytes: ArrayBuffer];

export type ToWorker =
  | {
      do: "begin";
      module: WebAssembly.Module;
      folder: string;
      files: FileBytes[];
      flag: string;
      viewer: string; // of reports
      licences: string; // of its parts
    }
  | { do: "take"; text: string; flag: string; at: number } // `at`: when it was sent, Date.now()
  | { do: "put"; files: FileBytes[]; gone: string[] }; // files that another session or the user has changed

/// `taken`: a message has been answered completely. `end`: the session goes on, has ended by itself, lacked memory, or
/// the engine is broken and has to be replaced.
export type FromWorker =
  | { is: "ready"; stops: boolean } // whether it can receive a stop while it works
  | { is: "failed"; text: string }
  | { is: "out"; data: string | ArrayBuffer }
  | { is: "taken"; end: "" | "closed" | "memory" | "broken"; text: string }
  | { is: "files"; changed: FileBytes[]; gone: string[] };
