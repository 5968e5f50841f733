#include "wasm/views/explorer/order_view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/base/counted.h"
#include "core/motion/euler_channels.h"
#include "core/motion/sampling.h"
#include "wasm/app/widgets.h"
#include "wasm/views/graph/small_plot.h"

namespace marey::app {
namespace {

constexpr int kMostFrames = 8192;
constexpr double kNearLockDeg = 15.0;
constexpr float kLeastWidth = 180.0f;
constexpr char kLetters[] = {'X', 'Y', 'Z'};
constexpr EulerOrder kOrders[] = {{Axis::X, Axis::Y, Axis::Z}, {Axis::X, Axis::Z, Axis::Y}, {Axis::Y, Axis::X, Axis::Z},
                                  {Axis::Y, Axis::Z, Axis::X}, {Axis::Z, Axis::X, Axis::Y}, {Axis::Z, Axis::Y, Axis::X}};

bool turns(const Skeleton& skeleton, JointIndex joint) {
  const auto channels = skeleton.channels(joint);
  return std::any_of(channels.begin(), channels.end(), [](const Channel& channel) { return is_rotation(channel.kind); });
}

}  // namespace

void OrderView::follow(const ViewContext& context, JointIndex joint) {
  const Document& document = context.session.document;
  if (joint_ == joint && clip_serial_ == context.clip_serial && revision_ == document.revision()) return;
  joint_ = joint;
  clip_serial_ = context.clip_serial;
  revision_ = document.revision();
  has_rotation_ = turns(document.skeleton(), joint);
  if (!has_rotation_) return;
  const int count = document.motion().frame_count();
  const int length = std::min(count, kMostFrames);
  frames_ = {std::clamp(context.session.playback.frame() - length / 2, 0, count - length), length};
  times_.clear();
  for (int i = 0; i < length; ++i) times_.push_back(frames_.first + i + 1.0);
  for (std::size_t o = 0; o < orders_.size(); ++o) {
    Order& order = orders_[o];
    order = {kOrders[o], {}, {}, 0};
    glm::dvec3 previous(0.0);
    for (int i = 0; i < length; ++i) {
      const glm::dmat3 rotation = glm::mat3_cast(joint_rotation(document.skeleton(), document.motion(), joint, frames_.first + i));
      const glm::dvec3 angles = i == 0 ? euler_from_rotation(order.order, rotation) : euler_near(order.order, rotation, previous);
      if (std::isfinite(angles.x) && std::isfinite(angles.y)) previous = angles;
      order.angles[static_cast<int>(order.order.first)].push_back(angles.x);
      order.angles[static_cast<int>(order.order.second)].push_back(angles.y);
      order.angles[static_cast<int>(order.order.third)].push_back(angles.z);
      if (std::abs(std::remainder(angles.y - 90.0, 180.0)) > kNearLockDeg) continue;
      ++order.locked_frames;
      const bool goes_on = !order.locked.empty() && order.locked.back().end() == i;
      if (!goes_on) order.locked.push_back({i, 0});
      ++order.locked.back().count;
    }
  }
}

void OrderView::draw_order(ViewContext& context, const Order& order, int index, ImVec4 place) const {
  const ImU32 colors[] = {context.theme.axis[0], context.theme.axis[1], context.theme.axis[2]};
  std::array<PlotCurve, 3> curves;
  for (std::size_t c = 0; c < 3; ++c) curves[c] = {times_, order.angles[c], colors[c], 1.5f};
  std::vector<PlotStretch> stretches;
  for (const FrameRange& range : order.locked) {
    const double from = frames_.first + range.first + 0.5;
    stretches.push_back({from, from + range.count, with_alpha(context.theme.warning, 0.28f)});
  }
  const auto own = find_euler_channels(context.session.document.skeleton(), joint_);
  const bool is_own = own && own->order == order.order;
  const SmallText title("{}{}{}{}  {}", kLetters[static_cast<int>(order.order.first)], kLetters[static_cast<int>(order.order.second)],
                        kLetters[static_cast<int>(order.order.third)], is_own ? " (as it is)" : "",
                        order.locked_frames == 0 ? std::string("never near lock")
                                                 : counted(order.locked_frames, "frame") + " near lock");
  const PlotMark now{context.session.playback.position() + 1.0, context.theme.cursor, ""};
  const SmallPlot plot{title, "frame", "°", times_.front(), std::max(times_.back(), times_.front() + 1.0),
                       curves, std::span(&now, 1), stretches, false};
  draw_small_plot(context, SmallText("orders.plot.{}", index).c_str(), {place.x, place.y}, {place.z, place.w}, plot);
}

void OrderView::draw(ViewContext& context, ImVec2 min, ImVec2 max) {
  const JointIndex joint = context.session.selection.active_joint();
  if (joint == kNoParent) return;
  follow(context, joint);
  ImGui::SetCursorScreenPos({min.x + 12.0f, min.y + 4.0f});
  ImGui::AlignTextToFramePadding();
  if (!has_rotation_) {
    ui::dim_text(context, "This joint does not turn.");
    return;
  }
  const float room = max.x - min.x - 24.0f - 3.0f * (ImGui::GetFrameHeight() + 2.0f);
  const SmallText text("{} in the six orders: red X, green Y, blue Z. Shaded: the middle angle within 15° of lock.",
                       context.session.document.skeleton().name(joint));
  ui::elided_text(context, text, room, context.theme.dim_text);
  const ImVec2 top{min.x + 4.0f, min.y + ImGui::GetFrameHeight() + 8.0f};
  for (int i = 0; i < size_of(orders_); ++i) {
    draw_order(context, orders_[idx(i)], i, plot_place(i, size_of(orders_), top, max, kLeastWidth));
  }
}

}  // namespace marey::app
