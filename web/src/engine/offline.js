// The service worker of the page without a server: keeps the parts of one build, all or none, and answers with them. It
// asks the network for nothing else. web/bundling/alone.ts puts name and parts in.
const name = KADR_NAME,
  parts = KADR_PARTS;

self.addEventListener("install", (e) => {
  const all = async () => {
    const store = await caches.open(name);
    await store.addAll(parts.map((part) => new Request(part, { cache: "reload" })));
    await self.skipWaiting();
  };
  e.waitUntil(all());
});

self.addEventListener("activate", (e) => {
  const others = async () => {
    for (const old of await caches.keys()) if (old.startsWith("kadr-") && old !== name) await caches.delete(old);
    await self.clients.claim();
  };
  e.waitUntil(others());
});

self.addEventListener("fetch", (e) => {
  const address = new URL(e.request.url),
    here = new URL("./", self.location.href);
  if (e.request.method !== "GET" || !address.href.startsWith(here.href)) return;
  const part = address.pathname.slice(here.pathname.length) || "index.html";
  const answer = async () => (await (await caches.open(name)).match(part)) ?? fetch(e.request);
  e.respondWith(answer());
});
