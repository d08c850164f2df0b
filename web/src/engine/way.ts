// How a page without a server reaches a session: by the engine in a worker. It stands for protocol/way.ts.
import type { Socket } from "../protocol/client";
import type { Alone } from "../protocol/way_alone";
import { language, t } from "../texts/texts";
import { Engine } from "./engine";
import { given_files, listen_given } from "./given";
import { listen_installed, on_launch } from "./installed";
import { load_parts } from "./parts";
import { Store } from "./store";
import { tell_failure } from "./failure";

const parts = load_parts(),
  given = await given_files(),
  store = await Store.open(given !== null && !given.kept),
  kept = await store.all().catch(() => []);
const engine = new Engine(
  () => parts,
  language() === "ru" ? "Файлы" : "Files",
  kept,
  store,
  { memory: () => t("alone_memory"), broken: () => t("alone_broken"), stopped: () => t("alone_stopped") },
  tell_failure,
);
if (given) engine.put(given.files.filter(([path]) => !engine.bytes_of(path))); // a copy that was changed stays
listen_installed();
listen_given();

export const alone: Alone = {
  put: (files) => engine.put(files.map(({ path, bytes }) => [path, bytes])),
  bytes_of: (path) => engine.bytes_of(path),
  on_launch,
  told: () => t(store.keeps ? "alone_kept" : "alone_not_kept"),
  open: given?.open ?? null,
};
export const socket = (): Socket => engine.socket();
