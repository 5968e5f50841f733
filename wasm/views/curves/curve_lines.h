#pragma once

#include <cstdint>
#include <vector>

#include "core/document/curve_cache.h"
#include "wasm/app/view_context.h"
#include "wasm/render/curve_batch.h"
#include "wasm/views/curves/curves_state.h"
#include "wasm/views/graph/curve_band.h"
#include "wasm/views/graph/curve_shape.h"

namespace marey::app {

/// More curves than these are not told apart one by one: each must be cheap.
inline constexpr std::size_t kMostCurvesInDetail = 48;

/// Draws the curves of the curve editor and the ghosts of what was saved behind them, each of them shaped anew only when
/// something of it has changed. docs/decisions/drawing-curves.md says how.
class CurveLines {
 public:
  void draw(const ViewContext& context, const CurvesState& state);

 private:
  /// All that the look of the curves follows from.
  struct Look {
    std::uint64_t clip_serial = 0;
    std::uint64_t revision = 0;
    std::uint64_t saves = 0;
    TimeWindow time;
    ValueAxis angles;
    ValueAxis lengths;
    ChannelIndex hit = -1;
    ChannelIndex hovered = -1;
    JointIndex active = kNoParent;
    ImU32 colors[5] = {};
    std::vector<ChannelIndex> shown;
    bool operator==(const Look&) const = default;
  };
  struct Line {
    ChannelIndex channel = 0;
    ImU32 color = 0;
    float width = 1.0f;
    bool ghost = false;
  };
  /// Whether the look is another one than in the last frame.
  bool follow(const ViewContext& context, const CurvesState& state);
  void add_lines(const ViewContext& context, const CurvesState& state);
  void add_line(const ViewContext& context, const CurvesState& state, const Line& line);
  [[nodiscard]] Line line_of(const ViewContext& context, const CurvesState& state, ChannelIndex channel) const;

  CurveCache cache_;
  CurveShape shape_;
  CurveBand band_;
  CurveBatch batch_;
  Look look_;
  CurveColumns columns_;
  bool dense_ = false;  // curves are drawn by columns
  bool known_ = false;  // look_ is that of batch_
};

/// Whether a curve stands out, as the pointer is over it or over its row.
[[nodiscard]] bool is_curve_hovered(const ViewContext& context, const CurvesState& state, ChannelIndex channel);

/// Colour of a channel's curve: that of its axis.
[[nodiscard]] ImU32 channel_color(const Theme& theme, const Channel& channel);

/// As drawn: curves of the active joint stand before those of the others.
[[nodiscard]] ImU32 curve_color(const ViewContext& context, const CurvesState& state, ChannelIndex channel);

}  // namespace marey::app
