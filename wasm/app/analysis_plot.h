#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/biomechanics/analysis.h"
#include "core/document/session.h"

namespace marey::app {

/// A quantity that is plotted.
struct PlotChoice {
  const Quantity* quantity = nullptr;
  std::string owner{};  ///< a joint or end site as node_label() names it; "" for the active joint, or the whole body
  std::string frame{};  ///< what it is seen from, as ask_for() reads it; "" as usual
  glm::dvec3 point_m{0.0};  ///< fixed to the joint, where it is of a point
  friend bool operator==(const PlotChoice&, const PlotChoice&) = default;
};

/// A component of a plot over all frames, in the plot's unit; not a number where it is not defined.
struct PlotLine {
  char component = 0;  ///< 'x', 'y', 'z'; 0 for a quantity without direction
  std::vector<double> values;
};

/// How far a component moves when what it rests on is taken a little otherwise.
struct PlotBand {
  char component = 0;
  std::vector<double> low;
  std::vector<double> high;
};

/// The lines of a clip beside the open one.
struct OtherLines {
  std::vector<PlotLine> lines;  ///< at the times of the open clip's frames
  std::span<const PlotLine> own;  ///< at its own; ComparedClips keeps them
  double frame_time_s = 1.0;    ///< its own
};

/// What is plotted, ready to be drawn: angles in degrees, everything else in SI.
struct AnalysisPlot {
  PlotChoice choice;
  NodeIndex node = kNoParent;  ///< kNoParent for the whole body, and where nobody has that name
  std::string problem;        ///< why there are no lines: nobody of that name, no masses; "" where there are
  std::string owner;          ///< "Body", "whole body"
  AskedQuantity asked;        ///< where there is no problem

  /// "Hand +0/0.1/0 in Hips".
  [[nodiscard]] std::string whose() const;
  std::string_view unit;      ///< "°/s", "N·m"
  std::vector<PlotLine> lines;
  std::vector<PlotLine> raw;    ///< without smoothing, where that was asked for
  std::vector<PlotBand> bands;  ///< around the lines, where that was asked for
  std::vector<OtherLines> others;  ///< of the clips beside the open one, in their order

  /// "Joint torque [N·m]".
  [[nodiscard]] std::string title() const;
};

/// The columns of a table that are of one quantity, in the units that are shown.
[[nodiscard]] std::vector<PlotLine> lines_of(const AnalysisTable& table, const AskedQuantity& asked);
/// The values at 0, step, 2 step ... frames, straight between two; not a number behind the last.
[[nodiscard]] std::vector<double> at_other_times(std::span<const double> values, double step, int count);
/// The node of a name that a quantity can be of; kNoParent where there is none.
[[nodiscard]] NodeIndex find_owner(const Skeleton& skeleton, const Quantity& quantity, std::string_view name);
/// Makes a band hold further values.
void widen(PlotBand& band, std::span<const double> values);

/// The joint that plots of the active joint are of: that, or without one the first that turns, below the root if there is any.
[[nodiscard]] JointIndex find_plotted_joint(const Session& session);
/// Whether a quantity is of a joint, so that it can be that of the active one.
[[nodiscard]] bool is_of_joint(const Quantity& quantity);
/// For people: "°/s" for "rad/s", "N·m" for "N.m".
[[nodiscard]] std::string_view shown_unit(std::string_view unit);

}  // namespace marey::app
