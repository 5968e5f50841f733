// npm run build: the static site in dist/, the page as one file dist/marey.html, the JavaScript module in dist/module/.
import { buildSite } from "./build/site.mjs";
import { main, say } from "./lib/shell.mjs";
import { setUpPage } from "./setup/index.mjs";

await main(async () => {
  await setUpPage();
  await buildSite();
  say("the site is in dist/, the page as one file is dist/marey.html, the module is in dist/module/");
});
