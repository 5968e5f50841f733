#pragma once

#include <imgui.h>

#include <string_view>

#include "wasm/app/theme.h"

namespace marey::app {

/// Draws a small moving picture of a sample into the rectangle: several positions on one plate, the present one strong.
/// `phase` 0..1 is the place in the cycle. Figures are sketched from a few angles, not from the sample's file.
void draw_sample_picture(ImDrawList& draw_list, const Theme& theme, std::string_view sample_id, ImVec2 min, ImVec2 max,
                         double phase);

}  // namespace marey::app
