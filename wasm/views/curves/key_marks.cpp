#include "wasm/views/curves/key_marks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/editing/key_edits.h"
#include "wasm/app/faults.h"
#include "wasm/views/curves/curve_lines.h"

namespace marey::app {
namespace {

constexpr float kMarkRadius = 4.5f;
constexpr float kHandleRadius = 3.0f;
constexpr float kReach = 9.0f;
constexpr float kLeastSpacing = 3.0f;

/// The keys of a channel as they stand in the graph.
struct ShownKeys {
  const KeyCurve* curve = nullptr;
  const ValueAxis* axis = nullptr;
  std::span<const double> samples;
  bool is_own = false;  // what is drawn is the curve of the keys itself

  explicit operator bool() const { return curve != nullptr; }
};

ShownKeys keys_of(const CurvesState& state, const Session& session, ChannelIndex channel) {
  const Clip& clip = session.document.clip();
  const SharedKeys keys = find_keys(clip.stack, session.active_layer, channel);
  if (!keys) return {};
  const bool is_own = session.active_layer == kOwnKeys && !clip.stack.beneath.contains(channel);
  return {keys.get(), &state.axis_of(clip.skeleton, channel), clip.motion.channel_samples(channel), is_own};
}

// On the curve that is shown, which for a layer is the result.
double shown_value(const ShownKeys& keys, const Key& key) {
  if (keys.is_own) return key.value;
  const double last = static_cast<double>(keys.samples.size()) - 1.0;
  const double frame = std::clamp(key.frame, 0.0, last);
  const auto before = static_cast<std::size_t>(frame);
  const std::size_t behind = std::min(before + 1, keys.samples.size() - 1);
  return std::lerp(keys.samples[before], keys.samples[behind], frame - std::floor(frame));
}

ImVec2 place_of(const ShownKeys& keys, const TimeWindow& time, const Key& key) {
  return {time.x_of(key.frame), keys.axis->y_of(shown_value(keys, key))};
}

ImVec2 place_of(const ShownKeys& keys, const TimeWindow& time, const Key& key, const Handle& handle) {
  return {time.x_of(key.frame + handle.frames), keys.axis->y_of(key.value + handle.value)};
}

bool has_handle(const KeyCurve& curve, int key, HandleSide side) {
  const int span = side == HandleSide::Left ? key - 1 : key;
  return span >= 0 && span + 1 < size_of(curve.keys) && curve.keys[idx(span)].interpolation == Interpolation::Bezier;
}

void draw_diamond(ImDrawList& list, ImVec2 at, float radius, ImU32 fill, ImU32 edge) {
  const ImVec2 corners[4] = {{at.x, at.y - radius}, {at.x + radius, at.y}, {at.x, at.y + radius}, {at.x - radius, at.y}};
  list.AddConvexPolyFilled(corners, 4, fill);
  list.AddPolyline(corners, 4, edge, ImDrawFlags_Closed, 1.0f);
}

void draw_handles(ViewContext& context, const ShownKeys& keys, int key, ImU32 color) {
  const Key& k = keys.curve->keys[idx(key)];
  const HandlePair pair = find_handles(*keys.curve, key);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const HandleSide side : {HandleSide::Left, HandleSide::Right}) {
    if (!has_handle(*keys.curve, key, side)) continue;
    const ImVec2 end = place_of(keys, context.time_window, k, side == HandleSide::Left ? pair.left : pair.right);
    list.AddLine(place_of(keys, context.time_window, k), end, color, 1.0f);
    list.AddCircleFilled(end, kHandleRadius, context.theme.panel, 12);
    list.AddCircle(end, kHandleRadius, color, 12, 1.5f);
  }
}

// The keys in sight, as positions [first, end).
std::array<int, 2> visible_keys(const KeyCurve& curve, const TimeWindow& time) {
  return {std::max(0, find_key_before(curve, time.first)), std::min(size_of(curve.keys), find_key_before(curve, time.last) + 2)};
}

void draw_keys(ViewContext& context, const CurvesState& state, ChannelIndex channel) {
  const ShownKeys keys = keys_of(state, context.session, channel);
  if (!keys || keys.samples.empty()) return;
  const KeyHit& hit = state.drag.kind == CurveDragKind::Key ? state.drag.grabbed_key : state.key_hit;
  const ImU32 color = curve_color(context, state, channel);
  const double cursor = context.session.playback.position();
  float last_x = -1e9f;
  const auto [first, end] = visible_keys(*keys.curve, context.time_window);
  for (int key = first; key < end; ++key) {
    const ImVec2 at = place_of(keys, context.time_window, keys.curve->keys[idx(key)]);
    const bool is_hit = hit.channel == channel && hit.key == key;
    if (!std::isfinite(at.y) || (!is_hit && at.x - last_x < kLeastSpacing)) continue;
    last_x = at.x;
    const bool is_here = std::abs(keys.curve->keys[idx(key)].frame - cursor) < 0.5;
    if (keys.is_own && (is_hit || is_here)) draw_handles(context, keys, key, is_hit ? context.theme.text : color);
    draw_diamond(*ImGui::GetWindowDrawList(), at, is_hit ? kMarkRadius + 1.5f : kMarkRadius,
                 is_hit ? context.theme.selection : color, context.theme.panel);
  }
}

float distance(ImVec2 a, ImVec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

// Handles can be grabbed where they are drawn: at the key that was hovered before, and at those under the cursor.
void consider_handles(KeyHit& best, float& reach, const ShownKeys& keys, const CurvesState& state, const TimeWindow& time,
                      ImVec2 point, ChannelIndex channel, int key, double cursor) {
  const bool was_hit = state.key_hit.channel == channel && state.key_hit.key == key;
  const Key& k = keys.curve->keys[idx(key)];
  if (!keys.is_own || (!was_hit && std::abs(k.frame - cursor) >= 0.5)) return;
  const HandlePair pair = find_handles(*keys.curve, key);
  for (const HandleSide side : {HandleSide::Left, HandleSide::Right}) {
    if (!has_handle(*keys.curve, key, side)) continue;
    const float gap = distance(place_of(keys, time, k, side == HandleSide::Left ? pair.left : pair.right), point);
    if (gap >= reach) continue;
    reach = gap;
    best = {channel, key, side == HandleSide::Left ? KeyPart::LeftHandle : KeyPart::RightHandle};
  }
}

Result<Edit> moved_key(const Clip& clip, const Session& session, const CurveDrag& drag, double frames, double value) {
  const KeyHit& hit = drag.grabbed_key;
  const SharedKeys keys = find_keys(clip.stack, session.active_layer, hit.channel);
  if (!keys || hit.key >= size_of(keys->keys)) return Edit{};
  const double at = keys->keys[idx(hit.key)].frame;
  const bool is_layered = clip.stack.beneath.contains(hit.channel);
  if (is_layered && frames == 0.0 && at == std::floor(at) && at >= 0.0 && at < clip.motion.frame_count()) {
    const auto frame = static_cast<FrameIndex>(at);
    return make_pose_key_edit(clip, "Move key", session.active_layer, frame,
                              {{hit.channel, clip.motion.sample(hit.channel, frame) + value}});
  }
  KeyCurve curve = *keys;
  const std::array<int, 1> moved{hit.key};
  move_keys(curve, moved, frames, value);
  return make_keys_edit(clip, "Move key", session.active_layer, {{hit.channel, std::move(curve)}});
}

Result<Edit> pulled_handle(const Clip& clip, const Session& session, const CurveDrag& drag, double frame, double value) {
  const KeyHit& hit = drag.grabbed_key;
  const SharedKeys keys = find_keys(clip.stack, session.active_layer, hit.channel);
  if (!keys || hit.key >= size_of(keys->keys)) return Edit{};
  KeyCurve curve = *keys;
  const Key& key = curve.keys[idx(hit.key)];
  const HandleSide side = hit.part == KeyPart::LeftHandle ? HandleSide::Left : HandleSide::Right;
  pull_handle(curve, hit.key, side, {frame - key.frame, value - key.value});
  return make_keys_edit(clip, "Pull handle", session.active_layer, {{hit.channel, std::move(curve)}});
}

}  // namespace

void draw_key_marks(ViewContext& context, const CurvesState& state) {
  const LayerStack& stack = context.session.document.clip().stack;
  if (stack.empty()) return;
  if (state.shown.size() > kMostCurvesInDetail) return;
  for (const ChannelIndex channel : state.shown) draw_keys(context, state, channel);
}

KeyHit find_key_hit(const CurvesState& state, const Session& session, const TimeWindow& time, ImVec2 point) {
  KeyHit best;
  float reach = kReach;
  if (session.document.clip().stack.empty() || state.shown.size() > kMostCurvesInDetail) return best;
  for (const ChannelIndex channel : state.shown) {
    const ShownKeys keys = keys_of(state, session, channel);
    if (!keys || keys.samples.empty()) continue;
    const auto [first, end] = visible_keys(*keys.curve, time);
    for (int key = first; key < end; ++key) {
      consider_handles(best, reach, keys, state, time, point, channel, key, session.playback.position());
      const float gap = distance(place_of(keys, time, keys.curve->keys[idx(key)]), point);
      if (gap >= reach) continue;
      reach = gap;
      best = {channel, key, KeyPart::Key};
    }
  }
  return best;
}

void drag_key(ViewContext& context, CurvesState& state) {
  CurveDrag& drag = state.drag;
  Session& session = context.session;
  if (drag.gesture == 0) drag.gesture = context.widgets.new_gesture();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ValueAxis& axis = state.axis_of(session.document.skeleton(), drag.grabbed_key.channel);
  const double value = axis.value_at(mouse.y) - axis.value_at(drag.start.y);
  double frames = context.time_window.frame_at(mouse.x) - context.time_window.frame_at(drag.start.x);
  if (drag.grabbed_key.part == KeyPart::Key && !ImGui::GetIO().KeyAlt) frames = std::round(frames);
  std::string refusal;
  const auto make_edit = [&](const Clip& clip) {
    Result<Edit> edit = drag.grabbed_key.part == KeyPart::Key
                            ? moved_key(clip, session, drag, frames, value)
                            : pulled_handle(clip, session, drag, context.time_window.frame_at(mouse.x), axis.value_at(mouse.y));
    if (edit) return std::move(*edit);
    refusal = edit.error().message;
    return Edit{};
  };
  const Status status = with_memory_for("this change", [&] { return session.apply_gesture(drag.gesture, make_edit); });
  if (!status) refusal = status.error().message;
  if (!refusal.empty()) context.refusal = refusal;
}

}  // namespace marey::app
