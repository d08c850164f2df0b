// How a page without a server reaches a session: by the engine in a worker. It stands for protocol/way.ts.
import type { Socket } from "../protocol/client";
import type { Alone } from "../protocol/way_alone";
import { language, t } from "../texts/texts";
import { Engine } from "./engine";
import { listen_installed, on_launch } from "./installed";
import { load_parts } from "./parts";
import { Store } from "./store";
import { tell_failure } from "./failure";

const parts = load_parts(),
  store = await Store.open();
const engine = new Engine(
  () => parts,
  language() === "ru" ? "Файлы" : "Files",
  await store.all().catch(() => []),
  store,
  { memory: () => t("alone_memory"), broken: () => t("alone_broken"), stopped: () => t("alone_stopped") },
  tell_failure,
);
listen_installed();

export const alone: Alone = {
  put: (files) => engine.put(files.map(({ path, bytes }) => [path, bytes])),
  bytes_of: (path) => engine.bytes_of(path),
  on_launch,
  told: () => t(store.keeps ? "alone_kept" : "alone_not_kept"),
};
export const socket = (): Socket => engine.socket();
