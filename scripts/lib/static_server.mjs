// A small web server for one folder, for trying the page and for its tests. Nothing outside the folder is reachable.
import { createReadStream, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, resolve, sep } from "node:path";

const types = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".json": "application/json",
  ".webmanifest": "application/manifest+json",
  ".map": "application/json",
  ".wasm": "application/wasm",
  ".ttf": "font/ttf",
  ".woff2": "font/woff2",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".ico": "image/x-icon",
  ".bvh": "text/plain; charset=utf-8",
  ".txt": "text/plain; charset=utf-8",
  ".ts": "text/plain; charset=utf-8",
};

/** The file that a request's path names, or undefined. */
export function findFile(folder, requestPath) {
  let path;
  try {
    path = decodeURIComponent(requestPath.split(/[?#]/, 1)[0]);
  } catch {
    return undefined;
  }
  const file = resolve(join(folder, path.endsWith("/") ? `${path}index.html` : path));
  const inside = file.startsWith(resolve(folder) + sep) && !path.includes("\0");
  return inside && statSync(file, { throwIfNoEntry: false })?.isFile() ? file : undefined;
}

function answer(folder, request, response) {
  const file = request.method === "GET" || request.method === "HEAD" ? findFile(folder, request.url) : undefined;
  if (!file) {
    response.writeHead(404, { "Content-Type": "text/plain" }).end("There is no such file.\n");
    return;
  }
  response.writeHead(200, {
    "Content-Type": types[extname(file)] ?? "application/octet-stream",
    "Content-Length": statSync(file).size,
    "Cache-Control": "no-store",
  });
  if (request.method === "HEAD") response.end();
  else createReadStream(file).pipe(response);
}

/** Serves `folder` on this machine; port 0 takes a free one. Resolves to { url, close() }. */
export function serveFolder(folder, port = 0) {
  const server = createServer((request, response) => answer(folder, request, response));
  return new Promise((done, failed) => {
    server.once("error", failed);
    server.listen(port, "localhost", () => {
      done({ url: `http://localhost:${server.address().port}`, close: () => new Promise((closed) => server.close(closed)) });
    });
  });
}
