#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "wasm/app/file_use.h"

namespace marey::app {

/// What the person has set on their machine.
struct SystemPreferences {
  bool dark = true;            ///< prefers-color-scheme
  bool reduced_motion = false;  ///< prefers-reduced-motion
  bool apple_keys = false;     ///< Cmd stands where others have Ctrl
  bool coarse_pointer = false;  ///< pointer: coarse, a finger
};

/// Everything the program asks of the machine it runs on. One class, two implementations: platform/web (the browser)
/// and platform/headless (tests); CMake picks the file.
class Backend {
 public:
  /// Opens the browser's file picker; the chosen file arrives through App::begin_loading.
  void ask_for_file(FileUse use = FileUse::Document);
  /// Hands bytes to the user as a download.
  void download(std::string_view file_name, std::string_view bytes);
  /// Hands a drawing in SVG to the user as a PNG, so many pixels wide, when it has been painted.
  void download_picture(std::string_view file_name, std::string_view svg, int pixel_width);
  /// Opens a bundled sample by its id; it arrives through App::open_file.
  void load_sample(std::string_view sample_id);
  /// Nothing more of the file that is being read is wanted.
  void stop_loading();
  void set_clipboard_text(std::string_view text);
  /// Title of the tab and the warning before leaving with unsaved changes.
  void set_document_state(std::string_view file_name, bool dirty);
  /// Text for assistive technology (aria-live).
  void announce(std::string_view text);
  /// An error of the program itself, for whoever is to mend it.
  void report_fault(std::string_view text);
  /// Asks for a frame later, for what ends by itself while nothing else happens.
  void draw_after(double seconds);
  /// Keeps preferences (JSON text) between visits; silently none where the browser forbids it.
  void store_preferences(std::string_view json);
  [[nodiscard]] std::string load_preferences();
  /// As they are now; asked for in every frame.
  [[nodiscard]] SystemPreferences system_preferences();

  /// Time since some moment, for measuring.
  [[nodiscard]] double now_ms();
  /// Memory of the program in bytes: what lives in it, and what the machine has given. Walks the heap.
  struct Memory {
    std::size_t used = 0;
    std::size_t total = 0;
  };
  [[nodiscard]] Memory memory();
  /// CSS name of a mouse cursor: "default", "grab", "ew-resize" ...
  void set_mouse_cursor(std::string_view css_cursor);
  /// Opens an address of the page's own documentation or licence in a new tab.
  void open_link(std::string_view url);
};

}  // namespace marey::app
