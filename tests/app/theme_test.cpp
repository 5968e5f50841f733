#include "wasm/app/theme.h"

#include <gtest/gtest.h>

#include <cmath>

namespace marey::app {
namespace {

double channel(ImU32 color, int shift) { return static_cast<double>((color >> shift) & 255U) / 255.0; }

double linear(double value) { return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4); }

// Relative luminance and contrast as in WCAG 2.1.
double luminance(ImU32 color) {
  return 0.2126 * linear(channel(color, IM_COL32_R_SHIFT)) + 0.7152 * linear(channel(color, IM_COL32_G_SHIFT)) +
         0.0722 * linear(channel(color, IM_COL32_B_SHIFT));
}

double contrast(ImU32 a, ImU32 b) {
  const double high = std::max(luminance(a), luminance(b));
  const double low = std::min(luminance(a), luminance(b));
  return (high + 0.05) / (low + 0.05);
}

// Lightness that a deuteranope sees, after Viénot, Brettel and Mollon 1999: luminance is almost kept, hue is lost.
double deuteranope_luminance(ImU32 color) {
  const double r = linear(channel(color, IM_COL32_R_SHIFT));
  const double g = linear(channel(color, IM_COL32_G_SHIFT));
  const double b = linear(channel(color, IM_COL32_B_SHIFT));
  const double red_green = 0.29275 * r + 0.70725 * g;
  const double blue = -0.02234 * r + 0.02234 * g + b;
  return 0.9278 * red_green + 0.0722 * blue;
}

class ThemeContrast : public testing::TestWithParam<ThemeKind> {
 protected:
  Theme theme_ = make_theme(GetParam());
};

TEST_P(ThemeContrast, TextIsLegibleOnEveryGround) {
  for (const ImU32 ground : {theme_.app, theme_.panel, theme_.raised}) {
    EXPECT_GE(contrast(theme_.text, ground), 7.0);
    EXPECT_GE(contrast(theme_.dim_text, ground), 4.5);
    EXPECT_GE(contrast(theme_.error, ground), 4.5);
  }
  EXPECT_GE(contrast(theme_.text, theme_.hovered), 7.0);
  EXPECT_GE(contrast(theme_.text, theme_.pressed), 7.0);
  EXPECT_GE(contrast(theme_.on_accent, theme_.accent), 4.5);
}

TEST_P(ThemeContrast, LinesThatCarryMeaningStandOut) {
  for (const ImU32 color : {theme_.accent, theme_.selection, theme_.cursor, theme_.ok, theme_.warning, theme_.axis[0],
                            theme_.axis[1], theme_.axis[2], theme_.left, theme_.right, theme_.middle}) {
    EXPECT_GE(contrast(color, theme_.panel), 3.0);
  }
}

TEST_P(ThemeContrast, LeftAndRightDifferInBrightnessForADeuteranope) {
  const double left = deuteranope_luminance(theme_.left);
  const double right = deuteranope_luminance(theme_.right);
  EXPECT_GE((std::max(left, right) + 0.05) / (std::min(left, right) + 0.05), 1.2);
}

TEST_P(ThemeContrast, ProjectorIsNeverFainter) {
  const Theme strong = with_more_contrast(theme_);
  EXPECT_GE(contrast(strong.text, strong.panel), contrast(theme_.text, theme_.panel));
  EXPECT_GT(contrast(strong.dim_text, strong.panel), contrast(theme_.dim_text, theme_.panel));
  EXPECT_GT(contrast(strong.line, strong.panel), contrast(theme_.line, theme_.panel));
}

INSTANTIATE_TEST_SUITE_P(BothThemes, ThemeContrast, testing::Values(ThemeKind::Dark, ThemeKind::Light),
                         [](const auto& tested) { return tested.param == ThemeKind::Dark ? "Dark" : "Light"; });

TEST(Theme, AlphaIsMultipliedAndKeptInRange) {
  const ImU32 half = with_alpha(IM_COL32(10, 20, 30, 200), 0.5f);
  EXPECT_EQ(half, IM_COL32(10, 20, 30, 100));
  EXPECT_EQ(with_alpha(half, 7.0f), half);
  EXPECT_EQ(with_alpha(half, -1.0f) >> IM_COL32_A_SHIFT, 0U);
}

}  // namespace
}  // namespace marey::app
