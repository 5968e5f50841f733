// core/ knows no browser, GL, ImGui, file, clock, thread or stdout, and does not end the program.
const forbidden = [
  /#\s*include\s*[<"](emscripten|GL|GLES\d|EGL|imgui|SDL\d?|GLFW)\b[^>"]*[>"]/,
  /#\s*include\s*<(thread|mutex|shared_mutex|condition_variable|future|semaphore|stop_token)>/,
  /#\s*include\s*<(fstream|iostream|filesystem|cstdio|stdio\.h|unistd\.h|chrono|ctime|time\.h|print)>/,
  /#\s*include\s*[<"]fmt\/(os|printf|chrono)\.h[>"]/,
  /\b__EMSCRIPTEN__\b|\b__wasm\w*__\b|\b_WIN32\b|\b__APPLE__\b|\b__linux__\b/,
  /\b(emscripten_|EM_JS|EM_ASM|ImGui::)/,
  /\bv?[fs]?n?printf\s*\(|\bfmt::print\b|\bputs\s*\(|\bstd::(cout|cerr|clog)\b/,
  /\b(abort|terminate|_?exit|quick_exit)\s*\(/,
  /\b(throw|catch)\b/,
];

const withoutComments = (text) => text.replace(/\/\*[\s\S]*?\*\/|\/\/.*$/gm, (comment) => comment.replace(/[^\n]/g, ""));

export const name = "no platform in core";
export const unit = "lines";

export function check(files) {
  const problems = [];
  let checked = 0;
  for (const { path, text } of files.filter((file) => /^core\/.*\.(h|cpp)$/.test(file.path))) {
    for (const [index, line] of withoutComments(text).split("\n").entries()) {
      checked += 1;
      const found = forbidden.map((pattern) => pattern.exec(line)?.[0]).find(Boolean);
      if (found) problems.push(`${path}:${index + 1}: ${found.trim()}`);
    }
  }
  return { checked, problems };
}

const seedLines = ["#include <emscripten.h>", "#include <GLES3/gl3.h>", '#include "imgui.h"', "#include <thread>", "#include <fstream>",
  "#include <iostream>", "#include <chrono>", "#ifdef __EMSCRIPTEN__", 'printf("x");', 'std::fprintf(stderr, "x");', "std::abort();", "throw 1;", "} catch (...) {"];
export const seeds = seedLines.map((line) => ({ path: "core/base/seed.cpp", text: `${line}\n` }));
