#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace marey {

/// Programs with 32-bit addresses, such as WebAssembly ones, have 2 GiB for everything; the defaults leave room for what the
/// program needs besides.
inline constexpr bool kAddressesAre32Bit = sizeof(void*) == 4;
inline constexpr std::int64_t kGibibyte = std::int64_t{1} << 30;

/// What a file may ask for. Beyond a limit it is refused with the limit and the value in the message. Every count in a
/// file is also checked against the bytes that are left, so the limits only bound what honest bytes can cost.
struct ReadLimits {
  int max_joints = 10'000;         ///< end sites the same again, and so are blocks that no joint announces
  int max_depth = 2'000;           ///< nesting of joints
  int max_channels = 100'000;      ///< over all joints
  int max_frames = 10'000'000;
  /// Samples x 8 bytes, at any moment of the reading: while the store grows, the old one counts beside the new one.
  std::int64_t max_sample_bytes = kAddressesAre32Bit ? kGibibyte : 3 * kGibibyte;
  /// The text that is held, its conversion from UTF-16 if there is one, and the samples together.
  std::int64_t max_bytes = kAddressesAre32Bit ? kGibibyte * 3 / 2 : INT64_MAX;
};

/// Names for the command line and the JavaScript module: "joints", "depth", "channels", "frames", "sample_bytes", "bytes".
[[nodiscard]] std::vector<std::string_view> limit_names();
/// Sets one by its name. InvalidArgument: there is no such limit, or a value below 0 or too large for it.
[[nodiscard]] Status set_limit(ReadLimits& limits, std::string_view name, std::int64_t value);

}  // namespace marey
