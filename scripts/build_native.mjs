// npm run build:native: the command line program, build/native/marey.
import { buildPreset, configurePreset } from "./build/cmake.mjs";
import { main, say } from "./lib/shell.mjs";
import { setUpNative } from "./setup/index.mjs";

await main(async () => {
  setUpNative();
  configurePreset("native");
  buildPreset("native", ["marey"]);
  say("the program is build/native/marey");
});
