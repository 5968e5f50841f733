// Half a minute of random use from a fixed seed; `npm run monkey` does it for longer, with others.
import { playRound } from "../../scripts/monkey/round.mjs";
import { expect, test } from "./support/fixtures.mjs";

for (const seed of [20, 21]) {
  test.describe(`seed ${seed}`, () => {
    test.use({ hasTouch: seed % 2 === 0 });

    test("nothing that a hand at random does harms the page or the file", async ({ page, site, context }, testInfo) => {
      await context.grantPermissions(["clipboard-read", "clipboard-write"]);
      await page.goto(site);
      const { events, problems } = await playRound(page, { seed, milliseconds: 12_000, log: testInfo.outputPath("events.jsonl") });
      expect(problems).toEqual([]);
      expect(events).toBeGreaterThan(0);
    });
  });
}
