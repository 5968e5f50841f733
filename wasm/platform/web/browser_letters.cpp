#include "wasm/platform/web/browser_letters.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "wasm/app/fonts.h"
#include "wasm/platform/web/host.h"

namespace marey::app {
namespace {

/// Up to here the page's own faces have what can be had; what they lack there is no letter.
constexpr ImWchar kFirstLetter = 0x0530;

bool has_letter(ImFontAtlas* /*atlas*/, ImFontConfig* /*source*/, ImWchar letter) {
  const bool is_surrogate_or_private = letter >= 0xd800 && letter <= 0xf8ff;
  return letter >= kFirstLetter && !is_surrogate_or_private && letter < 0xfff0;
}

/// A square of coverage in device pixels with the letter's pen position at pen_x, pen_y, and where the ink is in it.
struct Cell {
  int side = 0;
  int pen_x = 0;
  int pen_y = 0;
  int left = 0, top = 0, right = 0, bottom = 0;
  std::vector<std::uint8_t> coverage;

  [[nodiscard]] std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * side + x); }
};

void find_ink(Cell& cell) {
  cell.left = cell.side;
  cell.top = cell.side;
  for (int y = 0; y < cell.side; ++y) {
    for (int x = 0; x < cell.side; ++x) {
      if (cell.coverage[cell.index(x, y)] == 0) continue;
      cell.left = std::min(cell.left, x);
      cell.right = std::max(cell.right, x + 1);
      cell.top = std::min(cell.top, y);
      cell.bottom = std::max(cell.bottom, y + 1);
    }
  }
}

/// Room for half an em on the left, a whole one and a half above the pen, and half below.
Cell draw_letter(ImWchar letter, double em, int weight) {
  Cell cell;
  cell.side = static_cast<int>(std::ceil(2.0 * em)) + 2;
  cell.pen_x = cell.side / 4;
  cell.pen_y = cell.side * 3 / 4;
  cell.coverage.assign(cell.index(0, cell.side), 0);
  marey_host_draw_letter(letter, em, weight, cell.side, cell.pen_x, cell.pen_y, cell.coverage.data());
  find_ink(cell);
  return cell;
}

bool put_into_atlas(ImFontAtlas& atlas, ImFontConfig& source, ImFontBaked& baked, const Cell& cell, float density,
                    ImFontGlyph& glyph) {
  const int width = cell.right - cell.left;
  const int height = cell.bottom - cell.top;
  const ImFontAtlasRectId id = ImFontAtlasPackAddRect(&atlas, width, height);
  if (id == ImFontAtlasRectId_Invalid) return false;
  glyph.X0 = static_cast<float>(cell.left - cell.pen_x) / density;
  glyph.Y0 = static_cast<float>(cell.top - cell.pen_y) / density + std::round(baked.Ascent);
  glyph.X1 = glyph.X0 + static_cast<float>(width) / density;
  glyph.Y1 = glyph.Y0 + static_cast<float>(height) / density;
  glyph.Visible = true;
  glyph.PackId = id;
  ImTextureRect* place = ImFontAtlasPackGetRect(&atlas, id);
  const std::uint8_t* ink = cell.coverage.data() + cell.index(cell.left, cell.top);
  ImFontAtlasBakedSetFontGlyphBitmap(&atlas, &baked, &source, &glyph, place, ink, ImTextureFormat_Alpha8, cell.side);
  return true;
}

/// ImGui asks either for the advance alone or for the whole glyph.
bool load_letter(ImFontAtlas* atlas, ImFontConfig* source, ImFontBaked* baked, void* /*data*/, ImWchar letter,
                 ImFontGlyph* glyph, float* advance) {
  if (!has_letter(atlas, source, letter)) return false;
  const float density = source->RasterizerDensity * baked->RasterizerDensity;
  const double em = static_cast<double>(baked->Size) * Fonts::kEmOfLine * density;
  const int weight = static_cast<int>(source->FontLoaderFlags);
  const auto width = static_cast<float>(marey_host_measure_letter(letter, em, weight)) / density;
  if (advance != nullptr) {
    *advance = width;
    return true;
  }
  glyph->Codepoint = letter;
  glyph->AdvanceX = width;
  const Cell cell = draw_letter(letter, em, weight);
  return cell.right == 0 || put_into_atlas(*atlas, *source, *baked, cell, density, *glyph);
}

ImFontLoader make_loader() {
  ImFontLoader loader;
  loader.Name = "browser";
  loader.FontSrcContainsGlyph = has_letter;
  loader.FontBakedLoadGlyph = load_letter;
  return loader;
}

}  // namespace

const ImFontLoader& browser_letters() {
  static const ImFontLoader loader = make_loader();
  return loader;
}

void forget_drawn_letters(ImFontAtlas& atlas) {
  for (ImFont* font : atlas.Fonts) ImFontAtlasFontDiscardBakes(&atlas, font, 0);
}

}  // namespace marey::app
