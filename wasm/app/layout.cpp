#include "wasm/app/layout.h"

#include <algorithm>
#include <cmath>

#include "wasm/views/timeline_view.h"
#include "wasm/views/transport_view.h"

namespace marey::app {
namespace {

constexpr float kTitleHeight = 40.0f;
constexpr float kTouchBarHeight = 48.0f;
constexpr float kTransportHeight = TransportView::kHeight;
constexpr float kTouchTransportHeight = 52.0f;
constexpr float kRulerHeight = TimelineView::kHeight;
constexpr float kLeastViewportWidth = 240.0f;
constexpr float kLeastViewportHeight = 140.0f;

float clamp_to(float value, SplitterLimits limits) {
  return std::round(std::clamp(value, limits.low, std::max(limits.low, limits.high)));
}

// Takes a strip off the top, bottom, left or right of `rest`; never more than is left.
Region take_top(Region& rest, float height) {
  const Region strip{rest.min, ImVec2(rest.max.x, std::min(rest.max.y, rest.min.y + height))};
  rest.min.y = strip.max.y;
  return strip;
}

Region take_bottom(Region& rest, float height) {
  const Region strip{ImVec2(rest.min.x, std::max(rest.min.y, rest.max.y - height)), rest.max};
  rest.max.y = strip.min.y;
  return strip;
}

Region take_left(Region& rest, float width) {
  const Region strip{rest.min, ImVec2(std::min(rest.max.x, rest.min.x + width), rest.max.y)};
  rest.min.x = strip.max.x;
  return strip;
}

Region take_right(Region& rest, float width) {
  const Region strip{ImVec2(std::max(rest.min.x, rest.max.x - width), rest.min.y), rest.max};
  rest.max.x = strip.min.x;
  return strip;
}

void lay_out_wide(const LayoutInput& input, Region rest, Layout& layout) {
  const PanelSizes& sizes = input.preferences->sizes;
  const float lower_height = clamp_to(sizes.curves_height, curves_limits(input.size)) - kRulerHeight;
  layout.curves = take_bottom(rest, std::round(lower_height * input.curves_share));
  if (!layout.curves.empty()) layout.curves.max.y = layout.curves.min.y + lower_height;
  layout.ruler = take_bottom(rest, kRulerHeight);
  layout.transport = take_bottom(rest, input.touch ? kTouchTransportHeight : kTransportHeight);
  const float outliner_width = clamp_to(sizes.outliner_width, outliner_limits(input.size));
  const float inspector_width = clamp_to(sizes.inspector_width, inspector_limits(input.size));
  layout.outliner = take_left(rest, std::round(outliner_width * input.outliner_share));
  layout.inspector = take_right(rest, std::round(inspector_width * input.inspector_share));
  if (!layout.outliner.empty()) layout.outliner.min.x = layout.outliner.max.x - outliner_width;
  if (!layout.inspector.empty()) layout.inspector.max.x = layout.inspector.min.x + inspector_width;
  layout.viewport = rest;
}

void lay_out_compact(const LayoutInput& input, Region rest, Layout& layout) {
  const Sheet sheet = input.preferences->sheet;
  if (sheet != Sheet::None) {
    const float wanted = std::round((rest.max.y - rest.min.y) * 0.42f);
    Region body = take_bottom(rest, wanted);
    if (sheet == Sheet::Curves) {
      layout.ruler = take_top(body, kRulerHeight);
      layout.curves = body;
    } else {
      (sheet == Sheet::Joints ? layout.outliner : layout.inspector) = body;
    }
  }
  layout.sheet_header = take_bottom(rest, kTouchBarHeight);
  layout.transport = take_bottom(rest, kTouchTransportHeight);
  layout.viewport = rest;
}

}  // namespace

SplitterLimits outliner_limits(ImVec2 size) {
  return {160.0f, std::min(480.0f, (size.x - kLeastViewportWidth) * 0.45f)};
}

SplitterLimits inspector_limits(ImVec2 size) {
  return {220.0f, std::min(560.0f, (size.x - kLeastViewportWidth) * 0.55f)};
}

SplitterLimits curves_limits(ImVec2 size) {
  const float bars = kTitleHeight + kTransportHeight;
  return {std::min(120.0f, size.y * 0.3f), size.y - bars - std::min(kLeastViewportHeight, size.y * 0.35f)};
}

Layout compute_layout(const LayoutInput& input) {
  Layout layout;
  layout.compact = input.size.x < kCompactWidth;
  Region rest{ImVec2(0.0f, 0.0f), input.size};
  layout.title = take_top(rest, layout.compact || input.touch ? kTouchBarHeight : kTitleHeight);
  layout.messages = take_top(rest, input.messages_height);
  if (layout.compact) {
    lay_out_compact(input, rest, layout);
  } else {
    lay_out_wide(input, rest, layout);
  }
  return layout;
}

}  // namespace marey::app
