#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/counted.h"
#include "core/editing/key_edits.h"
#include "core/editing/key_making.h"
#include "core/editing/operations/families.h"
#include "core/editing/operations/layer_choice.h"
#include "core/motion/key_curve_edits.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;
using Curves = std::map<ChannelIndex, KeyCurve>;

Outcome with_edit(Result<Edit> edit) {
  if (!edit) return edit.error();
  OperationOutcome outcome;
  outcome.edit = std::move(*edit);
  return outcome;
}

std::string named(const OperationCall& call) {
  const std::vector<ChannelIndex>& channels = call.target.channels;
  if (channels.size() == 1) {
    return fmt::format("{} {}", call.operation.label, channel_label(call.clip.skeleton, channels.front()));
  }
  return fmt::format("{} {}", call.operation.label, counted(size_of(channels), "channel"));
}

constexpr std::string_view kInterpolations[] = {"bezier", "linear", "stepped"};
constexpr Interpolation kInterpolationOf[] = {Interpolation::Bezier, Interpolation::Linear, Interpolation::Stepped};

Interpolation asked_interpolation(const OperationCall& call) {
  return kInterpolationOf[static_cast<std::size_t>(call.number("interpolation"))];
}

Outcome make_to_keys(const OperationCall& call) {
  const ToleranceOf of = call.choice("measure") == "tips" ? ToleranceOf::Tips : ToleranceOf::Value;
  Curves curves = make_keys(call.clip, call.target.channels, {call.number("tolerance"), of, asked_interpolation(call)});
  if (curves.empty()) return OperationOutcome{};
  std::vector<std::string> notes{describe_keys(call.clip, curves)};
  Outcome outcome = with_edit(make_keys_edit(call.clip, named(call), kOwnKeys, std::move(curves)));
  if (outcome) outcome->notes = std::move(notes);
  return outcome;
}

Outcome make_to_samples(const OperationCall& call) {
  Curves none;
  for (const ChannelIndex channel : call.target.channels) none[channel] = {};
  return with_edit(make_keys_edit(call.clip, named(call), kOwnKeys, std::move(none)));
}

Outcome make_key(const OperationCall& call) {
  const Result<int> layer = choose_keys(call);
  if (!layer) return layer.error();
  const double frame = call.number("frame");
  if (call.choice("of") == "result") {
    ChannelValues wanted;
    for (const ChannelIndex channel : call.target.channels) wanted[channel] = call.number("value");
    if (wanted.empty()) return OperationOutcome{};
    return with_edit(make_pose_key_edit(call.clip, named(call), *layer, static_cast<FrameIndex>(frame), wanted));
  }
  Curves curves;
  for (const ChannelIndex channel : call.target.channels) {
    const SharedKeys keys = find_keys(call.clip.stack, *layer, channel);
    if (!keys && *layer == kOwnKeys) continue;
    KeyCurve curve = keys ? *keys : KeyCurve{};
    set_key(curve, frame, call.number("value"));
    curves[channel] = std::move(curve);
  }
  return with_edit(make_keys_edit(call.clip, named(call), *layer, std::move(curves)));
}

// Changes the keys that the target's channels have.
template <class Change>
Outcome change_keys(const OperationCall& call, Change change) {
  const Result<int> layer = choose_keys(call);
  if (!layer) return layer.error();
  Curves curves;
  for (const ChannelIndex channel : call.target.channels) {
    const SharedKeys keys = find_keys(call.clip.stack, *layer, channel);
    if (!keys) continue;
    KeyCurve curve = *keys;
    change(curve);
    if (!(curve == *keys)) curves[channel] = std::move(curve);
  }
  return with_edit(make_keys_edit(call.clip, named(call), *layer, std::move(curves)));
}

// Keys before the first and behind the last frame belong to a target that reaches so far.
struct TimeSpan {
  double first;
  double last;
};

TimeSpan asked_times(const OperationCall& call) {
  const FrameRange frames = call.target.frames;
  const bool is_all = frames.first == 0 && frames.count == call.clip.motion.frame_count();
  return is_all ? TimeSpan{-HUGE_VAL, HUGE_VAL} : TimeSpan{static_cast<double>(frames.first), frames.end() - 1.0};
}

Outcome make_key_insert(const OperationCall& call) {
  return change_keys(call, [&](KeyCurve& curve) { insert_key(curve, call.number("frame")); });
}

Outcome make_key_delete(const OperationCall& call) {
  const TimeSpan times = asked_times(call);
  return change_keys(call, [times](KeyCurve& curve) { delete_keys(curve, times.first, times.last); });
}

Outcome make_key_move(const OperationCall& call) {
  const TimeSpan times = asked_times(call);
  return change_keys(call, [&](KeyCurve& curve) {
    std::vector<int> moved;
    for (int key = 0; key < size_of(curve.keys); ++key) {
      const double frame = curve.keys[idx(key)].frame;
      if (frame >= times.first - kSameKeyFrames && frame <= times.last + kSameKeyFrames) moved.push_back(key);
    }
    move_keys(curve, moved, call.number("by"), call.number("value"));
  });
}

Outcome make_key_interpolation(const OperationCall& call) {
  const TimeSpan times = asked_times(call);
  return change_keys(call, [&](KeyCurve& curve) { set_interpolation(curve, times.first, times.last, asked_interpolation(call)); });
}

Outcome make_key_handles(const OperationCall& call) {
  const TimeSpan times = asked_times(call);
  const auto kind = static_cast<HandleKind>(call.whole("kind"));
  return change_keys(call, [&](KeyCurve& curve) { set_handle_kinds(curve, times.first, times.last, kind); });
}

Outcome make_key_extrapolation(const OperationCall& call) {
  return change_keys(call, [&](KeyCurve& curve) {
    curve.before = static_cast<Extrapolation>(call.whole("before"));
    curve.behind = static_cast<Extrapolation>(call.whole("behind"));
  });
}

constexpr double kFarFrames = 1e6;
constexpr double kFarValue = 1e9;
constexpr std::string_view kMeasures[] = {"value", "tips"};
constexpr std::string_view kOf[] = {"result", "layer"};
constexpr std::string_view kKinds[] = {"auto", "auto-clamped", "aligned", "free", "flat", "linear"};  // as HandleKind
constexpr std::string_view kBeyond[] = {"hold", "linear", "cycle", "cycle-offset", "oscillate"};       // as Extrapolation
constexpr OperationParameter kLayer{.name = "layer", .label = "Layer",
                                    .help = "Its name or number; without one the keys of the channels themselves.",
                                    .kind = ParameterKind::Text};
constexpr OperationParameter kFrame{.name = "frame", .label = "Frame", .help = "Where the key lies.",
                                    .kind = ParameterKind::Frame, .most = 1e9};
constexpr OperationParameter kInterpolation{.name = "interpolation", .label = "Interpolation",
                                            .help = "How the curve runs from one key to the next.",
                                            .kind = ParameterKind::Choice, .most = 2.0, .choices = kInterpolations};
constexpr OperationParameter kToKeys[] = {
    {.name = "tolerance", .label = "Tolerance", .unit = "degrees or file units",
     .help = "How far the curves may go from the samples; 0 loses nothing.", .initial = 0.5, .most = 1e6},
    {.name = "measure", .label = "Measured", .help = "By the value of each curve, or by how far any point of the figure moves.",
     .kind = ParameterKind::Choice, .most = 1.0, .choices = kMeasures},
    kInterpolation};
constexpr OperationParameter kKey[] = {
    kLayer, kFrame,
    {.name = "value", .label = "Value", .unit = "degrees or file units", .help = "What the channels have there.",
     .least = -kFarValue, .most = kFarValue},
    {.name = "of", .label = "Of", .help = "Whether the value is that of the result, or of the layer's own curve.",
     .kind = ParameterKind::Choice, .most = 1.0, .choices = kOf}};
constexpr OperationParameter kInsert[] = {kLayer, kFrame};
constexpr OperationParameter kOnly[] = {kLayer};
constexpr OperationParameter kMove[] = {
    kLayer,
    {.name = "by", .label = "By", .unit = "frames", .help = "How far the keys move in time.", .least = -kFarFrames, .most = kFarFrames},
    {.name = "value", .label = "Value", .unit = "degrees or file units", .help = "How far they move up.", .least = -kFarValue,
     .most = kFarValue}};
constexpr OperationParameter kShape[] = {kLayer, kInterpolation};
constexpr OperationParameter kHandles[] = {
    kLayer, {.name = "kind", .label = "Handles", .help = "Where the handles come from.", .kind = ParameterKind::Choice,
             .initial = 1.0, .most = 5.0, .choices = kKinds}};
constexpr OperationParameter kExtrapolation[] = {
    kLayer,
    {.name = "before", .label = "Before", .help = "What the curve does before its first key.", .kind = ParameterKind::Choice,
     .most = 4.0, .choices = kBeyond},
    {.name = "behind", .label = "Behind", .help = "What it does behind its last key.", .kind = ParameterKind::Choice,
     .most = 4.0, .choices = kBeyond}};

constexpr Operation kKeys[] = {
    {.id = "to-keys", .label = "Samples to keys", .group = "Keys", .help = "Gives whole channels as few keys as the tolerance allows.",
     .reach = OperationReach::Keys, .parameters = kToKeys, .make = make_to_keys},
    {.id = "to-samples", .label = "Keys to samples", .group = "Keys", .help = "Lets the keys of channels go; the samples stay.",
     .reach = OperationReach::Keys, .make = make_to_samples},
    {.id = "key", .label = "Set key", .group = "Keys", .help = "Sets a key in the channels.", .reach = OperationReach::Keys,
     .parameters = kKey, .make = make_key},
    {.id = "key-insert", .label = "Insert key", .group = "Keys", .help = "Puts a key on curves of keys without changing their shape.",
     .reach = OperationReach::Keys, .parameters = kInsert, .make = make_key_insert},
    {.id = "key-delete", .label = "Delete keys", .group = "Keys", .help = "Takes the keys of the range away.",
     .reach = OperationReach::Keys, .parameters = kOnly, .make = make_key_delete},
    {.id = "key-move", .label = "Move keys", .group = "Keys", .help = "Moves the keys of the range in time and value.",
     .reach = OperationReach::Keys, .parameters = kMove, .make = make_key_move},
    {.id = "key-interpolation", .label = "Interpolation of keys", .group = "Keys", .help = "Sets how the curve runs behind the keys of the range.",
     .reach = OperationReach::Keys, .parameters = kShape, .make = make_key_interpolation},
    {.id = "key-handles", .label = "Handles of keys", .group = "Keys", .help = "Sets where the handles of the keys of the range come from.",
     .reach = OperationReach::Keys, .parameters = kHandles, .make = make_key_handles},
    {.id = "key-extrapolation", .label = "Beyond the keys", .group = "Keys",
     .help = "Sets what curves do before their first and behind their last key.", .reach = OperationReach::Keys,
     .parameters = kExtrapolation, .make = make_key_extrapolation}};

}  // namespace

std::span<const Operation> key_operations() { return kKeys; }

}  // namespace marey
