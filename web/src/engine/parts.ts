// The parts of the engine: its script and its WebAssembly, from the folder of the page, or out of the page itself if it is
// one file. When they are here, the page may connect to nothing any more.

export interface Parts {
  script: string;
  module: WebAssembly.Module;
  viewer: string; // of reports
  licences: string;
}

/// Unpacks base64 of gzip or zlib.
export function unpacked(text: string, form: "gzip" | "deflate"): Response {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream(form)));
}

/// Returns what the element of a page that is one file holds: base64 of gzip.
function inside(id: string): Response | null {
  const text = document.getElementById(id)?.textContent?.trim();
  return text ? unpacked(text, "gzip") : null;
}

async function fetched(name: string): Promise<Response> {
  const got = await fetch(name);
  if (!got.ok) throw new Error(`${name}: ${got.status}`);
  return got;
}

async function compiled(got: Response): Promise<WebAssembly.Module> {
  if (got.headers.get("Content-Type") === "application/wasm") return WebAssembly.compileStreaming(got);
  return WebAssembly.compile(await got.arrayBuffer()); // a simple host does not know the type
}

/// From now on the browser refuses every connection, of the page and of its workers, to any host. A policy can only be
/// made stricter.
export function close_the_door(): void {
  const policy = document.createElement("meta");
  policy.httpEquiv = "Content-Security-Policy";
  policy.content = "connect-src blob:"; // an address of this page itself, by which a worker learns that it is to stop
  document.head.append(policy);
}

/// A part of the page that is one file, or from its folder.
const part = (id: string, name: string): Promise<Response> => {
  const own = inside(id);
  return own ? Promise.resolve(own) : fetched(name);
};
const text_of = (got: Response): Promise<string> => got.text();

export async function load_parts(): Promise<Parts> {
  const [script, module, viewer, licences] = await Promise.all([
    part("kadr-engine-script", "engine.js").then(text_of),
    part("kadr-engine-wasm", "kadr_page.wasm").then(compiled),
    part("kadr-engine-report", "report.html").then(text_of),
    part("kadr-engine-licences", "licences.txt").then(text_of),
  ]);
  close_the_door();
  return { script, module, viewer, licences };
}
