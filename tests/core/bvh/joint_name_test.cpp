#include "core/bvh/joint_name.h"

#include <gtest/gtest.h>

#include "tests/core/bvh/bvh_texts.h"
#include "tests/core/text/names.h"

namespace marey {
namespace {

std::string_view name_in(std::string_view text) {
  TextCursor cursor(text, 0);
  return take_joint_name(cursor);
}

std::vector<std::string> names_of(const BvhClip& clip) {
  std::vector<std::string> names;
  for (JointIndex joint = 0; joint < clip.skeleton.joint_count(); ++joint) names.push_back(clip.skeleton.name(joint));
  return names;
}

TEST(JointName, IsTheRestOfTheLineUpToABrace) {
  EXPECT_EQ(name_in(" Bip01 Neck\r\n{"), "Bip01 Neck");
  EXPECT_EQ(name_in(" head {"), "head");
  EXPECT_EQ(name_in(" head"), "head");
  EXPECT_EQ(name_in("   \n"), "");
  EXPECT_EQ(name_in(" {"), "");
}

TEST(JointName, KeepsBlanksAtTheEndOfTheLine) {
  EXPECT_EQ(name_in(" Hips \t\r\n{"), "Hips \t");
  EXPECT_EQ(name_in(" Hips \t{"), "Hips");
}

TEST(JointName, HoldsLettersWhoseSecondByteIsABrace) {
  EXPECT_EQ(name_in(" \x83\x7B\x81[\x83\x93\n{"), "\x83\x7B\x81[\x83\x93");  // ボーン
  EXPECT_EQ(name_in(" \x83J\x83}{ OFFSET"), "\x83J\x83}");                     // カマ
  EXPECT_EQ(name_in(" \x83\x7B {"), "\x83\x7B");
}

TEST(JointName, EndsAtABraceThatBeginsABlock) {
  EXPECT_EQ(name_in(" T\xEAte\xE9{ OFFSET 0 0 0"), "T\xEAte\xE9");
  EXPECT_EQ(name_in(" Рука{\nOFFSET 0 0 0"), "Рука");
}

TEST(JointName, CanBeReadBackAsItIsPrinted) {
  for (const std::string name : {"Hips", "Hips ", "a#b", "\x83\x7B\x81[\x83\x93", "\x83J\x83}", "T\xEAte", "Рука", "a/b|c"}) {
    EXPECT_EQ(printable_joint_name(name), name);
    const std::string line = " " + printable_joint_name(name) + "\n{\n  OFFSET";
    EXPECT_EQ(name_in(line), name);
  }
  EXPECT_EQ(printable_joint_name(" a{b}c\nd"), "a_b_c_d");
}

TEST(JointNames, AreShownInTheSetOfTheirLanguage) {
  for (const auto& [language, set, names] : test::names_of_languages()) {
    std::vector<std::string> bytes;
    for (const std::string& name : names) bytes.push_back(test::bytes_in(set, name));
    const BvhClip clip = test::read_or_fail(test::chain_file(bytes));
    EXPECT_EQ(names_of(clip), names) << language;
    EXPECT_EQ(clip.names_in, set) << language;
    const BvhClip utf8 = test::read_or_fail(test::chain_file(names));
    EXPECT_EQ(names_of(utf8), names) << language;
    EXPECT_FALSE(utf8.diagnostics.contains(DiagnosticCode::NamesNotUtf8)) << language;
  }
}

TEST(JointNames, KeepTheirBytesWhenASampleChanges) {
  for (const auto& [language, set, names] : test::names_of_languages()) {
    std::vector<std::string> bytes;
    for (const std::string& name : names) bytes.push_back(test::bytes_in(set, name) + " ");
    std::string text = test::chain_file(bytes);
    BvhClip clip = test::read_or_fail(text);
    EXPECT_EQ(test::written(clip), text) << language;
    clip.motion.channel_samples(0)[1] = 2.5;
    text.replace(text.rfind("1.50"), 4, "2.50");
    EXPECT_EQ(test::written(clip), text) << language;
  }
}

TEST(JointNames, KeepTheirBytesWhenTheHeaderIsPrintedAnew) {
  for (const auto& [language, set, names] : test::names_of_languages()) {
    std::vector<std::string> bytes;
    for (const std::string& name : names) bytes.push_back(test::bytes_in(set, name) + " ");
    BvhClip clip = test::read_or_fail(test::chain_file(bytes));
    clip.style.header_text = {};
    EXPECT_EQ(test::written(clip), test::chain_file(bytes)) << language;
  }
}

TEST(JointNames, SayWhatWasAssumed) {
  const std::string text = test::chain_file({"Hips", "H\xFC" "fte", "Knie"});
  const BvhClip clip = test::read_or_fail(text);
  test::expect_finding(clip, DiagnosticCode::NamesNotUtf8, {6, 3});
  const Diagnostic* finding = clip.diagnostics.find(DiagnosticCode::NamesNotUtf8);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->found, "Windows-1252");
  EXPECT_EQ(finding->severity, Severity::Note);
  EXPECT_TRUE(read_bvh(text, {.strict = true, .limits = {}}));
}

TEST(JointNames, AreReadInTheSetThatIsGiven) {
  ReadOptions options;
  options.names_in = CharacterSet::Windows1251;
  const BvhClip clip = test::read_or_fail(test::chain_file({"H\xFC" "fte"}), options);
  EXPECT_EQ(clip.skeleton.name(0), "Hьfte");
  EXPECT_FALSE(clip.diagnostics.contains(DiagnosticCode::NamesNotUtf8));
}

TEST(JointNames, OfARefusedFileAreReadable) {
  const std::string text = test::chain_file({"\xCB\xE5\xE2\xE0\xFF \xF0\xF3\xEA\xE0", "\xCB\xE5\xE2\xE0\xFF \xF0\xF3\xEA\xE0"}, "\xEF\xEB\xEE\xF5\xEE\xE5 ");
  const Error error = test::refusal_of(text, {.strict = true, .limits = {}});
  EXPECT_EQ(error.message, "'плохое' means nothing here and was left out.");
}

}  // namespace
}  // namespace marey
