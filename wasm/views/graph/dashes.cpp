#include "wasm/views/graph/dashes.h"

#include <cmath>
#include <utility>

namespace marey::app {

void stroke_dashed(ImDrawList& list, std::span<const ImVec2> points, ImU32 color, float width, Dashes dashes) {
  if (dashes.empty() || points.empty()) {
    list.AddPolyline(points.data(), static_cast<int>(points.size()), color, ImDrawFlags_None, width);
    return;
  }
  std::size_t dash = 0;
  float left = dashes[0];
  list.PathLineTo(points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    ImVec2 at = points[i - 1];
    float way = std::hypot(points[i].x - at.x, points[i].y - at.y);
    while (way > left) {
      const float share = left / way;
      at = {at.x + share * (points[i].x - at.x), at.y + share * (points[i].y - at.y)};
      way -= left;
      list.PathLineTo(at);
      if (dash % 2 == 0) list.PathStroke(color, ImDrawFlags_None, width);
      dash = (dash + 1) % dashes.size();
      left = dashes[dash];
    }
    left -= way;
    if (dash % 2 == 0) list.PathLineTo(points[i]);
  }
  list.PathStroke(color, ImDrawFlags_None, width);
}

void stroke_path(ImDrawList& list, ImU32 color, float width, Dashes dashes) {
  if (dashes.empty()) {
    list.PathStroke(color, ImDrawFlags_None, width);
    return;
  }
  ImVector<ImVec2> path;
  path.swap(list._Path);
  stroke_dashed(list, {path.Data, static_cast<std::size_t>(path.Size)}, color, width, dashes);
}

}  // namespace marey::app
