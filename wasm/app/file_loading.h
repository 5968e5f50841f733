#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/text_excerpt.h"
#include "core/bvh/bvh_clip.h"
#include "core/bvh/stream_reader.h"
#include "core/document/document.h"
#include "wasm/app/file_use.h"

namespace marey::app {

/// A file on its way into the program: a BVH file is read while it comes, a table or a model once it is there.
class FileLoading {
 public:
  /// `size`: bytes of the file, 0 if nobody knows.
  FileLoading(std::string file_name, std::int64_t size, FileUse use);

  /// False once the file cannot be read; finish() says why.
  bool feed(std::string_view bytes);
  /// Reads no more and gives the memory back; finish() gives this error.
  void give_up(Error error);
  /// Call once, when all bytes are fed. `open_document` and errors: as in read_opened_table(), and those of read_bvh().
  [[nodiscard]] Result<BvhClip> finish(const Document* open_document);
  /// In place of finish(), of a model: all of its bytes.
  [[nodiscard]] Result<std::string> finish_text();
  /// After finish() gave a clip: of each of its diagnostics.
  [[nodiscard]] std::vector<TextExcerpt> take_excerpts();

  /// The figure and its first frames if they have become so many more that showing them is worth a copy.
  [[nodiscard]] std::optional<BvhClip> take_news();

  [[nodiscard]] const std::string& file_name() const { return file_name_; }
  [[nodiscard]] FileUse use() const { return use_; }
  [[nodiscard]] std::int64_t size() const { return size_; }
  [[nodiscard]] std::int64_t fed_bytes() const { return fed_bytes_; }
  /// A file that takes no longer is shown when it is there, without a word before.
  static constexpr double kPatience_s = 0.3;
  /// Time of the first frame that was drawn meanwhile, as Workspace::now_s.
  std::optional<double> begun_s;

 private:
  std::string file_name_;
  std::int64_t size_;
  FileUse use_;
  std::int64_t fed_bytes_ = 0;
  std::int64_t shown_frames_ = 0;
  std::optional<StreamReader> reader_;  ///< none for a table or a model
  std::string text_;
  std::optional<Error> failure_;
};

}  // namespace marey::app
