#include "core/text/readable.h"

#include <gtest/gtest.h>

#include <array>

namespace marey {
namespace {

TEST(Readable, DecodesWhatFindingsQuote) {
  Diagnostics findings;
  findings.add({DiagnosticCode::DuplicateName, Severity::Note, {3, 1}, "'\xD0\xF3\xEA\xE0' is there twice.", "", "\xD0\xF3\xEA\xE0"});
  const Diagnostics shown = readable(findings, CharacterSet::Windows1251);
  ASSERT_EQ(shown.list().size(), 1u);
  EXPECT_EQ(shown.list()[0].message, "'Рука' is there twice.");
  EXPECT_EQ(shown.list()[0].found, "Рука");
  EXPECT_EQ(shown.list()[0].place, (TextPlace{3, 1}));
  EXPECT_EQ(readable(findings, CharacterSet::Utf8).list()[0].found, "\uFFFD\uFFFD\uFFFD\uFFFD");
}

TEST(Readable, MovesTheMarkOfAnExcerpt) {
  const std::array places = {TextPlace{2, 8}};
  const TextExcerpt bytes = make_excerpts("ROOT \xD2\xE0\xE7\nJOINT \xD0\xF3\xEA\xE0\n", places)[0];
  const TextExcerpt excerpt = readable(bytes, CharacterSet::Windows1251);
  EXPECT_EQ(excerpt.lines[0], "ROOT Таз");
  EXPECT_EQ(excerpt.lines[1], "JOINT Рука");
  EXPECT_EQ(excerpt.lines[1].substr(static_cast<std::size_t>(excerpt.marked_byte)), "ука");
  const std::array nowhere = {TextPlace{}};
  EXPECT_TRUE(readable(make_excerpts("a", nowhere)[0], CharacterSet::Gbk).lines.empty());
}

TEST(Readable, LongLinesAreCutBetweenLettersOfTwoBytes) {
  std::string line;
  while (line.size() < 300) line += "\x8D\xB6\x8E\x83 ";
  const std::array places = {TextPlace{1, 203}};
  const TextExcerpt excerpt = readable(make_excerpts(line, places)[0], CharacterSet::ShiftJis);
  EXPECT_EQ(excerpt.lines[0].find("\uFFFD"), std::string::npos) << excerpt.lines[0];
}

}  // namespace
}  // namespace marey
