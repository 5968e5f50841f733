#pragma once

#include <cstdint>
#include <string_view>

#include "tests/fuzz/target.h"

namespace marey::test {

/// Reads texts that may be anything, looks for harm, and keeps a hash of all that came out, by which native code and
/// WebAssembly are compared: code and place of refusals; samples, names, findings and written bytes of clips.
class Verdict {
 public:
  /// Reads `text`, leniently and strictly. What is wrong, if anything, also when it takes more memory than
  /// most_bytes().
  Harm take(std::string_view text);

  [[nodiscard]] std::uint64_t hash() const { return hash_; }
  [[nodiscard]] int texts() const { return texts_; }
  [[nodiscard]] int refused() const { return refused_; }

 private:
  Harm take(std::string_view text, bool strict);
  void add(std::string_view bytes);
  template <class T>
  void add_value(const T& value);

  std::uint64_t hash_ = 14695981039346656037U;  // FNV-1a
  int texts_ = 0;
  int refused_ = 0;
};

/// The memory that reading a file may take, text included: see docs/limits.md.
[[nodiscard]] constexpr std::size_t most_bytes(std::size_t file_size) { return 65'536 + 256 * file_size; }

}  // namespace marey::test
