// SPDX-License-Identifier: BSD-3-Clause
// A static server of one folder for the tests: serve(FOLDER) gives its address.
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const types = {
  ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".svg": "image/svg+xml",
  ".webmanifest": "application/manifest+json",
};

export async function serve(folder) {
  const server = createServer(async (request, reply) => {
    const path = normalize(new URL(request.url, "http://localhost").pathname);
    try {
      const bytes = await readFile(join(folder, path === "/" ? "index.html" : path));
      reply.writeHead(200, { "Content-Type": types[extname(path)] ?? (path === "/" ? "text/html" : "text/plain") });
      reply.end(bytes);
    } catch {
      reply.writeHead(404);
      reply.end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}
