// The service worker: keeps the files of the page, so that it works without a network. What is kept belongs together:
// a page sees the files of one build, and those of the next one from the visit on after they have all come.

/** The build, and its files; `plugin.ts` writes them here. */
const { version, files } = "__KEPT__";

/** Other folders of the same host may have pages of their own. */
const mine = `delone ${self.registration.scope} `;
const kept = `${mine}${version}`;
/** Pages of the guide, once they have been read. */
const read = `${mine}guide`;

self.addEventListener("install", (event) => event.waitUntil(keep()));
self.addEventListener("activate", (event) => event.waitUntil(tidy()));
self.addEventListener("fetch", (event) => {
  const { request } = event;
  const isOurs = request.method === "GET" && request.url.startsWith(self.registration.scope);
  if (isOurs) event.respondWith(answer(request));
});

async function keep() {
  const cache = await caches.open(kept);
  // Names with a hash never change their content; the others are asked for anew.
  const asked = files.map((file) =>
    file.startsWith("assets/") ? file : new Request(file, { cache: "reload" }),
  );
  await cache.addAll(asked);
}

async function tidy() {
  for (const name of await caches.keys()) {
    if (name.startsWith(mine) && name !== kept && name !== read) await caches.delete(name);
  }
}

async function answer(request) {
  const path = new URL(request.url).pathname.slice(new URL(self.registration.scope).pathname.length);
  // The page has one address; hosts may send from the other one to it, which a worker must not repeat.
  const name = path === "" || path === "index.html" ? "./" : path;
  if (files.includes(name)) {
    const found = await (await caches.open(kept)).match(name, { ignoreVary: true });
    if (found) return found;
  }
  return path.startsWith("guide/") ? fresh(request) : fetch(request);
}

/** Answers with what the network has; without one, with what has been read before. */
async function fresh(request) {
  const cache = await caches.open(read);
  try {
    const response = await fetch(request);
    if (response.ok && !response.redirected) await cache.put(request, response.clone());
    return response;
  } catch (error) {
    const found = await cache.match(request, { ignoreVary: true });
    if (found) return found;
    throw error;
  }
}
