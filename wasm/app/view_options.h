#pragma once

#include "core/base/index.h"
#include "core/skeleton/channel.h"
#include "wasm/app/shown_arrows.h"

namespace marey::app {

enum class ViewPreset { Free, Front, Side, Top };

/// What stands in the room below the timeline.
enum class CurvesPage { Curves, Filter, Orders, Plots };

/// How plots of quantities are shown: over time, each against the first of them, or as statistics of the range.
enum class PlotMode { OverTime, AgainstFirst, Statistics };

/// What the views show and how; kept between visits, not part of a file.
struct ViewOptions {
  bool show_outliner = true;
  bool show_inspector = true;
  bool show_curves = true;
  bool show_grid = true;
  bool show_shadow = true;
  bool show_names = false;
  bool show_strobe = false;
  int strobe_every_frames = 4;  ///< >= 1; set anew for each clip
  bool show_trails = false;     ///< of the selected joints; of the end sites when none is selected
  bool follow_root = false;
  bool show_performance = false;  ///< the card of what drawing takes
  bool orthographic = false;
  CurvesPage curves_page = CurvesPage::Curves;  ///< not kept between visits
  PlotMode plot_mode = PlotMode::OverTime;      ///< not kept between visits
  ShownArrows shown_arrows;                     ///< not kept between visits
  bool show_solids = false;                     ///< segments as ellipsoids of their inertia; not kept between visits
  float falloff_radius_frames = 8.0f;  ///< of a drag in the curve editor
  float smooth_sigma_frames = 2.0f;
  float interface_scale = 1.0f;  ///< 1 to 2.5
  bool projector = false;        ///< for a class: thicker curves, higher contrast, interface at 150 %
  bool touch = false;            ///< the last pointer was a finger, or the page is narrow: targets of 40 px
  bool compact = false;          ///< narrower than 700 units: one column; set by the layout
  bool operator==(const ViewOptions&) const = default;
};

/// What the pointer is over, so that body, tree row and curve of the same joint light up together. Views write it while
/// drawing; it is read in the next frame.
struct Hover {
  JointIndex joint = kNoParent;
  ChannelIndex channel = -1;
};

}  // namespace marey::app
