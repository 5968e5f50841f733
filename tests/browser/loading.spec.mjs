// A long file is read piece by piece: progress, its first frames while it comes, and an end at any time.
import { createServer } from "node:http";
import { armClip } from "./support/clips.mjs";
import { expect, test } from "./support/fixtures.mjs";

const frames = 30_000;

/** The file comes from a server of its own, which the address names. */
const fromItsServer = /slow\.bvh/;

/** Sends a clip in its own time: `half` is sent at once, the rest when release() is called. */
async function serveSlowly(text) {
  let release;
  let left = false;
  const released = new Promise((done) => (release = done));
  const half = Math.floor(text.length / 2);
  const server = createServer(async (request, response) => {
    response.on("close", () => (left ||= !response.writableFinished));
    response.writeHead(200, { "Access-Control-Allow-Origin": "*", "Content-Length": text.length });
    for (let at = 0; at < text.length; at += 20_000) {
      if (at >= half) await released;
      else await new Promise((done) => setTimeout(done, 10));
      response.write(text.slice(at, at + 20_000));
    }
    response.end();
  });
  await new Promise((done) => server.listen(0, "localhost", done));
  const close = () => {
    release();
    server.closeAllConnections();
    return new Promise((done) => server.close(done));
  };
  return { url: `http://localhost:${server.address().port}/slow.bvh`, release, close, wasLeft: () => left };
}

/** Opens the page with a file whose second half is still to come, and waits for the first half. */
async function openHalf(marey, server) {
  await marey.page.goto(`${marey.site}/?src=${encodeURIComponent(server.url)}`);
  const hasHalf = () => marey.page.evaluate(() => {
    try {
      return window.marey.state().frames > 1000;
    } catch {
      return false; // the page has not started yet
    }
  });
  await expect.poll(hasHalf, { timeout: 30_000 }).toBe(true);
}

test("its first frames can be played while it comes, and stay where they are when it is there", async ({ marey, expectedProblems }) => {
  expectedProblems.push(fromItsServer);
  const text = armClip(frames);
  const server = await serveSlowly(text);
  await openHalf(marey, server);
  const half = await marey.state();
  expect(half.loading).toMatchObject({ file: "slow.bvh", size: text.length });
  expect(half.frames).toBeLessThan(frames);
  await marey.picture("loading");
  await marey.click("play.toggle");
  await marey.expectState(({ playing, frame }) => playing && frame > 0, true);
  server.release();
  await marey.expectState(({ frames: count, loading, playing }) => [count, loading, playing], [frames, null, true]);
  expect(await marey.save()).toBe(text);
  await server.close();
});

test("it can be stopped: what was open is back, and nothing more is fetched", async ({ marey, expectedProblems }) => {
  expectedProblems.push(fromItsServer);
  const server = await serveSlowly(armClip(frames));
  await openHalf(marey, server);
  await marey.click("file.cancel_loading.strip");
  await marey.expectState(({ file, loading }) => [file, loading], [null, null]);
  await marey.open("arm.bvh", armClip(5));
  await marey.expectState(({ file, frames: count }) => [file, count], ["arm.bvh", 5]);
  await expect.poll(() => server.wasLeft()).toBe(true);
  await server.close();
});

test("another file takes the place of one that is still coming", async ({ marey, expectedProblems }) => {
  expectedProblems.push(fromItsServer);
  const server = await serveSlowly(armClip(frames));
  await openHalf(marey, server);
  await marey.open("arm.bvh", armClip(5));
  await marey.expectState(({ file, frames: count, loading }) => [file, count, loading], ["arm.bvh", 5, null]);
  server.release();
  await marey.expectState(({ file, frames: count }) => [file, count], ["arm.bvh", 5]);
  await server.close();
});

test("one that breaks off leaves what was open, and the page says so", async ({ marey, page, expectedProblems }) => {
  expectedProblems.push(fromItsServer);
  expectedProblems.push(/ERR_CONTENT_LENGTH_MISMATCH|ERR_INCOMPLETE_CHUNKED/);
  const server = await serveSlowly(armClip(frames));
  await openHalf(marey, server);
  await server.close();
  await expect(page.getByRole("alert")).toContainText("slow.bvh could not be read to its end");
  await marey.expectState(({ file, loading }) => [file, loading], [null, null]);
});
