#include "wasm/app/fonts.h"

#include <cfloat>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

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

void merge_other_letters(const ImFontLoader* loader, unsigned weight) {
  if (loader == nullptr) return;
  ImFontConfig config;
  config.MergeMode = true;
  config.SizePixels = Fonts::kTextSize;
  config.FontLoader = loader;
  config.FontLoaderFlags = weight;
  std::snprintf(config.Name, sizeof config.Name, "other letters");
  ImGui::GetIO().Fonts->AddFont(&config);
}

ImFont* add_face(const std::vector<std::byte>& file, const char* name) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  config.OversampleH = 2;
  std::snprintf(config.Name, sizeof config.Name, "%s", name);
  if (file.empty()) throw std::runtime_error(std::string("There is no file with the face for ") + name + ".");
  return atlas.AddFontFromMemoryTTF(copied_for_imgui(file), static_cast<int>(file.size()), Fonts::kTextSize, &config);
}

/// U+FFFD stands for bytes that are no letter; a letter that the face lacks shall look different.
void show_missing_letters_as_boxes(ImFont& face) {
  constexpr ImWchar kBox = 0x25a1;
  if (face.IsGlyphInFont(kBox)) face.FallbackChar = kBox;
}

}  // namespace

Fonts add_fonts(const FontFiles& files) {
  Fonts fonts;
  fonts.text = add_face(files.text, "text");
  merge_icons(files.icons);
  merge_other_letters(files.other_letters, 400);
  fonts.semibold = add_face(files.semibold, "semibold");
  merge_icons(files.icons);
  merge_other_letters(files.other_letters, 600);
  fonts.mono = add_face(files.mono, "mono");
  merge_other_letters(files.other_letters, 400);
  for (ImFont* face : {fonts.text, fonts.semibold, fonts.mono}) show_missing_letters_as_boxes(*face);
  ImGui::GetStyle().FontSizeBase = Fonts::kTextSize;
  return fonts;
}

}  // namespace marey::app
