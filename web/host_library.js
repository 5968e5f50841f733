// Linked into app.js by Emscripten: what the program asks of the page (wasm/platform/web/host.h), handed on to
// `Module.host`, a Host of web/src/host.ts. Text comes as address and size in bytes.
mergeInto(LibraryManager.library, {
  $mareyText: function (address, size) {
    return new TextDecoder().decode(HEAPU8.subarray(address, address + size));
  },

  // What JavaScript throws passes through the program as an exception of its own, which the panel that asked can catch.
  $mareyAsk: function (ask) {
    try {
      return ask(Module["host"]);
    } catch (error) {
      const words = new TextEncoder().encode(String(error));
      const address = _malloc(words.length + 1);
      if (address !== 0) HEAPU8.set(words, address);
      _marey_throw(address, words.length);
    }
  },

  marey_host_ask_for_file__deps: ["$mareyAsk"],
  marey_host_ask_for_file: function (use) {
    mareyAsk((host) => host.askForFile(use));
  },

  marey_host_download__deps: ["$mareyAsk", "$mareyText"],
  marey_host_download: function (name, nameSize, bytes, byteCount) {
    mareyAsk((host) => host.download(mareyText(name, nameSize), HEAPU8.slice(bytes, bytes + byteCount)));
  },

  marey_host_download_picture__deps: ["$mareyAsk", "$mareyText"],
  marey_host_download_picture: function (name, nameSize, svg, svgSize, pixelWidth) {
    mareyAsk((host) => host.downloadPicture(mareyText(name, nameSize), mareyText(svg, svgSize), pixelWidth));
  },

  marey_host_load_sample__deps: ["$mareyAsk", "$mareyText"],
  marey_host_load_sample: function (id, idSize) {
    mareyAsk((host) => host.loadSample(mareyText(id, idSize)));
  },

  marey_host_stop_loading__deps: ["$mareyAsk"],
  marey_host_stop_loading: function () {
    mareyAsk((host) => host.stopLoading());
  },

  marey_host_set_clipboard_text__deps: ["$mareyAsk", "$mareyText"],
  marey_host_set_clipboard_text: function (text, textSize) {
    mareyAsk((host) => host.setClipboardText(mareyText(text, textSize)));
  },

  marey_host_set_document_state__deps: ["$mareyAsk", "$mareyText"],
  marey_host_set_document_state: function (name, nameSize, dirty) {
    mareyAsk((host) => host.setDocumentState(mareyText(name, nameSize), dirty !== 0));
  },

  marey_host_announce__deps: ["$mareyAsk", "$mareyText"],
  marey_host_announce: function (text, textSize) {
    mareyAsk((host) => host.announce(mareyText(text, textSize)));
  },

  marey_host_report_fault__deps: ["$mareyAsk", "$mareyText"],
  marey_host_report_fault: function (text, textSize) {
    mareyAsk((host) => host.reportFault(mareyText(text, textSize)));
  },

  marey_host_draw_after__deps: ["$mareyAsk"],
  marey_host_draw_after: function (milliseconds) {
    mareyAsk((host) => host.drawAfter(milliseconds));
  },

  marey_host_store_preferences__deps: ["$mareyAsk", "$mareyText"],
  marey_host_store_preferences: function (json, jsonSize) {
    mareyAsk((host) => host.storePreferences(mareyText(json, jsonSize)));
  },

  marey_host_load_preferences__deps: ["$mareyAsk"],
  marey_host_load_preferences: function (buffer, capacity) {
    const bytes = new TextEncoder().encode(mareyAsk((host) => host.loadPreferences()));
    if (bytes.length <= capacity) HEAPU8.set(bytes, buffer);
    return bytes.length;
  },

  marey_host_system_preferences__deps: ["$mareyAsk"],
  marey_host_system_preferences: function () {
    const { dark, reducedMotion, appleKeys, coarsePointer } = mareyAsk((host) => host.systemPreferences());
    return (dark ? 1 : 0) | (reducedMotion ? 2 : 0) | (appleKeys ? 4 : 0) | (coarsePointer ? 8 : 0);
  },

  marey_host_set_mouse_cursor__deps: ["$mareyAsk", "$mareyText"],
  marey_host_set_mouse_cursor: function (cssCursor, cssCursorSize) {
    mareyAsk((host) => host.setMouseCursor(mareyText(cssCursor, cssCursorSize)));
  },

  marey_host_open_link__deps: ["$mareyAsk", "$mareyText"],
  marey_host_open_link: function (url, urlSize) {
    mareyAsk((host) => host.openLink(mareyText(url, urlSize)));
  },

  marey_host_measure_letter__deps: ["$mareyAsk"],
  marey_host_measure_letter: function (codePoint, em, weight) {
    return mareyAsk((host) => host.measureLetter(codePoint, em, weight));
  },

  marey_host_draw_letter__deps: ["$mareyAsk"],
  marey_host_draw_letter: function (codePoint, em, weight, side, penX, penY, coverage) {
    HEAPU8.set(mareyAsk((host) => host.drawLetter(codePoint, em, weight, { side, penX, penY })), coverage);
  },

  marey_host_decode_letters__deps: ["$mareyAsk"],
  marey_host_decode_letters: function (set, codes, byteCount, letters) {
    const found = mareyAsk((host) => host.decodeLetters(set === 0 ? "gbk" : "shift_jis", HEAPU8.slice(codes, codes + byteCount)));
    HEAPU8.set(new Uint8Array(found.buffer), letters);
  },

  marey_host_set_text_input__deps: ["$mareyAsk"],
  marey_host_set_text_input: function (wanted, cssX, cssY, cssHeight) {
    mareyAsk((host) => host.setTextInput(wanted !== 0, cssX, cssY, cssHeight));
  },
});
