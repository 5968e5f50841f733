#include "tests/support/files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace marey::test {

std::optional<std::string> read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return std::move(bytes).str();
}

std::string read_repository_file(const std::string& path) {
  const std::optional<std::string> bytes = read_file(std::string(MAREY_SOURCE_DIR) + "/" + path);
  EXPECT_TRUE(bytes.has_value()) << path << " cannot be read";
  return bytes.value_or("");
}

std::string shared_dir() {
  const char* from_environment = std::getenv("MAREY_SHARED_DIR");
  return from_environment != nullptr ? from_environment : MAREY_SHARED_DIR;
}

std::optional<std::string> read_shared_file(const std::string& path) { return read_file(shared_dir() + "/" + path); }

std::vector<std::string> recorded_bvh_files() {
  std::vector<std::string> paths;
  std::istringstream index(read_shared_file("bvh/INDEX.tsv").value_or(""));
  std::string line;
  while (std::getline(index, line)) {
    const std::string path = line.substr(0, line.find('\t'));
    if (path.rfind("bvh/", 0) == 0) paths.push_back(path);
  }
  return paths;
}

}  // namespace marey::test
