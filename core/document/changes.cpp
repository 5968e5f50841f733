#include "core/document/changes.h"

#include <fmt/format.h>

#include "core/base/counted.h"

namespace marey {
namespace {

std::string describe_samples(const Changes& changes) {
  const int first = changes.frames.first + 1;
  const int last = changes.frames.end();
  return counted(changes.samples, "sample") + " in " + counted(changes.channels, "channel") +
         (first == last ? fmt::format(", frame {}", first) : fmt::format(", frames {} to {}", first, last));
}

}  // namespace

std::string describe(const Changes& changes) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += text.empty() ? part : "; " + part; };
  if (changes.samples > 0) add(describe_samples(changes));
  if (changes.removed_frames > 0) add(counted(changes.removed_frames, "frame") + " left out");
  if (changes.added_frames > 0) add(counted(changes.added_frames, "frame") + " added");
  if (changes.figure) add("the figure");
  if (changes.offsets > 0) add(counted(changes.offsets, "offset"));
  if (changes.frame_time) add("the frame time");
  return text.empty() ? "nothing" : text;
}

}  // namespace marey
