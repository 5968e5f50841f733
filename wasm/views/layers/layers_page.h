#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/motion/curve_deviation.h"
#include "wasm/app/view_context.h"

namespace marey::app {

struct Workspace;

/// The page of the inspector with the layers of keys over the samples: which one keys are set on, what counts and how much,
/// and how far the result is from what is beneath.
class LayersPage {
 public:
  void draw(ViewContext& context);

 private:
  void draw_layer(ViewContext& context, int layer);
  void draw_base(ViewContext& context);
  void draw_active(ViewContext& context);
  void draw_name(ViewContext& context, int layer);
  void draw_weight(ViewContext& context, int layer);
  void draw_modes(ViewContext& context, int layer);
  void draw_keys(ViewContext& context);
  void draw_deviations(ViewContext& context);
  void follow_clip(const ViewContext& context);

  /// How far a channel of the active joint is from what is beneath the layers.
  struct Deviation {
    ChannelIndex channel = 0;
    CurveDeviation of;
  };
  std::vector<Deviation> deviations_;
  std::uint64_t clip_serial_ = 0;
  std::uint64_t revision_ = 0;
  JointIndex joint_ = kNoParent;
  std::string name_;  ///< of the active layer, while it is typed
  bool naming_ = false;
};

/// Registers what the page does: layer.add, layer.delete, keys.set and others.
void add_layer_commands(CommandRegistry& registry, Workspace& workspace);

}  // namespace marey::app
