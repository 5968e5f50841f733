// The compilers, libraries and browsers that come from the system's own packages.
import { Failure, capture, hasProgram, run, say } from "../lib/shell.mjs";

// An emsdk that EMSDK names stands in for the system's Emscripten.
const emscripten = process.env.EMSDK ? [] : ["emscripten"];

const debianPackages = {
  native: ["cmake", "ninja-build", "g++", "libglm-dev", "libfast-float-dev", "libfmt-dev", "libcli11-dev",
    "nlohmann-json3-dev", "googletest"],
  page: [...emscripten, "xz-utils"],
  bench: ["libbenchmark-dev"],
  fuzz: ["clang", "libclang-rt-dev"],
  test: ["chromium", "universal-ctags"],
  mechanics: ["libmujoco-dev"],
  engines: ["firefox-esr", "xvfb", "xauth", "libgl1-mesa-dri", "webkit2gtk-driver"],
};

// What stands for each group where there is no apt: programs to look for, and the packages to name.
const elsewhere = {
  native: {
    programs: ["cmake", "ninja", "c++"],
    fedora: "cmake ninja-build gcc-c++ glm-devel fast_float-devel fmt-devel cli11-devel json-devel gtest-devel gmock-devel",
    brew: "cmake ninja glm fast_float fmt cli11 nlohmann-json googletest",
  },
  page: { programs: [...emscripten.map(() => "em++"), "xz"], fedora: "emscripten xz", brew: "emscripten xz" },
  bench: { programs: [], fedora: "google-benchmark-devel", brew: "google-benchmark" },
  fuzz: { programs: ["clang++"], fedora: "clang compiler-rt", brew: "llvm" },
  test: { programs: ["ctags"], fedora: "chromium ctags", brew: "universal-ctags" },
  mechanics: { programs: [], fedora: "", brew: "" },
  engines: { programs: ["xvfb-run"], fedora: "firefox xorg-x11-server-Xvfb webkitgtk6.0", brew: "" },
};

function isInstalled(name) {
  return capture("dpkg-query", ["-W", "-f", "${Status}", name]).stdout.endsWith(" installed");
}

function aptGet(args) {
  const command = ["apt-get", "-y", "-q", "-o", "Dpkg::Use-Pty=0", "-o", "DPkg::Lock::Timeout=600", ...args];
  const environment = ["env", "DEBIAN_FRONTEND=noninteractive"];
  const [program, ...rest] = process.getuid() === 0 ? [...environment, ...command] : ["sudo", ...environment, ...command];
  run(program, rest);
}

function installWithApt(missing) {
  const install = ["install", "--no-install-recommends", ...missing];
  if (process.getuid() !== 0 && !hasProgram("sudo")) {
    throw new Failure(`packages are missing and there is no sudo; as root: apt-get ${install.join(" ")}`);
  }
  const known = missing.every((name) => capture("apt-cache", ["show", name]).ok);
  say(`installing Debian packages: ${missing.join(" ")}`);
  try {
    if (known) return aptGet(install);
  } catch {
    say("that failed; trying once more with fresh package lists");
  }
  aptGet(["update"]);
  aptGet(install);
}

function checkWithoutApt(groups) {
  const missing = groups.flatMap((group) => elsewhere[group].programs).filter((program) => !hasProgram(program));
  if (missing.length === 0) return;
  const packages = (system) => groups.map((group) => elsewhere[group][system]).join(" ").trim();
  const advice = process.platform === "darwin" ? `brew install ${packages("brew")}` : `dnf install ${packages("fedora")}`;
  throw new Failure(`there is no apt here and ${missing.join(", ")} cannot be found; install what is missing: ${advice}`);
}

/** Makes sure that the packages of these groups are there. */
export function needSystemPackages(groups) {
  if (!hasProgram("apt-get")) return checkWithoutApt(groups);
  const missing = groups.flatMap((group) => debianPackages[group]).filter((name) => !isInstalled(name));
  if (missing.length > 0) installWithApt(missing);
}

/** Tries to get the packages of these groups; returns whether they are there now. */
export function tryForSystemPackages(groups) {
  try {
    needSystemPackages(groups);
    return true;
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    say(error.message);
    return false;
  }
}
