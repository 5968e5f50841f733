#pragma once

#include <string>
#include <vector>

#include "core/bvh/reader.h"
#include "core/bvh/save_options.h"
#include "core/bvh/writer.h"
#include "core/kinematics/forward_kinematics.h"

/// A clip that JavaScript holds by its address, and the memory of what it was last asked for.
struct ModuleClip {
  marey::BvhClip bvh;
  bool is_open = false;
  std::string text;
  std::vector<float> world_positions;
};

/// {"joints": [...], "nodeCount", "channelCount", "frameCount", "frameTime", "namesIn", "diagnostics": [...]} as JSON text.
[[nodiscard]] std::string describe_clip(const marey::BvhClip& bvh);

/// {"code", "message", "line", "column"} as JSON text.
[[nodiscard]] std::string describe_error(const marey::Error& error);
