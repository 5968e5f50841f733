#include "wasm/app/analysis_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/math/angle.h"

namespace marey::app {
namespace {

struct ShownUnit {
  std::string_view unit;
  std::string_view shown;
  bool is_angle = false;
};
constexpr std::array kShownUnits = {ShownUnit{"rad", "°", true},      ShownUnit{"rad/s", "°/s", true},
                                    ShownUnit{"rad/s2", "°/s²", true}, ShownUnit{"m/s2", "m/s²"},
                                    ShownUnit{"N.m", "N·m"},           ShownUnit{"kg.m/s", "kg·m/s"},
                                    ShownUnit{"kg.m2/s", "kg·m²/s"}};

const ShownUnit* find_unit(std::string_view unit) {
  const auto found = std::find_if(kShownUnits.begin(), kShownUnits.end(), [&](const ShownUnit& u) { return u.unit == unit; });
  return found == kShownUnits.end() ? nullptr : &*found;
}

bool can_have(const Skeleton& skeleton, const Quantity& quantity, NodeIndex node) {
  return quantity.owner == QuantityOwner::Point || !skeleton.node(node).is_end_site;
}

}  // namespace

NodeIndex find_owner(const Skeleton& skeleton, const Quantity& quantity, std::string_view name) {
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (can_have(skeleton, quantity, node) && node_label(skeleton, node) == name) return node;
  }
  return kNoParent;
}

std::vector<PlotLine> lines_of(const AnalysisTable& table, const AskedQuantity& asked) {
  std::vector<PlotLine> lines;
  for (const AnalysisColumn& column : table.columns) {
    if (!asks_the_same(column.asked, asked)) continue;
    if (std::any_of(lines.begin(), lines.end(), [&](const PlotLine& line) { return line.component == column.component; })) continue;
    PlotLine line{column.component, column.values};
    const ShownUnit* unit = find_unit(column.asked.quantity->unit);
    if (unit != nullptr && unit->is_angle) {
      for (double& value : line.values) value = to_degrees(value);
    }
    lines.push_back(std::move(line));
  }
  std::sort(lines.begin(), lines.end(), [](const PlotLine& a, const PlotLine& b) { return a.component < b.component; });
  return lines;
}

std::vector<double> at_other_times(std::span<const double> values, double step, int count) {
  std::vector<double> result(idx(count), std::nan(""));
  for (int i = 0; i < count; ++i) {
    const double place = i * step;
    if (!(place <= static_cast<double>(values.size()) - 1.0)) break;
    const auto before = static_cast<std::size_t>(place);
    const std::size_t behind = std::min(before + 1, values.size() - 1);
    const double share = place - static_cast<double>(before);
    result[idx(i)] = share == 0.0 ? values[before] : values[before] + share * (values[behind] - values[before]);
  }
  return result;
}

void widen(PlotBand& band, std::span<const double> values) {
  for (std::size_t i = 0; i < std::min(values.size(), band.low.size()); ++i) {
    if (!std::isfinite(values[i]) || !std::isfinite(band.low[i])) continue;
    band.low[i] = std::min(band.low[i], values[i]);
    band.high[i] = std::max(band.high[i], values[i]);
  }
}

JointIndex find_plotted_joint(const Session& session) {
  const Skeleton& skeleton = session.document.skeleton();
  if (session.selection.active_joint() != kNoParent) return session.selection.active_joint();
  const JointIndex first = skeleton.joint_count() > 0 ? 0 : kNoParent;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const auto channels = skeleton.channels(joint);
    const bool turns = std::any_of(channels.begin(), channels.end(), [](const Channel& c) { return is_rotation(c.kind); });
    if (turns && skeleton.parent(joint) != kNoParent) return joint;
  }
  return first;
}

bool is_of_joint(const Quantity& quantity) {
  return quantity.owner == QuantityOwner::Point || quantity.owner == QuantityOwner::Joint;
}

std::string_view shown_unit(std::string_view unit) {
  const ShownUnit* found = find_unit(unit);
  return found == nullptr ? unit : found->shown;
}

std::string AnalysisPlot::whose() const {
  std::string text = owner;
  const glm::dvec3& point = asked.point_m;
  if (point != glm::dvec3(0.0)) text += fmt::format(" +{}/{}/{}", point.x, point.y, point.z);
  if (!choice.frame.empty()) text += " in " + choice.frame;
  return text;
}

std::string AnalysisPlot::title() const { return fmt::format("{} [{}]", choice.quantity->label, unit); }

}  // namespace marey::app
