// Dear ImGui's sources in build/deps/imgui: from Debian's source package, else from its upstream release. Whatever the
// route, every file has to have the SHA-256 that stands in imgui.sha256.
import { createHash } from "node:crypto";
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { Failure, capture, hasProgram, inRoot, say } from "../lib/shell.mjs";

const version = "1.92.2b";
const debianVersion = `${version}+ds-1`;
const debianSuite = "forky";
const upstream = `https://github.com/ocornut/imgui/archive/refs/tags/v${version}.tar.gz`;
const keyring = "/usr/share/keyrings/debian-archive-keyring.gpg";
const target = inRoot("build", "deps", "imgui");
const scratch = inRoot("build", "deps", "imgui.download");

function manifest() {
  const lines = readFileSync(new URL("imgui.sha256", import.meta.url), "utf8").trim().split("\n");
  return lines.map((line) => ({ sha256: line.slice(0, 64), path: line.slice(66) }));
}

/** The first file of the manifest that is not as it should be in `folder`, or undefined. */
function findWrongFile(folder) {
  const isRight = ({ sha256, path }) =>
    existsSync(join(folder, path)) && createHash("sha256").update(readFileSync(join(folder, path))).digest("hex") === sha256;
  return manifest().find((entry) => !isRight(entry))?.path;
}

function must(command, args, options) {
  const { ok, stderr } = capture(command, args, options);
  if (!ok) throw new Failure(`${command} said: ${stderr.trim().split("\n").at(-1)}`);
}

/** The Debian mirror that this machine installs from. */
function findMirror() {
  const format = "$(LABEL) $(REPO_URI)";
  const rows = capture("apt-get", ["indextargets", "--format", format, "Created-By: Packages"]).stdout.split("\n");
  const mirror = rows.find((row) => row.startsWith("Debian "))?.split(" ")[1];
  if (!mirror) throw new Failure("apt knows no Debian mirror");
  return mirror;
}

// A state directory of our own leaves the system's package lists as they are. apt checks the signatures as always; a
// mirror that lags behind will do, since the files that we want are known by their hashes.
function downloadFromDebian() {
  const sources = join(scratch, "sources");
  mkdirSync(join(scratch, "lists", "partial"), { recursive: true });
  mkdirSync(sources);
  writeFileSync(join(sources, "imgui.sources"),
    `Types: deb-src\nURIs: ${findMirror()}\nSuites: ${debianSuite}\nComponents: main\n` +
    (existsSync(keyring) ? `Signed-By: ${keyring}\n` : ""));
  const own = ["-q", "-o", "Acquire::Check-Valid-Until=false", "-o", "Dir::Etc::SourceList=/dev/null", "-o", `Dir::Etc::SourceParts=${sources}`,
    "-o", `Dir::State::Lists=${join(scratch, "lists")}`, "-o", `Dir::Cache=${join(scratch, "cache")}`];
  must("apt-get", [...own, "update"], { cwd: scratch });
  must("apt-get", [...own, "source", "--download-only", `imgui=${debianVersion}`], { cwd: scratch });
  return readdirSync(scratch).find((name) => name.endsWith(".orig.tar.xz"));
}

async function downloadFromUpstream() {
  const response = await fetch(upstream).catch((error) => { throw new Failure(`${upstream}: ${error.cause?.code ?? error.message}`); });
  if (!response.ok) throw new Failure(`${upstream}: status ${response.status}`);
  writeFileSync(join(scratch, "imgui.tar.gz"), Buffer.from(await response.arrayBuffer()));
  return "imgui.tar.gz";
}

async function tryRoute(download) {
  rmSync(scratch, { recursive: true, force: true });
  mkdirSync(join(scratch, "unpacked"), { recursive: true });
  const archive = await download();
  must("tar", ["-xf", archive, "-C", "unpacked", "--strip-components=1"], { cwd: scratch });
  const unpacked = join(scratch, "unpacked");
  const wrong = findWrongFile(unpacked);
  if (wrong) throw new Failure(`${wrong} is not that of Dear ImGui ${version}`);
  const kept = join(scratch, "kept");
  for (const { path } of manifest()) {
    mkdirSync(dirname(join(kept, path)), { recursive: true });
    copyFileSync(join(unpacked, path), join(kept, path));
  }
  rmSync(target, { recursive: true, force: true });
  renameSync(kept, target);
}

export async function needImgui() {
  if (!findWrongFile(target)) return;
  say(`fetching the sources of Dear ImGui ${version} into build/deps/imgui`);
  const routes = hasProgram("apt-get") ? [downloadFromDebian, downloadFromUpstream] : [downloadFromUpstream];
  const reasons = [];
  for (const route of routes) {
    try {
      await tryRoute(route);
      return rmSync(scratch, { recursive: true, force: true });
    } catch (error) {
      if (!(error instanceof Failure)) throw error;
      reasons.push(error.message);
    }
  }
  throw new Failure(`Dear ImGui ${version} cannot be had: ${reasons.join("; ")}`);
}
