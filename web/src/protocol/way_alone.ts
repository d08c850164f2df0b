// What a page without a server has besides a session: the files are its own.
import type { OpenQuestion } from "./types";

export interface Alone {
  /// Puts files into the folder of the page; `path` beneath it, folders on the way are made.
  put(files: { path: string; bytes: ArrayBuffer }[]): void;
  /// The bytes of a file of the page; undefined if there is none.
  bytes_of(path: string): ArrayBuffer | undefined;
  /// Calls `take` with the files that the system opens with the installed page.
  on_launch(take: (files: File[]) => void): void;
  /// A sentence that says where the files are.
  told(): string;
  /// The program to open first, if files came with the page; else null.
  open: OpenQuestion | null;
}
