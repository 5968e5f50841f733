#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/bvh/reader.h"
#include "core/bvh/writer.h"
#include "tests/support/same_bits.h"

namespace marey::test {

using Rows = std::vector<std::vector<double>>;

/// A root of three rotations with an End Site; nine lines, LF.
inline constexpr std::string_view kOneJoint =
    "HIERARCHY\n"
    "ROOT Hips\n"
    "{\n"
    "  OFFSET 0.0 0.0 0.0\n"
    "  CHANNELS 3 Zrotation Xrotation Yrotation\n"
    "  End Site\n"
    "  {\n"
    "    OFFSET 0.0 10.0 0.0\n"
    "  }\n"
    "}\n";

/// Lines of a joint "Chest" with three rotations at 0 5 0 and an End Site at 0 6 0, for file_with_lines().
inline constexpr std::string_view kChild =
    "  JOINT Chest\n  {\n    OFFSET 0 5 0\n    CHANNELS 3 Zrotation Xrotation Yrotation\n    End Site\n    {\n"
    "      OFFSET 0 6 0\n    }\n  }\n";

/// The values 1 to 9 as three rows.
[[nodiscard]] Rows three_rows();

/// kOneJoint with this motion section.
[[nodiscard]] std::string with_motion(std::string_view motion);

/// `text` with every `what` exchanged.
[[nodiscard]] std::string replaced(std::string text, std::string_view what, std::string_view by);

/// kOneJoint with `frames` declared and `rows` as its rows; the first row stands in line 14.
[[nodiscard]] std::string one_joint_file(std::string_view frames, std::string_view rows);

/// A file of one root "Hips" with six channels and one frame, whose block holds `lines` behind OFFSET and CHANNELS.
/// `channel_count` channels in all.
[[nodiscard]] std::string file_with_lines(std::string_view lines, int channel_count);

/// Reads a text that must be readable; an empty clip and a failed test otherwise.
[[nodiscard]] BvhClip read_or_fail(std::string_view text, const ReadOptions& options = {});

/// The refusal of a text that must be refused.
[[nodiscard]] Error refusal_of(std::string_view text, const ReadOptions& options = {});

[[nodiscard]] Rows rows_of(const BvhClip& clip);

[[nodiscard]] std::string written(const BvhClip& clip);

/// Expects a finding of this code, at this place unless the line is 0.
void expect_finding(const BvhClip& clip, DiagnosticCode code, TextPlace place = {}, int count = 1);

/// Expects three_rows(), no warnings, and the same bytes when written.
void expect_three_rows_silently(const std::string& text);

/// Expects no finding but notes.
void expect_no_warnings(const BvhClip& clip);

/// "3:5 warning bad_number x2: ..." for messages of tests.
[[nodiscard]] std::string listing(const BvhClip& clip);

/// Expects that writing the clip and reading the text gives the same numbers and the same tree, and that writing once
/// more gives the same text.
void expect_round_trip(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style);

}  // namespace marey::test
