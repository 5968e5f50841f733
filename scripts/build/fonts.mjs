// The fonts of the page as TrueType files in dist/fonts, each cut down to the characters that the page can show.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { inRoot } from "../lib/shell.mjs";

const faces = {
  "inter-regular.ttf": "@expo-google-fonts/inter/400Regular/Inter_400Regular.ttf",
  "inter-semibold.ttf": "@expo-google-fonts/inter/600SemiBold/Inter_600SemiBold.ttf",
  "jetbrains-mono-regular.ttf": "@expo-google-fonts/jetbrains-mono/400Regular/JetBrainsMono_400Regular.ttf",
};
const iconFace = "lucide-static/font/lucide.ttf";

// Unicode blocks, first and last code point.
const textBlocks = [
  [0x0020, 0x024f], // Latin with its first two extensions
  [0x02b0, 0x036f], // modifier letters, combining marks
  [0x0370, 0x052f], // Greek, Cyrillic
  [0x1e00, 0x1eff], // Latin, additional
  [0x2000, 0x20bf], // punctuation, superscripts and subscripts, currencies
  [0x2100, 0x22ff], // letterlike, number forms, arrows, mathematics
  [0x2318, 0x2325], // keys
  [0x25a0, 0x25ff], // geometric shapes
  [0xfffd, 0xfffd], // what is no letter
];

function charactersOf(blocks) {
  return blocks.map(([first, last]) => Array.from({ length: last - first + 1 }, (_, i) => String.fromCodePoint(first + i)).join("")).join("");
}

/** The characters that wasm/app/icons.h names, as `\ue123`. */
function findUsedIcons() {
  const escapes = readFileSync(inRoot("wasm", "app", "icons.h"), "utf8").matchAll(/\\u([0-9a-f]{4})/gi);
  return String.fromCodePoint(...[...escapes].map((match) => parseInt(match[1], 16)));
}

export async function buildFonts(folder) {
  const { default: subsetFont } = await import("subset-font");
  const cut = async (name, path, characters) => {
    const font = await subsetFont(readFileSync(inRoot("node_modules", path)), characters, { targetFormat: "truetype" });
    writeFileSync(join(folder, name), font);
  };
  mkdirSync(folder, { recursive: true });
  for (const [name, path] of Object.entries(faces)) await cut(name, path, charactersOf(textBlocks));
  await cut("icons.ttf", iconFace, findUsedIcons());
}
