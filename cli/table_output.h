#pragma once

#include <CLI/App.hpp>
#include <string>

#include "cli/exit_code.h"
#include "core/biomechanics/analysis.h"
#include "core/bvh/bvh_clip.h"

namespace marey::cli {

/// Writes the samples of all channels as CSV. With a unit of length the names carry units.
[[nodiscard]] ExitCode write_channel_table(const std::string& file, const BvhClip& clip, const std::string& length_unit);

/// Writes the world positions of all joints and end sites as CSV, in the same way.
[[nodiscard]] ExitCode write_position_table(const std::string& file, const BvhClip& clip, const std::string& length_unit);

/// Writes quantities as CSV.
[[nodiscard]] ExitCode write_analysis_table(const std::string& file, const AnalysisTable& table, double frame_time_s,
                                            int frame_count);

/// Adds --units to a command that writes a table.
void add_units(CLI::App& command, std::string& length_unit);

}  // namespace marey::cli
