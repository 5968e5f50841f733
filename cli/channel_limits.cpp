#include "cli/channel_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/json_text.h"

namespace marey::cli {
namespace {

using Json = nlohmann::json;

Error limits_error(std::string message) {
  return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}};
}

std::optional<std::string> unknown_key(const Json& object, std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) return key;
  }
  return std::nullopt;
}

Result<ChannelLimit> read_limit(const Json& entry, std::size_t number) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto refuse = [number](std::string_view reason) {
    return limits_error(fmt::format("Limit {} {}.", number, reason));
  };
  if (!entry.is_object()) return refuse("is not an object with channel, min and max");
  if (const auto key = unknown_key(entry, {"channel", "min", "max"})) {
    return refuse(fmt::format("has the key \"{}\"; channel, min and max are known", *key));
  }
  if (!entry.contains("channel") || !entry["channel"].is_string()) {
    return refuse("does not name a channel such as \"LeftKnee Xrotation\"");
  }
  if (!entry.contains("min") && !entry.contains("max")) return refuse("has neither min nor max");
  for (const char* side : {"min", "max"}) {
    const bool is_wrong = entry.contains(side) && !entry[side].is_number();
    if (is_wrong) return refuse(fmt::format("has a {} that is not a number", side));
  }
  const ChannelLimit limit{entry["channel"], entry.value("min", -kInfinity), entry.value("max", kInfinity)};
  if (limit.min > limit.max) return refuse("has a min above its max");
  return limit;
}

bool is_inside(double sample, const ChannelLimit& limit) { return sample >= limit.min && sample <= limit.max; }

bool is_worse(double sample, const Violation& violation) {
  if (std::isnan(violation.worst)) return false;
  return violation.is_above ? !(sample <= violation.worst) : !(sample >= violation.worst);
}

void append_violations(ChannelIndex channel, std::span<const double> samples, const ChannelLimit& limit,
                       std::vector<Violation>& out) {
  bool continues = false;
  for (FrameIndex frame = 0; frame < size_of(samples); ++frame) {
    const double sample = samples[idx(frame)];
    if (is_inside(sample, limit)) {
      continues = false;
      continue;
    }
    const bool is_above = !(sample < limit.min);
    if (!continues || out.back().is_above != is_above) {
      out.push_back({channel, {frame, 0}, is_above, is_above ? limit.max : limit.min, sample, frame});
    }
    continues = true;
    Violation& run = out.back();
    ++run.frames.count;
    if (is_worse(sample, run)) {
      run.worst = sample;
      run.worst_frame = frame;
    }
  }
}

}  // namespace

Result<std::vector<ChannelLimit>> read_limits(std::string_view json_text) {
  const Result<Json> json = parse_json<Json>(json_text, "The limits file");
  if (!json) return json.error();
  const bool has_list = json->is_object() && json->contains("limits") && (*json)["limits"].is_array();
  if (!has_list || json->size() != 1) return limits_error("The limits are not of the form {\"limits\": [...]}.");
  std::vector<ChannelLimit> limits;
  for (const Json& entry : (*json)["limits"]) {
    Result<ChannelLimit> limit = read_limit(entry, limits.size() + 1);
    if (!limit) return limit.error();
    limits.push_back(std::move(*limit));
  }
  return limits;
}

Result<std::vector<Violation>> find_violations(const Skeleton& skeleton, const Motion& motion,
                                               const std::vector<ChannelLimit>& limits) {
  std::vector<Violation> violations;
  for (const ChannelLimit& limit : limits) {
    bool is_known = false;
    for (ChannelIndex channel = 0; channel < skeleton.channel_count(); ++channel) {
      if (channel_label(skeleton, channel) != limit.channel) continue;
      is_known = true;
      append_violations(channel, motion.channel_samples(channel), limit, violations);
    }
    if (!is_known) return limits_error(fmt::format("The clip has no channel \"{}\".", limit.channel));
  }
  return violations;
}

std::string violation_sentence(const Skeleton& skeleton, const Violation& violation) {
  const FrameRange& frames = violation.frames;
  const std::string range = frames.count == 1 ? fmt::format("frame {}", frames.first + 1)
                                              : fmt::format("frames {}-{}", frames.first + 1, frames.end());
  return fmt::format("{} is {} {} in {}, at worst {} in frame {}", channel_label(skeleton, violation.channel),
                     violation.is_above ? "above" : "below", violation.limit, range, violation.worst,
                     violation.worst_frame + 1);
}

}  // namespace marey::cli
