#pragma once

#include <cstdint>

namespace marey {

/// What a file may ask for. Beyond a limit it is refused with the limit and the value in the message. Every count in a
/// file is also checked against the bytes that are left, so the limits only bound what honest bytes can cost.
struct ReadLimits {
  int max_joints = 10'000;
  int max_depth = 2'000;           ///< nesting of joints
  int max_channels = 100'000;      ///< over all joints
  int max_frames = 10'000'000;
  std::int64_t max_sample_bytes = std::int64_t{3} << 30;  ///< samples x 8 bytes
};

}  // namespace marey
