#include "core/bvh/stream_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/bvh/stream_rows.h"
#include "core/bvh/text_encoding.h"
#include "core/text/readable.h"

namespace marey {
namespace {

constexpr std::size_t kNever = SIZE_MAX;
/// A header that is not complete by then is read with the whole text.
constexpr std::size_t kLongestHeader = std::size_t{64} << 20;

/// The size that a caller expects, as far as the limits would let it be held.
std::size_t bounded_size(std::int64_t expected_bytes, const ReadLimits& limits) {
  return static_cast<std::size_t>(std::clamp<std::int64_t>(expected_bytes, 0, std::min(kGibibyte, limits.max_bytes)));
}

}  // namespace

StreamReader::StreamReader(const ReadOptions& options, const StreamOptions& stream)
    : options_(options), stream_(stream), next_try_(options.strict ? kNever : stream.step_bytes) {}

StreamReader::~StreamReader() = default;

bool StreamReader::feed(std::string_view piece) {
  while (!piece.empty() && !error_ && rows_ == nullptr) {
    const std::string_view taken = piece.substr(0, next_try_ - std::min(next_try_, gathered_.size()));
    gathered_.append(taken);
    piece.remove_prefix(taken.size());
    if (gathered_.size() >= next_try_) try_to_start();
    check_memory();
  }
  if (error_ || rows_ == nullptr) return !error_;
  rows_->feed(piece, stream_.step_bytes);
  if (rows_->report().failed()) error_ = rows_->report().error();
  check_memory();
  return !error_;
}

void StreamReader::try_to_start() {
  auto rows = std::make_unique<StreamRows>(std::move(gathered_), options_, stream_.expected_bytes);
  const StreamRows::Start start = rows->start();
  if (start == StreamRows::Start::Done) {
    rows_ = std::move(rows);
    if (rows_->report().failed()) error_ = rows_->report().error();
    return;
  }
  gathered_ = rows->take_head();
  const bool may_start = start == StreamRows::Start::NeedsMore && gathered_.size() < kLongestHeader;
  next_try_ = may_start ? 2 * gathered_.size() : kNever;
  // All of it comes to be held: doubling would take up to three times its size for a moment.
  if (!may_start) gathered_.reserve(bounded_size(stream_.expected_bytes, options_.limits));
}

void StreamReader::check_memory() {
  if (error_ || held_bytes() <= options_.limits.max_bytes) return;
  error_ = Error{DiagnosticCode::LimitMemory, {},
                 fmt::format("The file needs {} bytes of memory; the limit is {}. Split the file.", held_bytes(),
                             options_.limits.max_bytes),
                 "", ""};
}

Result<BvhClip> StreamReader::finish() {
  if (error_) return readable(*error_);
  if (rows_ == nullptr) {
    Result<BvhClip> clip = read_bvh(gathered_, options_);
    if (clip) {
      std::string converted;
      excerpts_ = make_excerpts(text_in_utf8(gathered_, converted), clip->diagnostics.places());
    }
    return clip;
  }
  BvhClip clip = rows_->finish();
  if (rows_->report().failed()) return readable(rows_->report().error());
  excerpts_ = rows_->find_excerpts(clip.diagnostics);
  return clip;
}

std::vector<TextExcerpt> StreamReader::take_excerpts() { return std::exchange(excerpts_, {}); }

int StreamReader::frame_count() const { return rows_ == nullptr ? 0 : static_cast<int>(rows_->frame_count()); }

int StreamReader::channel_count() const { return frame_count() == 0 ? 0 : rows_->channel_count(); }

std::optional<BvhClip> StreamReader::clip_so_far(std::int64_t most_samples) const {
  if (frame_count() == 0 || error_) return std::nullopt;
  return rows_->clip_so_far(most_samples);
}

std::int64_t StreamReader::held_bytes() const {
  return static_cast<std::int64_t>(gathered_.capacity()) + (rows_ == nullptr ? 0 : rows_->held_bytes());
}

}  // namespace marey
