// Serves the built page, as the program does, for development and page tests.
import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import { join, normalize } from "node:path";

const types = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".css": "text/css",
  ".svg": "image/svg+xml",
};
const policy =
  "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline'; " +
  "img-src 'self' blob:; connect-src 'self' ws:; frame-ancestors 'none'; base-uri 'none'";

/// Serves the built page with the server's headers.
export function serve_page(dist) {
  const server = createServer((request, response) => {
    const path = normalize(new URL(request.url, "http://x").pathname).replace(/^\/$/, "/index.html");
    try {
      const body = readFileSync(join(dist, path));
      response.writeHead(200, {
        "Content-Type": types[path.slice(path.lastIndexOf("."))] ?? "text/plain",
        "Content-Security-Policy": policy,
        "X-Content-Type-Options": "nosniff",
      });
      response.end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  return new Promise((yes) =>
    server.listen(0, "127.0.0.1", () =>
      yes({ address: `http://127.0.0.1:${server.address().port}/`, http: server, close: () => server.close() }),
    ),
  );
}
