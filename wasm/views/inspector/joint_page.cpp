#include "wasm/views/inspector/joint_page.h"

#include <cmath>
#include <string>

#include "core/editing/clip_operations.h"
#include "core/editing/curve_operations.h"
#include "core/editing/key_edits.h"
#include "core/math/angle.h"
#include "core/motion/sampling.h"
#include "wasm/app/widgets.h"
#include "wasm/views/number_edit.h"
#include "wasm/views/inspector/property_row.h"

namespace marey::app {
namespace {

constexpr const char* kAxisNames[] = {"X", "Y", "Z"};

std::string_view parent_name(const Skeleton& skeleton, JointIndex joint) {
  const JointIndex parent = skeleton.parent(joint);
  return parent == kNoParent ? std::string_view("none, this is a root") : skeleton.name(parent);
}

// With a layer, or on a channel of keys, a number is a key at the frame; else it is the sample.
Edit make_value_edit(ViewContext& context, const Clip& clip, ChannelIndex channel, double value) {
  const Session& session = context.session;
  const FrameIndex frame = session.playback.frame();
  const bool sets_key = session.active_layer != kOwnKeys || clip.stack.keyed.contains(channel);
  if (!sets_key) return make_sample_edit(clip, channel, frame, value);
  Result<Edit> edit = make_pose_key_edit(clip, "Set key", session.active_layer, frame, {{channel, value}});
  if (edit) return std::move(*edit);
  context.refusal = edit.error().message;
  return {};
}

}  // namespace

void JointPage::draw_offset(ViewContext& context, NodeIndex node) {
  Session& session = context.session;
  const glm::dvec3 offset = session.document.skeleton().node(node).offset;
  for (int axis = 0; axis < 3; ++axis) {
    const float width = inspector::begin_row(context, kAxisNames[axis]);
    const auto result = ui::number_field(context, SmallText("inspector.offset.{}.{}", node, axis).c_str(), "Offset",
                                         offset[axis], {.unit = "units", .decimals = 4, .step = 0.05, .width = width});
    apply_number(context, result, [&](const Clip& clip) {
      glm::dvec3 moved = clip.skeleton.node(node).offset;
      moved[axis] = result.value;
      return make_offset_edit(clip, node, moved);
    });
    inspector::end_row();
  }
}

void JointPage::draw_channels(ViewContext& context, JointIndex joint) {
  Session& session = context.session;
  const Skeleton& skeleton = session.document.skeleton();
  const FrameIndex frame = session.playback.frame();
  inspector::heading(context, SmallText("Channels at frame {}", frame + 1));
  const ChannelIndex first = skeleton.first_channel(joint);
  for (ChannelIndex channel = first; channel < first + skeleton.channel_count(joint); ++channel) {
    const Channel& described = skeleton.channel(channel);
    const std::string_view name = channel_name(described);
    const float width = inspector::begin_row(context, name);
    const bool angle = is_rotation(described.kind);
    const auto result = ui::number_field(
        context, SmallText("inspector.channel.{}", channel).c_str(), name, session.document.motion().sample(channel, frame),
        {.unit = angle ? "°" : "units", .decimals = 4, .step = angle ? 0.2 : 0.05, .width = width});
    apply_number(context, result, [&](const Clip& clip) { return make_value_edit(context, clip, channel, result.value); });
    inspector::end_row();
  }
  if (skeleton.channel_count(joint) == 0) inspector::text_row(context, "Channels", "none");
}

// The same rotation as a unit quaternion and as axis times angle, relative to the parent.
void JointPage::draw_rotation(ViewContext& context, JointIndex joint) {
  const Document& document = context.session.document;
  const FrameBlend at = find_frame_blend(document.motion().frame_count(), context.session.playback.position());
  glm::dquat q = joint_rotation(document.skeleton(), document.motion(), joint, at);
  if (q.w < 0.0) q = -q;
  const double half_sine = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
  const double degrees = half_sine > 0.0 ? 2.0 * to_degrees(std::atan2(half_sine, q.w)) / half_sine : 2.0 * kDegreesPerRadian;
  inspector::heading(context, "Rotation");
  inspector::known_text_row(context, "inspector.quaternion", "w x y z",
                             SmallText("{:.3f} {:.3f} {:.3f} {:.3f}", q.w, q.x, q.y, q.z), true);
  inspector::known_text_row(context, "inspector.rotation_vector", "Vector",
                             SmallText("{:.2f}° {:.2f}° {:.2f}°", degrees * q.x, degrees * q.y, degrees * q.z), true);
}

void JointPage::draw_world_position(ViewContext& context, JointIndex joint) {
  const Document& document = context.session.document;
  const Skeleton& skeleton = document.skeleton();
  local_.resize(skeleton);
  world_.resize(skeleton);
  compute_local_pose_between(skeleton, document.motion(), context.session.playback.position(),
                             document.settings().position_rule, local_);
  compute_world_pose(skeleton, local_, world_);
  const glm::dvec3 place = world_.world_positions[idx(skeleton.node_of(joint))];
  inspector::heading(context, "World position");
  for (int axis = 0; axis < 3; ++axis) {
    const double metres = place[axis] * document.settings().metres_per_unit;
    inspector::text_row(context, kAxisNames[axis], SmallText("{:.2f} units {:8.3f} m", place[axis], metres), true);
  }
}

void JointPage::draw_end_sites(ViewContext& context, JointIndex joint) {
  const Skeleton& skeleton = context.session.document.skeleton();
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (!skeleton.node(node).is_end_site || skeleton.node(node).joint != joint) continue;
    inspector::heading(context, "End site");
    draw_offset(context, node);
  }
}

void JointPage::draw(ViewContext& context) {
  const JointIndex joint = context.session.selection.active_joint();
  const Skeleton& skeleton = context.session.document.skeleton();
  if (joint == kNoParent) {
    ImGui::SetCursorPos({inspector::kPadding, ImGui::GetCursorPosY() + 16.0f});
    ui::dim_text(context, "Select a joint to see its numbers.");
    return;
  }
  inspector::heading(context, skeleton.name(joint));
  inspector::text_row(context, "Parent", parent_name(skeleton, joint));
  const std::string order = euler_order_label(skeleton, joint);
  inspector::text_row(context, "Rotation order", order.empty() ? std::string_view("none") : order);
  if (context.session.document.motion().frame_count() > 0) {
    draw_channels(context, joint);
    draw_rotation(context, joint);
    draw_world_position(context, joint);
  }
  inspector::heading(context, "Offset");
  draw_offset(context, skeleton.node_of(joint));
  draw_end_sites(context, joint);
  ImGui::Dummy({0.0f, 16.0f});
}

}  // namespace marey::app
