#pragma once

#include <optional>
#include <string>
#include <vector>

namespace marey::test {

/// The bytes of a file; nothing if it cannot be read.
[[nodiscard]] std::optional<std::string> read_file(const std::string& path);

/// A file of this repository, by its path from the root. The test fails if it cannot be read.
[[nodiscard]] std::string read_repository_file(const std::string& path);

/// Folder with recorded files: the environment's MAREY_SHARED_DIR, else what the build was told; it may not exist.
[[nodiscard]] std::string shared_dir();

/// A file below shared_dir(), by its path from there.
[[nodiscard]] std::optional<std::string> read_shared_file(const std::string& path);

/// Paths from shared_dir() of the BVH files that its bvh/INDEX.tsv lists; empty when it is not there.
[[nodiscard]] std::vector<std::string> recorded_bvh_files();

}  // namespace marey::test
