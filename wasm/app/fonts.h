#pragma once

#include <imgui.h>

#include <cstddef>
#include <vector>

namespace marey::app {

/// The faces of the page. Sizes are ImGui units and mean the height of a line from ascender to descender, as ImGui
/// takes them; the em of Inter is 0.83 of it (13, 11 and 15 px). ImGui rasterises at the device's resolution on demand.
struct Fonts {
  ImFont* text = nullptr;      ///< Inter, with the icon font merged in
  ImFont* semibold = nullptr;  ///< Inter semibold, panel titles
  ImFont* mono = nullptr;      ///< numbers
  static constexpr float kTextSize = 16.0f;
  static constexpr float kSmallSize = 13.0f;
  static constexpr float kTitleSize = 18.0f;
  static constexpr float kEmOfLine = 0.83f;
};

/// File contents (TrueType) handed over by the page. The first three must be there; without icons there are none.
struct FontFiles {
  std::vector<std::byte> text;
  std::vector<std::byte> semibold;
  std::vector<std::byte> mono;
  std::vector<std::byte> icons;
  /// Draws the letters that the faces lack; its FontLoaderFlags are the weight, 400 or 600. Without it they are boxes.
  const ImFontLoader* other_letters = nullptr;
};

/// Adds the faces to the current ImGui context. The files may be released afterwards. Throws std::runtime_error where a face is
/// missing.
[[nodiscard]] Fonts add_fonts(const FontFiles& files);

}  // namespace marey::app
