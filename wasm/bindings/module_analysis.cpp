#include <emscripten/emscripten.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "core/biomechanics/analysis.h"
#include "core/biomechanics/body_guess.h"
#include "core/biomechanics/body_model_json.h"
#include "core/biomechanics/chosen_body.h"
#include "core/document/document.h"
#include "wasm/bindings/module_clip.h"

namespace {

using marey::Result;
using nlohmann::json;

marey::Error refusal(std::string message) { return {marey::DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

/// {"body": "rods", "mass": 70}; without "body" nothing.
Result<std::optional<marey::BodyModel>> read_table_body(const json& read, const marey::Clip& clip) {
  if (!read.contains("body")) return std::optional<marey::BodyModel>();
  const marey::BodyTable* table = marey::find_body_table(read.at("body").get<std::string>());
  if (table == nullptr) return refusal("The body is \"deleva-male\", \"deleva-female\", \"winter\" or \"rods\".");
  const double mass_kg = read.value("mass", marey::usual_mass_kg(*table));
  Result<marey::GuessedBody> body = marey::guess_body(clip.skeleton, *table, mass_kg, clip.settings.metres_per_unit);
  if (!body) return body.error();
  return std::optional(std::move(body->model));
}

/// {"quantities": [...], "model": {...} or "body": "rods" and "mass": 70, "support": "auto", "derivative": "central", "frameTime": 0.01,
/// "contacts": [{"joint": "LeftToe", "first": 10, "last": 20, "touches": false}]}; all but the first may be missing.
Result<marey::AnalysisRequest> read_request(std::string_view text, const marey::Clip& clip) {
  const json read = json::parse(text);  // it was made by JSON.stringify
  marey::AnalysisRequest request;
  for (const json& quantity : read.at("quantities")) request.quantities.push_back(quantity.get<std::string>());
  const marey::SupportKind* support = marey::find_support_kind(read.value("support", "auto"));
  if (support == nullptr) return refusal("The support is \"pivot\", \"flight\", \"ground\" or \"auto\".");
  request.support = *support;
  const Result<marey::Derivation> derivation = marey::parse_derivation(read.value("derivative", "central"));
  if (!derivation) return derivation.error();
  request.derivation = *derivation;
  for (const json& contact : read.value("contacts", json::array())) {
    const auto made = marey::make_own_contacts(clip.skeleton, contact.at("joint").get<std::string>(), contact.at("first").get<int>(),
                                               contact.at("last").get<int>(), contact.value("touches", true));
    if (!made) return made.error();
    request.contacts.insert(request.contacts.end(), made->begin(), made->end());
  }
  if (read.contains("frameTime")) request.frame_time_s = read.at("frameTime").get<double>();
  Result<std::optional<marey::BodyModel>> body = read_table_body(read, clip);
  if (!body) return body.error();
  request.model = std::move(*body);
  if (request.model || !read.contains("model")) return request;
  Result<marey::BodyModel> model = marey::read_body_model(read.at("model"), clip.skeleton);
  if (!model) return model.error();
  request.model = std::move(*model);
  return request;
}

Result<marey::AnalysisTable> analyse(const marey::Clip& clip, std::string_view request_text) {
  const Result<marey::AnalysisRequest> request = read_request(request_text, clip);
  if (!request) return request.error();
  return marey::analyse(clip, *request);
}

// Without a table the masses that the clip tells by itself.
Result<std::string> write_body(const marey::Clip& clip, std::string_view request_text) {
  const json read = json::parse(request_text);
  Result<std::optional<marey::BodyModel>> body = read_table_body(read, clip);
  if (!body) return body.error();
  if (*body) return marey::write_body_model(**body, clip.skeleton);
  marey::BodyChoice choice;
  if (read.contains("mass")) choice.mass_kg = read.at("mass").get<double>();
  const Result<marey::ChosenBody> chosen = marey::find_chosen_body(clip.skeleton, choice, clip.settings.metres_per_unit);
  if (!chosen) return chosen.error();
  return marey::write_body_model(chosen->body.model, clip.skeleton);
}

}  // namespace

extern "C" {

/// 1 with the model of a body as JSON as the clip's text; 0 with an error as JSON as its text.
EMSCRIPTEN_KEEPALIVE int marey_clip_body(ModuleClip* clip, const char* request, size_t request_size) {
  const Result<std::string> text = write_body(marey::make_clip(clip->bvh), std::string_view(request, request_size));
  clip->text = text ? *text : describe_error(text.error());
  return text ? 1 : 0;
}

/// 1 with {"names": [...], "notes": [...]} as the clip's text and the columns one behind the other as its numbers; 0 with an
/// error as JSON as its text.
EMSCRIPTEN_KEEPALIVE int marey_clip_analyse(ModuleClip* clip, const char* request, size_t request_size) {
  const Result<marey::AnalysisTable> table = analyse(marey::make_clip(clip->bvh), std::string_view(request, request_size));
  if (!table) {
    clip->text = describe_error(table.error());
    return 0;
  }
  json names = json::array();
  clip->numbers.clear();
  for (const marey::AnalysisColumn& column : table->columns) {
    names.push_back(column.name);
    clip->numbers.insert(clip->numbers.end(), column.values.begin(), column.values.end());
  }
  clip->text = json{{"names", std::move(names)}, {"notes", table->notes}}.dump(-1, ' ', false, json::error_handler_t::replace);
  return 1;
}

EMSCRIPTEN_KEEPALIVE const double* marey_clip_numbers(const ModuleClip* clip) { return clip->numbers.data(); }

}  // extern "C"
