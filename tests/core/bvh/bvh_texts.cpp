#include "tests/core/bvh/bvh_texts.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/index.h"

namespace marey::test {

Rows three_rows() { return {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}; }

std::string with_motion(std::string_view motion) { return std::string(kOneJoint) + std::string(motion); }

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string one_joint_file(std::string_view frames, std::string_view rows) {
  return fmt::format("{}MOTION\nFrames: {}\nFrame Time: 0.033333\n{}", kOneJoint, frames, rows);
}

std::string file_with_lines(std::string_view lines, int channel_count) {
  std::string text =
      "HIERARCHY\nROOT Hips\n{\n  OFFSET 0 0 0\n  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
      "Yrotation\n";
  text.append(lines).append("}\nMOTION\nFrames: 1\nFrame Time: 0.04\n");
  for (int i = 0; i < channel_count; ++i) text += fmt::format("{}{}", i > 0 ? " " : "", i + 1);
  return text + "\n";
}

BvhClip read_or_fail(std::string_view text, const ReadOptions& options) {
  Result<BvhClip> clip = read_bvh(text, options);
  if (clip) return std::move(*clip);
  const Error& error = clip.error();
  ADD_FAILURE() << "refused at " << error.place.line << ":" << error.place.column << ": " << error.message << "\n" << text;
  return {};
}

Error refusal_of(std::string_view text, const ReadOptions& options) {
  Result<BvhClip> clip = read_bvh(text, options);
  if (!clip) return clip.error();
  ADD_FAILURE() << "not refused:\n" << text.substr(0, 500) << "\n" << listing(*clip);
  return {};
}

Rows rows_of(const BvhClip& clip) {
  Rows rows(idx(clip.motion.frame_count()));
  for (FrameIndex frame = 0; frame < clip.motion.frame_count(); ++frame) {
    for (ChannelIndex c = 0; c < clip.motion.channel_count(); ++c) {
      rows[idx(frame)].push_back(clip.motion.sample(c, frame));
    }
  }
  return rows;
}

std::string written(const BvhClip& clip) { return write_bvh(clip.skeleton, clip.motion, clip.style); }

void expect_finding(const BvhClip& clip, DiagnosticCode code, TextPlace place, int count) {
  const Diagnostic* finding = clip.diagnostics.find(code);
  ASSERT_NE(finding, nullptr) << diagnostic_id(code) << " is missing in\n" << listing(clip);
  EXPECT_EQ(finding->count, count) << listing(clip);
  EXPECT_EQ(finding->severity, traits_of(code).severity);
  EXPECT_GT(finding->message.size(), 10U);
  EXPECT_EQ(finding->message.back(), '.');
  if (place.line == 0) return;
  EXPECT_EQ(finding->place, place) << listing(clip);
}

void expect_three_rows_silently(const std::string& text) {
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), three_rows()) << text;
  expect_no_warnings(clip);
  EXPECT_EQ(written(clip), text);
}

void expect_no_warnings(const BvhClip& clip) {
  EXPECT_EQ(clip.diagnostics.count(Severity::Warning) + clip.diagnostics.count(Severity::Error), 0) << listing(clip);
}

std::string listing(const BvhClip& clip) {
  std::string text;
  for (const Diagnostic& d : clip.diagnostics.list()) {
    text += fmt::format("{}:{} {} {} x{}: {}\n", d.place.line, d.place.column, severity_name(d.severity),
                        diagnostic_id(d.code), d.count, d.message);
  }
  return text;
}

void expect_round_trip(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style) {
  const std::string text = write_bvh(skeleton, motion, style);
  const Result<BvhClip> again = read_bvh(text);
  ASSERT_TRUE(again) << again.error().message << "\n" << text.substr(0, 2000);
  EXPECT_TRUE(same_numbers(skeleton, motion, again->skeleton, again->motion)) << text.substr(0, 2000);
  EXPECT_EQ(skeleton, again->skeleton);
  EXPECT_EQ(text, write_bvh(again->skeleton, again->motion, again->style));
}

}  // namespace marey::test
