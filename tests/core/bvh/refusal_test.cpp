// What no reader can make sense of is refused, with a place and a sentence that says what to do.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

struct Refusal {
  std::string text;
  Code code;
  TextPlace place;
};

TEST(Refusal, TextsWithoutAFigure) {
  const std::vector<Refusal> cases = {
      {"", Code::EmptyFile, {1, 1}},
      {" \r\n\t\n", Code::EmptyFile, {1, 1}},
      {std::string(500, '\0'), Code::EmptyFile, {1, 1}},
      {"\xef\xbb\xbf", Code::EmptyFile, {1, 1}},
      {"\xff\xfe", Code::EmptyFile, {1, 1}},
      {std::string("H\0I\0", 4), Code::UnsupportedEncoding, {1, 1}},
      {std::string("\0H\0I", 4), Code::UnsupportedEncoding, {1, 1}},
      {"hello world", Code::NotBvh, {1, 1}},
      {"\n\n  <html>", Code::NotBvh, {3, 3}},
      {"{ }", Code::NotBvh, {1, 1}},
      {"\x89PNG\r\n\x1a\n", Code::NotBvh, {1, 1}},
      {"1 2 3\n4 5 6\n", Code::NotBvh, {1, 1}},
      {"HIERARCHY\n", Code::MissingRoot, {2, 1}},
      {"HIERARCHY\nMOTION\nFrames: 1\nFrame Time: 1\n1\n", Code::MissingRoot, {2, 1}},
      {"MOTION\nFrames: 1\nFrame Time: 1\n1\n", Code::MissingRoot, {1, 1}},
  };
  for (const Refusal& refusal : cases) {
    const Error error = refusal_of(refusal.text);
    EXPECT_EQ(error.code, refusal.code) << refusal.text << "\n" << error.message;
    EXPECT_EQ(error.place, refusal.place) << refusal.text << "\n" << error.message;
    EXPECT_GT(error.message.size(), 15U);
    EXPECT_EQ(error.message.back(), '.');
    EXPECT_FALSE(error.expected.empty());
  }
}

}  // namespace
}  // namespace marey
