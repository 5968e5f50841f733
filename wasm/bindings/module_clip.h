#pragma once

#include <string>
#include <vector>

#include "core/bvh/reader.h"
#include "core/bvh/save_options.h"
#include "core/bvh/writer.h"
#include "core/interchange/export.h"
#include "core/kinematics/forward_kinematics.h"
#include "core/kinematics/pose.h"

/// A clip that JavaScript holds by its address, and the memory of what it was last asked for.
struct ModuleClip {
  marey::BvhClip bvh;
  bool is_open = false;
  std::string text;
  std::string report;  ///< of the last export
  std::vector<double> numbers;  ///< of the last analysis
  std::vector<float> world_positions;
  marey::LocalPose local;
  marey::WorldPose world;
};

/// Makes a clip of what was read, with its description as its text; or leaves the error there.
void take_read(ModuleClip& clip, marey::Result<marey::BvhClip> read);

/// `decimals` and `line_end` (0 LF, 1 CR LF) below 0 leave things as they are.
[[nodiscard]] marey::SaveOptions save_options(int decimals, int line_end);

/// {"joints": [...], "nodeCount", "channelCount", "frameCount", "frameTime", "namesIn", "diagnostics": [...]} as JSON text.
[[nodiscard]] std::string describe_clip(const marey::BvhClip& bvh);

/// {"changes": [{"kind", "isLoss", "count", "message"}], "names": [{"joint", "before", "after"}], "largestMove"} as JSON
/// text.
[[nodiscard]] std::string describe_export(const marey::ExportedClip& clip);

/// {"code", "message", "line", "column"} as JSON text.
[[nodiscard]] std::string describe_error(const marey::Error& error);
