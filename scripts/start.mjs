// npm start: sets up, builds, and serves the page on http://localhost:8080 or the port that PORT names.
import { buildSite } from "./build/site.mjs";
import { Failure, inRoot, main, say } from "./lib/shell.mjs";
import { serveFolder } from "./lib/static_server.mjs";
import { setUpPage } from "./setup/index.mjs";

await main(async () => {
  await setUpPage();
  await buildSite();
  const port = Number(process.env.PORT || 8080);
  const { url } = await serveFolder(inRoot("dist"), port).catch((error) => {
    throw new Failure(`port ${port} cannot be used (${error.code}); choose another with PORT=... npm start`);
  });
  say(`the page is at ${url} (Ctrl+C ends this)`);
});
