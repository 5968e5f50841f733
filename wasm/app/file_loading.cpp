#include "wasm/app/file_loading.h"

#include <algorithm>
#include <utility>

#include "wasm/app/file_reading.h"

namespace marey::app {
namespace {

/// 32 MB: copied within a frame.
constexpr std::int64_t kMostShownSamples = std::int64_t{4} << 20;

}  // namespace

FileLoading::FileLoading(std::string file_name, std::int64_t size, FileUse use)
    : file_name_(std::move(file_name)), size_(size), use_(use) {
  StreamOptions options;
  options.expected_bytes = size;
  if (use != FileUse::BodyModel && !is_table(file_name_)) reader_.emplace(ReadOptions{}, options);
}

bool FileLoading::feed(std::string_view bytes) {
  if (failure_) return false;
  fed_bytes_ += static_cast<std::int64_t>(bytes.size());
  if (reader_) return reader_->feed(bytes);
  text_ += bytes;
  return true;
}

void FileLoading::give_up(Error error) {
  reader_.reset();
  text_ = {};
  failure_ = std::move(error);
}

Result<BvhClip> FileLoading::finish(const Document* open_document) {
  if (failure_) return *failure_;
  return reader_ ? reader_->finish() : read_opened_table(text_, open_document);
}

Result<std::string> FileLoading::finish_text() {
  if (failure_) return *failure_;
  return std::move(text_);
}

std::vector<TextExcerpt> FileLoading::take_excerpts() {
  return reader_ ? reader_->take_excerpts() : std::vector<TextExcerpt>();
}

std::optional<BvhClip> FileLoading::take_news() {
  const std::int64_t read = reader_ ? reader_->frame_count() : 0;
  // Once as many are shown as may be, nothing is copied any more.
  const std::int64_t frames = read == 0 ? 0 : std::min(read, kMostShownSamples / reader_->channel_count());
  if (2 * frames < 3 * shown_frames_ + 2) return std::nullopt;
  std::optional<BvhClip> clip = reader_->clip_so_far(kMostShownSamples);
  if (!clip || clip->motion.frame_count() <= shown_frames_) return std::nullopt;
  shown_frames_ = clip->motion.frame_count();
  return clip;
}

}  // namespace marey::app
