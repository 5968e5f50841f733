#include "cli/files.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "cli/clip_json.h"
#include "cli/report.h"
#include "core/bvh/reader.h"
#include "core/text/readable.h"

namespace marey::cli {
namespace {

constexpr std::size_t kBlockSize = std::size_t{1} << 16;

std::string reason_of(int error_number) { return std::generic_category().message(error_number); }

/// Reads to the end; errno says what went wrong when it returns false.
bool read_to_end(std::FILE* stream, std::string& bytes) {
  std::array<char, kBlockSize> block;
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), stream)) bytes.append(block.data(), count);
  return std::ferror(stream) == 0;
}

}  // namespace

std::optional<std::string> read_bytes(const std::string& file) {
  const bool is_standard = file == "-";
  std::error_code ignored;
  if (!is_standard && std::filesystem::is_directory(file, ignored)) {
    report_error(file, {}, "This is a folder, not a file.");
    return std::nullopt;
  }
  std::FILE* stream = is_standard ? stdin : std::fopen(file.c_str(), "rb");
  if (stream == nullptr) {
    report_error(file, {}, fmt::format("The file cannot be opened: {}.", reason_of(errno)));
    return std::nullopt;
  }
  std::string bytes;
  const bool is_complete = read_to_end(stream, bytes);
  if (!is_complete) report_error(file, {}, fmt::format("The file cannot be read: {}.", reason_of(errno)));
  if (!is_standard) std::fclose(stream);
  return is_complete ? std::optional(std::move(bytes)) : std::nullopt;
}

std::optional<BvhClip> read_clip(const Input& input) {
  const std::optional<std::string> bytes = read_bytes(input.file);
  if (!bytes) return std::nullopt;
  Result<BvhClip> clip = read_bvh(*bytes, {.strict = input.strict, .limits = {}, .names_in = input.names_in});
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
