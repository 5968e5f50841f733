#include "wasm/app/file_reading.h"

#include "core/biomechanics/body_model_json.h"
#include "core/motion/resampling.h"
#include "core/table/csv_reader.h"
#include "wasm/app/json_reading.h"

namespace marey::app {
namespace {

BvhClip figure_of(const Document& document) {
  BvhClip figure;
  figure.skeleton = document.skeleton();
  // Channels without a column take their value from its first frame.
  const int frames = document.motion().frame_count() > 0 ? 1 : 0;
  figure.motion = trimmed(document.motion(), {0, frames});
  figure.style = document.style();
  figure.position_rule = document.settings().position_rule;
  figure.names_in = document.settings().names_in;
  return figure;
}

}  // namespace

bool is_table(std::string_view file_name) {
  constexpr std::string_view kExtension = ".csv";
  if (file_name.size() < kExtension.size()) return false;
  const std::string_view end = file_name.substr(file_name.size() - kExtension.size());
  for (std::size_t i = 0; i < end.size(); ++i) {
    const char lower = end[i] >= 'A' && end[i] <= 'Z' ? static_cast<char>(end[i] - 'A' + 'a') : end[i];
    if (lower != kExtension[i]) return false;
  }
  return true;
}

Result<BodyModel> read_opened_model(std::string_view bytes, const Skeleton& skeleton) {
  const Result<nlohmann::json> json = read_json(bytes);
  if (!json) {
    Error error = json.error();
    error.message = "This is not valid JSON, which a model of the body is.";
    return error;
  }
  return read_body_model(*json, skeleton);
}

Result<BvhClip> read_opened_table(std::string_view bytes, const Document* open_document) {
  Result<BvhClip> points = read_points_table(bytes);
  if (points || points.error().code != DiagnosticCode::TableKind) return points;
  if (open_document != nullptr) return read_channel_table(bytes, figure_of(*open_document));
  Error error = points.error();
  error.message += " Open that file first, then the table.";
  return error;
}

}  // namespace marey::app
