import { test as base, expect } from "@playwright/test";
import { inRoot } from "../../../scripts/lib/shell.mjs";
import { serveFolder } from "../../../scripts/lib/static_server.mjs";
import { MareyPage } from "./marey_page.mjs";

export { expect };

/** Collects what no test of the page may cause: console errors, uncaught errors, requests to another host. */
function watch(page, ownHosts) {
  const problems = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) || message.text().includes("imgui-error")) problems.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => problems.push(`uncaught: ${error.message}`));
  page.on("request", (request) => {
    const url = new URL(request.url());
    const isOwn = ["data:", "blob:"].includes(url.protocol) || ownHosts.includes(url.host);
    // The page as one file asks for itself.
    const isPageFile = url.protocol === "file:" && request.isNavigationRequest();
    if (!isOwn && !isPageFile) problems.push(`request: ${request.url()}`);
  });
  return problems;
}

function rememberVisit() {
  if (!localStorage.getItem("marey.preferences")) localStorage.setItem("marey.preferences", '{"welcomeSeen":true}');
}

/** The built site; MAREY_SITE names another folder. */
export const siteFolder = process.env.MAREY_SITE ?? inRoot("dist");

export const test = base.extend({
  /** Address of the built site. */
  site: [async ({}, use) => {
    const server = await serveFolder(siteFolder);
    await use(server.url);
    await server.close();
  }, { scope: "worker" }],

  /** Problems that a test expects: it adds patterns, and what matches none fails the test. */
  expectedProblems: async ({}, use) => use([]),

  /** Whether the page is opened for the first time ever, which shows the welcome. */
  firstVisit: [false, { option: true }],

  marey: async ({ page, site, expectedProblems, firstVisit }, use) => {
    if (!firstVisit) await page.addInitScript(rememberVisit);
    const problems = watch(page, [new URL(site).host]);
    await use(new MareyPage(page, site));
    const unexpected = problems.filter((problem) => !expectedProblems.some((pattern) => pattern.test(problem)));
    expect(unexpected).toEqual([]);
  },
});
