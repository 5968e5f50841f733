#include "core/bvh/limits.h"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace marey {
namespace {

struct NamedLimit {
  std::string_view name;
  int ReadLimits::*count = nullptr;
  std::int64_t ReadLimits::*bytes = nullptr;
};

constexpr std::array kNamedLimits = {NamedLimit{"joints", &ReadLimits::max_joints, nullptr},
                                     NamedLimit{"depth", &ReadLimits::max_depth, nullptr},
                                     NamedLimit{"channels", &ReadLimits::max_channels, nullptr},
                                     NamedLimit{"frames", &ReadLimits::max_frames, nullptr},
                                     NamedLimit{"sample_bytes", nullptr, &ReadLimits::max_sample_bytes},
                                     NamedLimit{"bytes", nullptr, &ReadLimits::max_bytes}};

}  // namespace

std::vector<std::string_view> limit_names() {
  std::vector<std::string_view> names;
  for (const NamedLimit& limit : kNamedLimits) names.push_back(limit.name);
  return names;
}

Status set_limit(ReadLimits& limits, std::string_view name, std::int64_t value) {
  for (const NamedLimit& limit : kNamedLimits) {
    if (limit.name != name) continue;
    const std::int64_t most = limit.count != nullptr ? std::numeric_limits<int>::max() : std::numeric_limits<std::int64_t>::max();
    if (value < 0 || value > most) {
      return Error{DiagnosticCode::InvalidArgument, {}, fmt::format("The limit of {} is a whole number from 0 to {}.", name, most), "", ""};
    }
    if (limit.count != nullptr) limits.*limit.count = static_cast<int>(value);
    if (limit.bytes != nullptr) limits.*limit.bytes = value;
    return {};
  }
  return Error{DiagnosticCode::InvalidArgument, {}, fmt::format("There is no limit \"{}\", but {}.", name, fmt::join(limit_names(), ", ")),
               "", ""};
}

}  // namespace marey
