// Serves the page from its cache, so that it works without network after the first visit, and adds
// the headers that allow threads where a host cannot send them. The Makefile writes BUILD and FILES.
"use strict";

const CACHE = "dioptre-BUILD";
/** All of the page: also what only commands and dropped models need. */
const PAGE = ["./", FILES];

const withHeaders = (response) => {
  const headers = new Headers(response.headers);
  headers.set("Cross-Origin-Opener-Policy", "same-origin");
  headers.set("Cross-Origin-Embedder-Policy", "require-corp");
  headers.set("Cross-Origin-Resource-Policy", "same-origin");
  return new Response(response.body, { status: response.status, headers });
};

self.addEventListener("install", () => self.skipWaiting());

self.addEventListener("activate", (event) => event.waitUntil((async () => {
  for (const name of await caches.keys()) {
    if (name.startsWith("dioptre-") && name !== CACHE) {
      await caches.delete(name);
    }
  }
  await self.clients.claim();
})()));

/** @return A file from the cache, or from the host, which the cache then has. */
const take = async (request) => {
  const cache = await caches.open(CACHE);
  const kept = await cache.match(request, { ignoreSearch: true });
  if (kept) {
    return kept;
  }
  const response = await fetch(request);
  if (response.ok) {
    await cache.put(request, response.clone());
  }
  return response;
};

self.addEventListener("fetch", (event) => {
  const request = event.request;
  if (request.method === "GET" && request.url.startsWith(self.location.origin)) {
    event.respondWith(take(request).then(withHeaders));
  }
});

// The page asks for it once it is complete: it has fetched files before this worker was there, and others may never have been asked for.
self.addEventListener("message", (event) => event.waitUntil((async () => {
  for (const name of PAGE) {
    await take(name);
  }
  event.source.postMessage("kept");
})()));
