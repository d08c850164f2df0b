// A mock server for measurements: the built page by HTTP and a session over a real WebSocket, so that binary frames
// arrive as fast as from `kadr serve`.
import { createHash } from "node:crypto";
import { fileURLToPath } from "node:url";
import { serve_page } from "../test/mock-server.mjs";

const magic = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"; // RFC 6455, 1.3

/// `answer_with(send, drained)` returns the function that receives each message; `drained()` waits until everything
/// sent has left.
export async function serve_session(answer_with) {
  const server = await serve_page(fileURLToPath(new URL("../dist", import.meta.url)));
  server.http.on("upgrade", (request, socket) => {
    const key = createHash("sha1")
      .update(request.headers["sec-websocket-key"] + magic)
      .digest("base64");
    socket.write(
      `HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${key}\r\n\r\n`,
    );
    socket.on("error", () => {});
    const drained = () =>
      new Promise((yes) => {
        if (socket.writableNeedDrain) socket.once("drain", yes);
        else yes();
      });
    const answer = answer_with((m) => {
      socket.write(head_of(m));
      socket.write(typeof m === "string" ? m : new Uint8Array(m));
    }, drained);
    let held = Buffer.alloc(0);
    socket.on("data", (d) => {
      held = Buffer.concat([held, d]);
      for (let message; (message = take(held)); held = message.rest) if (message.text !== null) answer(message.text);
    });
  });
  return server;
}

function head_of(message) {
  const length = typeof message === "string" ? Buffer.byteLength(message) : message.byteLength,
    kind = typeof message === "string" ? 0x81 : 0x82;
  if (length < 126) return Buffer.from([kind, length]);
  const head = Buffer.alloc(length < 65536 ? 4 : 10);
  head[0] = kind;
  head[1] = length < 65536 ? 126 : 127;
  if (length < 65536) head.writeUInt16BE(length, 2);
  else head.writeBigUInt64BE(BigInt(length), 2);
  return head;
}

/// Returns the first message of these bytes, unmasked; null while it is incomplete. A message that is not text has
/// text null.
function take(bytes) {
  if (bytes.length < 6) return null;
  let length = bytes[1] & 127,
    at = 2;
  if (length === 126) {
    if (bytes.length < 8) return null;
    length = bytes.readUInt16BE(2);
    at = 4;
  } else if (length === 127) {
    if (bytes.length < 14) return null;
    length = Number(bytes.readBigUInt64BE(2));
    at = 10;
  }
  if (bytes.length < at + 4 + length) return null;
  const mask = bytes.subarray(at, at + 4),
    body = Buffer.from(bytes.subarray(at + 4, at + 4 + length));
  for (let i = 0; i < length; i++) body[i] ^= mask[i & 3];
  return { text: (bytes[0] & 15) === 1 ? body.toString() : null, rest: bytes.subarray(at + 4 + length) };
}
