// Every command that README.md shows exists.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const root = new URL("../../", import.meta.url);
const npmOwn = ["ci", "install"];

const codeOf = (markdown) => [...markdown.matchAll(/```[\s\S]*?```|`[^`\n]+`/g)].map(([code]) => code).join("\n");

function findNpmScripts() {
  return Object.keys(JSON.parse(readFileSync(new URL("package.json", root), "utf8")).scripts);
}

function findSubcommands() {
  const program = process.env.MAREY_CLI ?? fileURLToPath(new URL("build/native/marey", root));
  const help = execFileSync(program, ["--help"], { encoding: "utf8" });
  const list = help.split(/^subcommands:\s*$/im)[1] ?? "";
  return [...list.matchAll(/^ {2}([a-z][\w-]*)/gm)].map(([, word]) => word);
}

export const name = "README commands";
export const unit = "commands";

export function check(files) {
  const code = codeOf(files.filter(({ path }) => path === "README.md").map(({ text }) => text).join("\n"));
  const scripts = findNpmScripts();
  const subcommands = findSubcommands();
  const npmWords = [...code.matchAll(/\bnpm (?:run )?([a-z][\w:-]*)/g)].map(([, word]) => word);
  const mareyWords = [...code.matchAll(/\bmarey ([a-z][\w-]*)/g)].map(([, word]) => word);
  const problems = [
    ...npmWords.filter((word) => !scripts.includes(word) && !npmOwn.includes(word)).map((word) => `npm has no script "${word}"`),
    ...mareyWords.filter((word) => !subcommands.includes(word)).map((word) => `marey has no command "${word}"`),
  ];
  return { checked: npmWords.length + mareyWords.length, problems };
}

export const seeds = [
  { path: "README.md", text: "Run `npm run fly`.\n" },
  { path: "README.md", text: "```sh\nbuild/native/marey juggle walk.bvh\n```\n" },
];
