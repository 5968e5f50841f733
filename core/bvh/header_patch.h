#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace marey {

/// Stands in a patch for the number of frames, which is known only once the rows are read.
inline constexpr char kFrameCountMark = '\x01';

/// Repairs of a header as edits of its text, so that the rest of it can stay as it was. '\n' in a replacement becomes
/// the line end of the file.
class HeaderPatches {
 public:
  void replace(std::size_t begin, std::size_t length, std::string text) { patches_.push_back({begin, length, std::move(text)}); }
  void insert(std::size_t at, std::string text) { replace(at, 0, std::move(text)); }
  /// Takes words out, with the blanks before them and with their line if nothing else stands in it.
  void remove(std::size_t begin, std::size_t length) { replace(begin, length, {}); }
  /// A repair that no such edit can express: the header has to be printed anew.
  void give_up() { is_local_ = false; }

  void append(const HeaderPatches& others);

  [[nodiscard]] bool empty() const { return patches_.empty() && is_local_; }
  /// False once the repairs have to be printed.
  [[nodiscard]] bool is_local() const { return is_local_; }
  /// `text` with the patches, which may come in any order; one that lies within another one is dropped.
  [[nodiscard]] std::string applied_to(std::string_view text, std::string_view line_end, std::int64_t frame_count) const;

 private:
  struct Patch {
    std::size_t begin = 0;
    std::size_t length = 0;
    std::string text;
  };
  [[nodiscard]] std::vector<Patch> merged(std::string_view text) const;

  std::vector<Patch> patches_;
  bool is_local_ = true;
};

/// `depth` times `indent`, but at most 256 bytes: deeper lines are indented no further, so that a deep tree does not take
/// memory by the square of its depth.
[[nodiscard]] std::string indent_at(std::string_view indent, std::size_t depth);

/// The blanks before text[place] in its line, if only blanks stand there; else one blank.
[[nodiscard]] std::string indent_before(std::string_view text, std::size_t place);

}  // namespace marey
