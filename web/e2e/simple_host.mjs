// A host as simple as there is: files of a folder under a path, without special headers, and without the type of
// WebAssembly. Used by alone.mjs.
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { join, normalize } from "node:path";

const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml" };

export function simple_host(folder, path) {
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url, "http://x");
    if (!pathname.startsWith(path)) return response.writeHead(404).end();
    const name = normalize(pathname.slice(path.length) || "index.html");
    try {
      const body = readFileSync(join(folder, name));
      response.writeHead(200, {
        "Content-Type": types[name.slice(name.lastIndexOf("."))] ?? "application/octet-stream",
      });
      response.end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  const close = () =>
    new Promise((yes) => {
      server.closeAllConnections();
      server.close(yes);
    });
  return new Promise((yes) =>
    server.listen(0, "127.0.0.1", () => yes({ address: `http://127.0.0.1:${server.address().port}${path}`, close })),
  );
}
