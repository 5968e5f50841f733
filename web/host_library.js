// Linked into app.js by Emscripten: what the program asks of the page (wasm/platform/web/host.h), handed on to
// `Module.host`, a Host of web/src/host.ts. Text comes as address and size in bytes.
mergeInto(LibraryManager.library, {
  $mareyText: function (address, size) {
    return new TextDecoder().decode(HEAPU8.subarray(address, address + size));
  },

  marey_host_ask_for_file: function () {
    Module["host"].askForFile();
  },

  marey_host_download__deps: ["$mareyText"],
  marey_host_download: function (name, nameSize, bytes, byteCount) {
    Module["host"].download(mareyText(name, nameSize), HEAPU8.slice(bytes, bytes + byteCount));
  },

  marey_host_load_sample__deps: ["$mareyText"],
  marey_host_load_sample: function (id, idSize) {
    Module["host"].loadSample(mareyText(id, idSize));
  },

  marey_host_stop_loading: function () {
    Module["host"].stopLoading();
  },

  marey_host_set_clipboard_text__deps: ["$mareyText"],
  marey_host_set_clipboard_text: function (text, textSize) {
    Module["host"].setClipboardText(mareyText(text, textSize));
  },

  marey_host_set_document_state__deps: ["$mareyText"],
  marey_host_set_document_state: function (name, nameSize, dirty) {
    Module["host"].setDocumentState(mareyText(name, nameSize), dirty !== 0);
  },

  marey_host_announce__deps: ["$mareyText"],
  marey_host_announce: function (text, textSize) {
    Module["host"].announce(mareyText(text, textSize));
  },

  marey_host_draw_after: function (milliseconds) {
    Module["host"].drawAfter(milliseconds);
  },

  marey_host_store_preferences__deps: ["$mareyText"],
  marey_host_store_preferences: function (json, jsonSize) {
    Module["host"].storePreferences(mareyText(json, jsonSize));
  },

  marey_host_load_preferences: function (buffer, capacity) {
    const bytes = new TextEncoder().encode(Module["host"].loadPreferences());
    if (bytes.length <= capacity) HEAPU8.set(bytes, buffer);
    return bytes.length;
  },

  marey_host_system_preferences: function () {
    const { dark, reducedMotion, appleKeys, coarsePointer } = Module["host"].systemPreferences();
    return (dark ? 1 : 0) | (reducedMotion ? 2 : 0) | (appleKeys ? 4 : 0) | (coarsePointer ? 8 : 0);
  },

  marey_host_set_mouse_cursor__deps: ["$mareyText"],
  marey_host_set_mouse_cursor: function (cssCursor, cssCursorSize) {
    Module["host"].setMouseCursor(mareyText(cssCursor, cssCursorSize));
  },

  marey_host_open_link__deps: ["$mareyText"],
  marey_host_open_link: function (url, urlSize) {
    Module["host"].openLink(mareyText(url, urlSize));
  },

  marey_host_measure_letter: function (codePoint, em, weight) {
    return Module["host"].measureLetter(codePoint, em, weight);
  },

  marey_host_draw_letter: function (codePoint, em, weight, side, penX, penY, coverage) {
    HEAPU8.set(Module["host"].drawLetter(codePoint, em, weight, { side, penX, penY }), coverage);
  },

  marey_host_set_text_input: function (wanted, cssX, cssY, cssHeight) {
    Module["host"].setTextInput(wanted !== 0, cssX, cssY, cssHeight);
  },
});
