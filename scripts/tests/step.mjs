// A step of `npm test`: a name, a body that returns counts, a log file, and one line about how it went.
import { spawnSync } from "node:child_process";
import { closeSync, mkdirSync, openSync, readFileSync, rmSync } from "node:fs";
import { Failure, inRoot, root } from "../lib/shell.mjs";

const logs = inRoot("build", "logs");
const shownLines = 120;
const limitMs = 55 * 60 * 1000;

export const noCounts = { passed: 0, failed: 0, skipped: 0 };
export const add = (a, b) => ({ passed: a.passed + b.passed, failed: a.failed + b.failed, skipped: a.skipped + b.skipped });

/** What a step runs its programs with: their output goes to the step's log. */
class Log {
  constructor(name) {
    mkdirSync(logs, { recursive: true });
    this.path = inRoot("build", "logs", `${name.replace(/\W+/g, "_")}.log`);
    rmSync(this.path, { force: true });
  }

  /** Runs a program to its end; returns whether it ended with 0. */
  run(command, args, options = {}) {
    const file = openSync(this.path, "a");
    try {
      const result = spawnSync(command, args, { cwd: root, timeout: limitMs, stdio: ["ignore", file, file], ...options });
      return result.status === 0;
    } finally {
      closeSync(file);
    }
  }

  must(command, args, options) {
    if (!this.run(command, args, options)) throw new Failure(`${[command, ...args].join(" ")} failed`);
  }

  text() {
    return readFileSync(this.path, { encoding: "utf8", flag: "a+" });
  }
}

function describeCounts({ passed, failed, skipped }) {
  return `${passed} passed, ${failed} failed${skipped > 0 ? `, ${skipped} skipped` : ""}`;
}

/**
 * Runs a step, says how it went, returns its counts. A step that counts nothing has failed. Lines of its log that match
 * `notes` are shown in any case.
 */
export async function runStep({ name, body, notes = /(?!)/ }) {
  const log = new Log(name);
  const start = Date.now();
  console.log(`... ${name}`);
  let counts;
  try {
    counts = await body(log);
    if (counts.passed + counts.failed + counts.skipped === 0) throw new Failure("no test was found");
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    console.log(error.message);
    counts = { ...noCounts, failed: 1 };
  }
  const lines = log.text().split("\n");
  if (counts.failed > 0) console.log(lines.slice(-shownLines).join("\n"));
  for (const line of lines.filter((text) => notes.test(text))) console.log(`    ${line}`);
  const seconds = ((Date.now() - start) / 1000).toFixed(1);
  console.log(`${counts.failed > 0 ? "FAILED" : "ok"}  ${name}: ${describeCounts(counts)} (${seconds} s)`);
  return counts;
}

export const closingLine = describeCounts;
