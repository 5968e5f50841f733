#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/number_text.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// A number that stands in a text, and what it was read as.
struct NumberSlot {
  std::size_t begin = 0;
  std::size_t length = 0;  ///< 0: the text does not hold this number
  double value = 0.0;
};

/// Everything before the first sample, byte for byte, with what it says. The writer repeats the text as long as it says
/// the right thing, exchanging only numbers that changed.
struct HeaderText {
  std::string text;  ///< empty: print the header anew
  Skeleton skeleton;
  std::vector<NumberSlot> offsets;  ///< three per node
  NumberSlot frame_count;
  NumberSlot frame_time;
};

/// How a header is printed anew.
struct HeaderStyle {
  std::string before;  ///< what stands above HIERARCHY: byte order mark, comments
  std::string line_end = "\n";
  std::string indent = "  ";  ///< per level
  NumberFormat offset_format;
};

/// One column of the rows: what stands before its number (in the first column the line end and indent), and how the
/// number is spelled.
struct ColumnStyle {
  std::string gap = " ";
  NumberFormat format;
};

/// A sample whose text is not what its column predicts. Its gap is always written, its number while the sample keeps its
/// value.
struct OddToken {
  std::int64_t index = 0;          ///< frame * channel count + channel
  double value = 0.0;              ///< the sample that this text stands for
  std::uint32_t begin = 0;         ///< of the gap, in MotionStyle::odd_text; it ends where the next token begins
  std::uint32_t number_begin = 0;  ///< end of the gap
};

/// How the rows are written.
struct MotionStyle {
  int frame_count = 0;               ///< of the file; with another one, every frame gets a line and no token is odd
  std::vector<ColumnStyle> columns;  ///< one per channel, or empty for the canonical form
  std::vector<OddToken> odd_tokens;  ///< by rising index; bounded, so a wildly mixed file loses its later ones
  std::string odd_text;
  std::string tail = "\n";  ///< everything behind the last sample
};

/// Gap and number of odd_tokens[i].
[[nodiscard]] std::string_view odd_token_text(const MotionStyle& style, std::size_t i);

/// Puts every frame into a line of its own, with decimal points and blanks between the numbers: for rows that no longer
/// are as they were read. Column gaps that do not fit are exchanged, odd tokens that do not fit dropped.
void give_each_frame_a_line(MotionStyle& style, const std::string& line_end);

/// The style of rows of which only some are left: `file_frames` holds, by frame, which of the style's frames each one is,
/// rising; others are new. What a frame's text has of its own moves with it.
[[nodiscard]] MotionStyle with_frames(const MotionStyle& style, std::span<const FrameIndex> file_frames);

enum class TextEncoding : std::uint8_t { Bytes, Utf16LittleEndian, Utf16BigEndian };

/// How a BVH text was written: learnt by the reader, used by the writer, so that a file saved without an edit comes
/// out byte for byte where its style is uniform. The defaults are the canonical form.
struct BvhStyle {
  TextEncoding encoding = TextEncoding::Bytes;
  HeaderText header_text;
  HeaderStyle header;
  MotionStyle motion;
};

}  // namespace marey
