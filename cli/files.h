#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "cli/input.h"
#include "core/bvh/bvh_clip.h"

namespace marey::cli {

/// All bytes of a file, "-" for standard input. Failure is reported.
[[nodiscard]] std::optional<std::string> read_bytes(const std::string& file);

/// The clip in a BVH file. Failure is reported, a refusal also as JSON where that is asked for; findings are not. They are
/// valid UTF-8.
[[nodiscard]] std::optional<BvhClip> read_clip(const Input& input);

/// The same for commands that go on with the clip: what could not be read, and is missing from it, is reported.
[[nodiscard]] std::optional<BvhClip> read_clip_for_use(const Input& input);

/// A file that is written piece by piece, "-" for standard output.
class OutputFile {
 public:
  explicit OutputFile(std::string file);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Does nothing once something has failed, or once nobody reads the pipe any more.
  void write(std::string_view bytes);
  /// True while it is of use to write more.
  [[nodiscard]] bool wants_more() const { return stream_ != nullptr && !failed_; }
  /// Writes what is left; false if the file is not complete, which has been reported. A reader that closed the pipe has
  /// had what it wanted.
  [[nodiscard]] bool close();

 private:
  void fail();

  std::string name_;
  std::FILE* stream_ = nullptr;
  bool is_standard_ = false;
  bool failed_ = false;
  bool reader_left_ = false;
};

/// Writes one text; false if that failed, which has been reported.
[[nodiscard]] bool write_bytes(const std::string& file, std::string_view bytes);

}  // namespace marey::cli
