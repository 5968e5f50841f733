// npm run test:numbers [CASES]: compares 10^8 numbers, or as many as said, with other readers and writers.
import { main } from "./lib/shell.mjs";
import { setUpNative } from "./setup/index.mjs";
import { runNumberTests } from "./tests/runners.mjs";
import { runStep } from "./tests/step.mjs";

await main(async () => {
  setUpNative();
  const cases = process.argv[2] ?? 100_000_000;
  const body = (log) => runNumberTests(log, cases);
  const { failed } = await runStep({ name: "numbers read and written exactly", body, notes: /compared with/ });
  if (failed > 0) process.exitCode = 1;
});
