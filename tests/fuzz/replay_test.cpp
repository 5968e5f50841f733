// Gives each target of the fuzzer what its committed corpus holds: found defects, and texts that reach much of the code.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "tests/fuzz/target.h"
#include "tests/support/files.h"

namespace marey::test {
namespace {

std::vector<std::string> corpus_of(const FuzzTarget& target) {
  std::vector<std::string> paths;
  const std::filesystem::path folder = std::filesystem::path(MAREY_SOURCE_DIR) / "tests/fuzz/corpus" / target.name;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

void replay(const FuzzTarget& target) {
  constexpr std::size_t kLeastFiles = 5;
  const std::vector<std::string> paths = corpus_of(target);
  ASSERT_GE(paths.size(), kLeastFiles);
  std::size_t bytes = 0;
  for (const std::string& path : paths) {
    const std::string input = read_file(path).value();
    bytes += input.size();
    EXPECT_EQ(target.find_harm(input).value_or(""), "") << path;
  }
  EXPECT_EQ(target.find_harm("").value_or(""), "");
  std::cout << paths.size() << " files with " << bytes << " bytes given to the target " << target.name << "\n";
}

class Corpus : public testing::TestWithParam<FuzzTarget> {};

TEST_P(Corpus, DoesNoHarm) { replay(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(kFuzzTargets),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace marey::test
