#include "wasm/app/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace marey::app {
namespace {

using Named = std::pair<const char*, Region>;

std::vector<Named> shown_regions(const Layout& layout) {
  std::vector<Named> shown;
  for (const Named& named : {Named{"title", layout.title}, Named{"messages", layout.messages},
                             Named{"outliner", layout.outliner}, Named{"viewport", layout.viewport},
                             Named{"inspector", layout.inspector}, Named{"transport", layout.transport},
                             Named{"sheet header", layout.sheet_header}, Named{"ruler", layout.ruler},
                             Named{"curves", layout.curves}}) {
    if (!named.second.empty()) shown.push_back(named);
  }
  return shown;
}

bool overlap(const Region& a, const Region& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

double area(const std::vector<Named>& regions) {
  double sum = 0.0;
  for (const Named& named : regions) sum += static_cast<double>(named.second.width()) * static_cast<double>(named.second.height());
  return sum;
}

// A panel that is opening reaches out of the window; what counts is what is seen of it.
std::vector<Named> seen_regions(const Layout& layout, ImVec2 size) {
  std::vector<Named> regions = shown_regions(layout);
  for (Named& named : regions) {
    named.second.min.x = std::max(named.second.min.x, 0.0f);
    named.second.max.x = std::min(named.second.max.x, size.x);
    named.second.max.y = std::min(named.second.max.y, size.y);
  }
  return regions;
}

void expect_tiled(const LayoutInput& input) {
  const Layout layout = compute_layout(input);
  const auto regions = seen_regions(layout, input.size);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (std::size_t j = i + 1; j < regions.size(); ++j) {
      EXPECT_FALSE(overlap(regions[i].second, regions[j].second)) << regions[i].first << " and " << regions[j].first;
    }
  }
  EXPECT_NEAR(area(regions), static_cast<double>(input.size.x) * static_cast<double>(input.size.y), 1.0);
  EXPECT_FALSE(layout.viewport.empty());
}

class LayoutOfSize : public testing::TestWithParam<ImVec2> {};

TEST_P(LayoutOfSize, RegionsTileTheWindowWhateverIsShown) {
  for (const bool touch : {false, true}) {
    for (const float messages : {0.0f, 58.0f}) {
      for (int bits = 0; bits < 8; ++bits) {
        Preferences preferences;
        preferences.sheet = static_cast<Sheet>(bits % 4);
        expect_tiled({.size = GetParam(),
                      .messages_height = messages,
                      .touch = touch,
                      .outliner_share = (bits & 1) != 0 ? 1.0f : 0.0f,
                      .inspector_share = (bits & 2) != 0 ? 1.0f : 0.37f,
                      .curves_share = (bits & 4) != 0 ? 1.0f : 0.0f,
                      .preferences = &preferences});
      }
    }
  }
}

TEST_P(LayoutOfSize, PanelsOfAnySizeLeaveRoomForTheViewport) {
  for (const float size : {0.0f, 5000.0f}) {
    Preferences preferences;
    preferences.sizes = {size, size, size};
    const Layout layout = compute_layout({.size = GetParam(), .preferences = &preferences});
    EXPECT_GE(layout.viewport.width(), std::min(GetParam().x, 240.0f) - 1.0f);
    EXPECT_GE(layout.viewport.height(), 50.0f);
  }
}

INSTANTIATE_TEST_SUITE_P(Windows, LayoutOfSize,
                         testing::Values(ImVec2(1280, 800), ImVec2(1920, 1080), ImVec2(360, 740), ImVec2(390, 844),
                                         ImVec2(700, 420), ImVec2(844, 390), ImVec2(512, 320), ImVec2(3840, 2160)));

TEST(Layout, HasTheMeasuresOfTheDesignAt1280By800) {
  const Preferences preferences;
  const Layout layout = compute_layout({.size = ImVec2(1280, 800), .preferences = &preferences});
  EXPECT_FALSE(layout.compact);
  EXPECT_EQ(layout.title.height(), 40.0f);
  EXPECT_EQ(layout.outliner.width(), 240.0f);
  EXPECT_EQ(layout.inspector.width(), 300.0f);
  EXPECT_GE(layout.curves.height(), 240.0f);
}

TEST(Layout, NarrowWindowsGetOneColumnWithTheViewportOnTop) {
  Preferences preferences;
  preferences.sheet = Sheet::Joints;
  const Layout layout = compute_layout({.size = ImVec2(390, 844), .preferences = &preferences});
  EXPECT_TRUE(layout.compact);
  EXPECT_EQ(layout.viewport.width(), 390.0f);
  EXPECT_LT(layout.viewport.max.y, layout.transport.min.y + 1.0f);
  EXPECT_FALSE(layout.outliner.empty());
  EXPECT_TRUE(layout.curves.empty());
  EXPECT_GE(layout.sheet_header.height(), 40.0f);
}

}  // namespace
}  // namespace marey::app
