#include "wasm/app/fonts.h"

#include <cfloat>
#include <cstdio>
#include <cstring>

namespace marey::app {
namespace {

// ImGui frees what it owns with its own allocator; the copy lets the caller release the page's buffers.
void* copied_for_imgui(const std::vector<std::byte>& file) {
  void* copy = ImGui::MemAlloc(file.size());
  std::memcpy(copy, file.data(), file.size());
  return copy;
}

void merge_icons(const std::vector<std::byte>& file) {
  if (file.empty()) return;
  ImFontConfig config;
  config.MergeMode = true;
  // The icons are drawn on a square that stands on the baseline: moved down so that it fills the line's height.
  config.GlyphOffset = ImVec2(0.0f, 3.0f);
  config.GlyphMinAdvanceX = Fonts::kTextSize;
  std::snprintf(config.Name, sizeof config.Name, "icons");
  ImGui::GetIO().Fonts->AddFontFromMemoryTTF(copied_for_imgui(file), static_cast<int>(file.size()), Fonts::kTextSize,
                                             &config);
}

ImFont* add_face(const std::vector<std::byte>& file, const char* name) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  config.OversampleH = 2;
  std::snprintf(config.Name, sizeof config.Name, "%s", name);
  if (file.empty()) {
    config.SizePixels = Fonts::kTextSize;
    return atlas.AddFontDefault(&config);
  }
  return atlas.AddFontFromMemoryTTF(copied_for_imgui(file), static_cast<int>(file.size()), Fonts::kTextSize, &config);
}

}  // namespace

Fonts add_fonts(const FontFiles& files) {
  Fonts fonts;
  fonts.text = add_face(files.text, "text");
  merge_icons(files.icons);
  fonts.semibold = add_face(files.semibold, "semibold");
  merge_icons(files.icons);
  fonts.mono = add_face(files.mono, "mono");
  ImGui::GetStyle().FontSizeBase = Fonts::kTextSize;
  return fonts;
}

}  // namespace marey::app
