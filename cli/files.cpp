#include "cli/files.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <system_error>

#include "cli/clip_json.h"
#include "cli/report.h"
#include "core/bvh/stream_reader.h"
#include "core/text/readable.h"

namespace marey::cli {
namespace {

constexpr std::size_t kBlockSize = std::size_t{1} << 16;

std::string reason_of(int error_number) { return std::generic_category().message(error_number); }

/// Gives `take` the bytes of a file block by block, until it wants no more. False if that failed, which has been reported.
template <class Take>
bool read_blocks(const std::string& file, Take take) {
  const bool is_standard = file == "-";
  std::error_code ignored;
  if (!is_standard && std::filesystem::is_directory(file, ignored)) {
    report_error(file, {}, "This is a folder, not a file.");
    return false;
  }
  std::FILE* stream = is_standard ? stdin : std::fopen(file.c_str(), "rb");
  if (stream == nullptr) {
    report_error(file, {}, fmt::format("The file cannot be opened: {}.", reason_of(errno)));
    return false;
  }
  std::array<char, kBlockSize> block;
  bool wants_more = true;
  while (wants_more) {
    const std::size_t count = std::fread(block.data(), 1, block.size(), stream);
    wants_more = count > 0 && take(std::string_view(block.data(), count));
  }
  const bool is_complete = std::ferror(stream) == 0;
  if (!is_complete) report_error(file, {}, fmt::format("The file cannot be read: {}.", reason_of(errno)));
  if (!is_standard) std::fclose(stream);
  return is_complete;
}

/// 0 where nobody knows.
std::int64_t size_of_file(const std::string& file) {
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(file, failure);
  return failure ? 0 : static_cast<std::int64_t>(size);
}

}  // namespace

std::optional<std::string> read_bytes(const std::string& file) {
  std::string bytes;
  const bool is_complete = read_blocks(file, [&](std::string_view block) {
    bytes += block;
    return true;
  });
  return is_complete ? std::optional(std::move(bytes)) : std::nullopt;
}

std::optional<BvhClip> read_clip(const Input& input) {
  StreamOptions stream;
  stream.expected_bytes = size_of_file(input.file);
  StreamReader reader({.strict = input.strict, .limits = input.limits, .names_in = input.names_in}, stream);
  if (!read_blocks(input.file, [&](std::string_view block) { return reader.feed(block); })) return std::nullopt;
  Result<BvhClip> clip = reader.finish();
  if (!clip) {
    if (input.as_json) (void)write_bytes("-", refusal_json(clip.error()));
    report_error(input.file, clip.error());
    return std::nullopt;
  }
  clip->diagnostics = readable(clip->diagnostics, clip->names_in);
  return std::move(*clip);
}

std::optional<BvhClip> read_clip_for_use(const Input& input) {
  std::optional<BvhClip> clip = read_clip(input);
  if (clip) report_diagnostics(input.file, clip->diagnostics, Severity::Error);
  return clip;
}

OutputFile::OutputFile(std::string file) : name_(std::move(file)), is_standard_(name_ == "-") {
  stream_ = is_standard_ ? stdout : std::fopen(name_.c_str(), "wb");
  if (is_standard_) name_ = "<stdout>";
  if (stream_ == nullptr) fail();
}

OutputFile::~OutputFile() {
  if (stream_ != nullptr && !is_standard_) std::fclose(stream_);
}

void OutputFile::write(std::string_view bytes) {
  if (wants_more() && std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size()) fail();
}

bool OutputFile::close() {
  if (wants_more() && std::fflush(stream_) != 0) fail();
  if (stream_ != nullptr && !is_standard_) {
    std::FILE* const closing = std::exchange(stream_, nullptr);
    if (std::fclose(closing) != 0 && !failed_) fail();
  }
  return !failed_ || reader_left_;
}

void OutputFile::fail() {
  failed_ = true;
  reader_left_ = errno == EPIPE || errno == ECONNRESET;
  if (!reader_left_) report_error(name_, {}, fmt::format("The file cannot be written: {}.", reason_of(errno)));
}

bool write_bytes(const std::string& file, std::string_view bytes) {
  OutputFile output(file);
  output.write(bytes);
  return output.close();
}

}  // namespace marey::cli
