// SPDX-License-Identifier: BSD-3-Clause
// Keeps the page for use without a network. The build puts `files` and `version` before this.
/* global files, version */
const name = `surfaceflattening-${version}`;

self.addEventListener("install", (event) => {
  event.waitUntil(caches.open(name).then((cache) => cache.addAll(["./", ...files])).then(() => self.skipWaiting()));
});

self.addEventListener("activate", (event) => {
  const isOld = (key) => key.startsWith("surfaceflattening-") && key !== name;
  event.waitUntil(caches.keys()
    .then((keys) => Promise.all(keys.filter(isOld).map((key) => caches.delete(key))))
    .then(() => self.clients.claim()));
});

self.addEventListener("fetch", (event) => {
  event.respondWith(caches.match(event.request, { ignoreSearch: true }).then((kept) => kept ?? fetch(event.request)));
});
