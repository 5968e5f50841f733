#include "core/base/byte_search.h"

#include <gtest/gtest.h>

#include <string>

namespace marey {
namespace {

TEST(ByteSearch, FindsTheFirstOfTwoBytesWhereverItStands) {
  for (std::size_t size = 0; size < 200; ++size) {
    EXPECT_EQ(find_either(std::string(size, ' '), ',', ';'), std::string::npos);
    for (std::size_t at = 0; at < size; ++at) {
      std::string text(size, ' ');
      text[at] = at % 2 == 0 ? ',' : ';';
      text.back() = ',';
      for (const std::size_t from : {std::size_t{0}, at / 2, at, at + 1}) {
        ASSERT_EQ(find_either(text, ',', ';', from), text.find_first_of(",;", from)) << size << " " << at << " " << from;
      }
    }
  }
}

TEST(ByteSearch, FindsTheFirstByteBeyondAscii) {
  for (std::size_t size = 1; size < 200; ++size) {
    std::string text(size, '\x7f');
    EXPECT_EQ(find_beyond_ascii(text), std::string::npos);
    for (std::size_t at = 0; at < size; ++at) {
      text.assign(size, 'a');
      text[at] = static_cast<char>(0x80 + at % 0x80);
      ASSERT_EQ(find_beyond_ascii(text), at);
      ASSERT_EQ(find_beyond_ascii(text, at + 1), std::string::npos);
    }
  }
  EXPECT_EQ(find_beyond_ascii("abc", 7), std::string::npos);
}

TEST(ByteSearch, FindsTheLastLineEnd) {
  for (std::size_t size = 0; size < 200; ++size) {
    EXPECT_EQ(find_last_line_end(std::string(size, ' ')), std::string::npos);
    for (std::size_t at = 0; at < size; ++at) {
      std::string text(size, ' ');
      text[0] = '\n';
      text[at] = at % 2 == 0 ? '\r' : '\n';
      ASSERT_EQ(find_last_line_end(text), text.find_last_of("\r\n")) << size << " " << at;
    }
  }
}

}  // namespace
}  // namespace marey
