#pragma once

#include <imgui.h>

#include <cstdint>
#include <vector>

namespace marey::app {

/// A place of a curve; ImGui units of the window. It is joined to the next one unless its colour is clear.
struct CurvePlace {
  float x = 0.0f;
  float top = 0.0f;
  float bottom = 0.0f;
  ImU32 color = 0;
};

/// Curves of a graph, strip after strip, that are drawn at once, from memory of the graphics card: as long as nothing of them changes, drawing
/// them again costs a single draw call, however many they are.
struct CurveBatch {
  std::vector<CurvePlace> places;
  /// Lines are as wide across their direction as their places are high; bands reach from the tops to the bottoms.
  bool lines = false;
  /// Grows with each change.
  std::uint64_t serial = 0;

  /// Call first, for each anew; end_strip() behind the places of each strip; finish() last. The renderer needs a place before
  /// the first and one behind the last.
  void begin() {
    places.assign(1, {});
    ++serial;
  }
  void end_strip() { places.back().color &= ~IM_COL32_A_MASK; }
  void finish() { places.push_back({}); }
};

/// Draws the batch in front of what the list holds, within its clip rectangle. The batch stays as it is until the frame
/// has been drawn.
void add_curve_batch(ImDrawList& list, const CurveBatch& batch);

}  // namespace marey::app
