#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/motion/curve_deviation.h"
#include "core/signal/residual_analysis.h"
#include "core/signal/spectrum.h"
#include "wasm/app/view_context.h"
#include "wasm/views/operations/operation_form.h"

namespace marey::app {

/// A curve before and after the previewed operation: the curve, its second derivative, its spectrum, and how far it is from
/// itself filtered by the cut-off. Of long clips, the frames around the cursor.
class FilterExplorer {
 public:
  /// `form` is that of the operation, open or not; `shown` are the channels of the curve editor.
  void draw(ViewContext& context, const OperationForm& form, const std::vector<ChannelIndex>& shown, ImVec2 min, ImVec2 max);

 private:
  /// One state of the curve.
  struct State {
    std::vector<double> curve;
    std::vector<double> acceleration;
    Spectrum spectrum;
    std::vector<double> hertz;
  };
  void choose_channel(ViewContext& context, const OperationForm& form, const std::vector<ChannelIndex>& shown);
  void follow(const ViewContext& context, bool is_previewed);
  void draw_advice(ViewContext& context, bool is_open, float right) const;
  [[nodiscard]] static State look_at(std::vector<double> curve, double rate_hz);
  void draw_plots(ViewContext& context, const OperationForm& form, ImVec2 min, ImVec2 max) const;

  ChannelIndex channel_ = -1;
  FrameRange frames_;
  std::uint64_t clip_serial_ = 0;
  std::uint64_t revision_ = 0;
  bool known_ = false;
  State before_;
  State after_;
  CurveDeviation change_;  ///< from before to after
  bool differs_ = false;
  std::vector<double> seconds_;
  ResidualAnalysis residuals_;
  std::vector<double> cutoffs_;
  std::vector<double> rms_;
};

}  // namespace marey::app
