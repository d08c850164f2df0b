// How the page reaches a session: by a WebSocket to the server that has sent the page. A page without a server has
// engine/way.ts instead (vite.web.config.ts).
import type { Socket } from "./client";
import type { Alone } from "./way_alone";

export const alone = null as Alone | null;

export const socket = (): Socket =>
  new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/session`) as unknown as Socket;
