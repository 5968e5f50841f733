#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/text_excerpt.h"
#include "core/bvh/reader.h"

namespace marey {

class StreamRows;

struct StreamOptions {
  /// Size of the file, 0 if nobody knows. It makes room for the samples, once and exactly.
  std::int64_t expected_bytes = 0;
  /// The text is looked at in steps of so many bytes, however it comes.
  std::size_t step_bytes = std::size_t{128} << 10;
};

/// Reads a BVH file piece by piece, as it comes. The clip is the one that read_bvh() makes of the whole text, but the text is
/// not held: rows like the first ones are read and forgotten, and so are others once what follows settles what they mean.
/// Held to the end are files that begin otherwise (UTF-16, commas between numbers, frames over several lines, a header that
/// is not understood), everything in strict mode, and the text from the first line on that is not ASCII or has a comma.
class StreamReader {
 public:
  explicit StreamReader(const ReadOptions& options = {}, const StreamOptions& stream = {});
  ~StreamReader();
  StreamReader(const StreamReader&) = delete;
  StreamReader& operator=(const StreamReader&) = delete;

  /// Takes the next bytes, any number of them. False once the file cannot be read, whatever follows; finish() says why.
  bool feed(std::string_view piece);

  /// Call once, when all bytes are fed. Errors: those of read_bvh().
  [[nodiscard]] Result<BvhClip> finish();
  /// After finish() gave a clip: the excerpt of each of its diagnostics.
  [[nodiscard]] std::vector<TextExcerpt> take_excerpts();

  /// Frames that are read so far.
  [[nodiscard]] int frame_count() const;
  /// 0 as long as no frames are read.
  [[nodiscard]] int channel_count() const;
  /// What is known before the end: the figure with its first frames, of which at most `most_samples` are copied, and without
  /// findings and style. Nothing until the first frames are read.
  [[nodiscard]] std::optional<BvhClip> clip_so_far(std::int64_t most_samples) const;
  /// Memory that is held, in bytes: text and samples.
  [[nodiscard]] std::int64_t held_bytes() const;

 private:
  void try_to_start();
  void check_memory();

  ReadOptions options_;
  StreamOptions stream_;
  std::string gathered_;              ///< the text, until rows_ takes it over
  std::size_t next_try_;              ///< size of gathered_ that is worth a try
  std::unique_ptr<StreamRows> rows_;  ///< once rows are read while they come
  std::optional<Error> error_;
  std::vector<TextExcerpt> excerpts_;
};

}  // namespace marey
