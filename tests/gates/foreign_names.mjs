// No file names a package registry's host or a path of somebody's machine.
const hosts = [["registry", "npmjs", "org"], ["registry", "yarnpkg", "com"], ["deb", "debian", "org"], ["security", "debian", "org"],
  ["ftp", "debian", "org"], ["pypi", "org"], ["nodesource", "com"], ["proxy", "golang", "org"]].map((parts) => parts.join("."));
const machinePath = /(?<![\w.~-])\/(?:work|root|home|tmp|Users)\/[\w.]/;

export const name = "foreign names";
export const unit = "files";

export function check(files) {
  const problems = [];
  for (const { path, text } of files) {
    for (const [index, line] of text.split("\n").entries()) {
      const found = hosts.find((host) => line.includes(host)) ?? machinePath.exec(line)?.[0];
      if (found) problems.push(`${path}:${index + 1}: ${found}`);
    }
  }
  return { checked: files.length, problems };
}

export const seeds = [
  { path: "docs/seed.md", text: `see https://${hosts[0]}/marey\n` },
  { path: "scripts/seed.mjs", text: `const file = "${["", "home", "me", "walk.bvh"].join("/")}";\n` },
];
