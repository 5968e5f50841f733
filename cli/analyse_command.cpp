#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/json_text.h"
#include "cli/report.h"
#include "cli/table_output.h"
#include "core/biomechanics/asked_quantity.h"
#include "core/biomechanics/body_guess.h"
#include "core/biomechanics/body_model_json.h"
#include "core/biomechanics/chosen_body.h"
#include "core/biomechanics/plausibility.h"
#include "core/document/document.h"

namespace marey::cli {
namespace {

struct AnalyseOptions {
  Input input;
  std::vector<std::string> quantities;
  std::string model;
  std::string save_model;
  std::string body;                ///< find_body_table(); empty: none
  std::optional<double> mass_kg;
  std::string support = "auto";
  std::string derivative = "central";
  std::optional<double> frame_time_s;
  std::vector<std::string> contacts;     ///< "JOINT:FIRST:LAST", frames from 1
  std::vector<std::string> no_contacts;
  bool judges = false;
  std::string output = "-";
};

/// Adds the quantities of a list, apart by commas or blanks. What a joint is called may hold both: a text that is one
/// quantity as it stands is not taken apart.
void add_quantities(const std::string& list, const Skeleton& skeleton, std::vector<std::string>& quantities) {
  constexpr std::string_view kApart = ", \t";
  if (find_quantities(skeleton, std::span(&list, 1))) {
    quantities.push_back(list);
    return;
  }
  std::size_t at = list.find_first_not_of(kApart);
  while (at != std::string::npos) {
    const std::size_t end = std::min(list.find_first_of(kApart, at), list.size());
    quantities.push_back(list.substr(at, end - at));
    at = list.find_first_not_of(kApart, end);
  }
}

/// The model of a file; nothing if it cannot be read, which has been reported.
std::optional<BodyModel> read_model(const std::string& file, const Skeleton& skeleton) {
  const std::optional<std::string> text = read_bytes(file);
  if (!text) return std::nullopt;
  const auto json = parse_json<nlohmann::json>(*text, "The model");
  Result<BodyModel> model = json ? read_body_model(*json, skeleton) : Result<BodyModel>(json.error());
  if (model) return std::move(*model);
  report_error(file, model.error());
  return std::nullopt;
}

/// Masses by a table; nothing if the figure is none of its kind, which has been reported.
std::optional<BodyModel> make_body(const AnalyseOptions& options, const Clip& clip) {
  const BodyTable table = *find_body_table(options.body);
  const double mass_kg = options.mass_kg.value_or(usual_mass_kg(table));
  Result<GuessedBody> body = guess_body(clip.skeleton, table, mass_kg, clip.settings.metres_per_unit);
  if (!body) {
    report_error(options.input.file, body.error());
    return std::nullopt;
  }
  std::vector<std::string> parts;
  for (const GuessedPart& part : body->parts) {
    parts.push_back(fmt::format("{} {:.2f} kg on {}", part.name, part.mass_kg, clip.skeleton.name(part.joint)));
  }
  report_note(options.input.file, {}, fmt::format("Masses of {:g} kg: {}.", mass_kg, fmt::join(parts, ", ")));
  for (const std::string& note : body->notes) report_note(options.input.file, {}, note);
  return std::move(body->model);
}

/// Adds what is said of contacts; false if it cannot be understood, which has been reported. A joint's name may hold colons.
bool add_contacts(const std::vector<std::string>& texts, bool touches, const Skeleton& skeleton, std::vector<OwnContact>& contacts) {
  for (const std::string& text : texts) {
    const std::size_t last = text.rfind(':');
    const std::size_t first = last == 0 || last == std::string::npos ? std::string::npos : text.rfind(':', last - 1);
    const auto frame_at = [&](std::size_t begin, std::size_t end) {
      FrameIndex frame = 0;
      const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, frame);
      return error == std::errc() && stop == text.data() + end ? frame : 0;
    };
    const bool has_frames = first != std::string::npos && frame_at(first + 1, last) > 0 && frame_at(last + 1, text.size()) > 0;
    if (!has_frames) {
      report_usage_error(fmt::format("'{}' is no contact: write JOINT:FIRST:LAST, frames from 1.", text));
      return false;
    }
    const auto found = make_own_contacts(skeleton, std::string_view(text).substr(0, first), frame_at(first + 1, last) - 1,
                                         frame_at(last + 1, text.size()) - 1, touches);
    if (!found) {
      report_usage_error(found.error().message);
      return false;
    }
    contacts.insert(contacts.end(), found->begin(), found->end());
  }
  return true;
}

/// What is wanted; nothing if it cannot be understood, which has been reported.
std::optional<AnalysisRequest> make_request(const AnalyseOptions& options, const Clip& clip) {
  AnalysisRequest request;
  for (const std::string& list : options.quantities) add_quantities(list, clip.skeleton, request.quantities);
  request.support = *find_support_kind(options.support);
  request.frame_time_s = options.frame_time_s;
  const Result<Derivation> derivation = parse_derivation(options.derivative);
  if (!derivation) {
    report_usage_error(derivation.error().message);
    return std::nullopt;
  }
  request.derivation = *derivation;
  const bool understood = add_contacts(options.contacts, true, clip.skeleton, request.contacts) &&
                          add_contacts(options.no_contacts, false, clip.skeleton, request.contacts);
  if (!understood) return std::nullopt;
  if (!options.body.empty()) {
    request.model = make_body(options, clip);
    return request.model ? std::optional(std::move(request)) : std::nullopt;
  }
  if (options.model.empty()) return request;
  request.model = read_model(options.model, clip.skeleton);
  return request.model ? std::optional(std::move(request)) : std::nullopt;
}

/// Writes the masses as a model; false if that fails, which has been reported.
bool write_model(const AnalyseOptions& options, const Clip& clip, const BodyModel& model) {
  const Result<std::string> text = write_body_model(model, clip.skeleton);
  if (!text) {
    report_error(options.input.file, text.error());
    return false;
  }
  OutputFile file(options.save_model);
  file.write(*text);
  return file.close();
}

/// Says what speaks for or against unit, frame time and floor; false if that cannot be judged, which has been reported.
bool report_plausibility(const AnalyseOptions& options, const Clip& clip, const AnalysisRequest& request) {
  std::optional<BodyModel> model = request.model;
  if (!model) {
    Result<ChosenBody> body = find_chosen_body(clip);
    if (body) model = std::move(body->body.model);
    else report_error(options.input.file, body.error());
  }
  if (!model) return false;
  Clip judged = clip;
  if (request.frame_time_s) judged.motion.set_frame_time_s(*request.frame_time_s);
  judged.body.contacts = request.contacts;
  const Result<Plausibility> found = judge(judged, *model, request.derivation);
  if (!found) {
    report_error(options.input.file, found.error());
    return false;
  }
  for (const std::string& sentence : describe(*found, judged.motion.frame_time_s())) report_note(options.input.file, {}, sentence);
  return true;
}

/// What does not go together; "" where all does.
const char* find_contradiction(const AnalyseOptions& options) {
  if (options.quantities.empty() && !options.judges && options.save_model.empty()) return "Say what to write by -q, --judge, or --save-model.";
  if (options.save_model.empty()) return "";
  if (options.model.empty() && options.body.empty()) return "Say which masses --save-model is to write: --body, or --model.";
  const bool both = options.save_model == "-" && !options.quantities.empty() && options.output == "-";
  return both ? "Table and model cannot both go to standard output; give one of them a file." : "";
}

ExitCode run_analyse(const AnalyseOptions& options) {
  if (const char* problem = find_contradiction(options); *problem != '\0') {
    report_usage_error(problem);
    return ExitCode::BadInput;
  }
  std::optional<BvhClip> read = read_clip_for_use(options.input);
  if (!read) return ExitCode::BadInput;
  const Clip clip = make_clip(std::move(*read));
  const std::optional<AnalysisRequest> request = make_request(options, clip);
  if (!request) return ExitCode::BadInput;
  if (options.judges && !report_plausibility(options, clip, *request)) return ExitCode::BadInput;
  if (!options.save_model.empty() && !write_model(options, clip, *request->model)) return ExitCode::BadInput;
  if (options.quantities.empty()) return ExitCode::Done;
  const Result<AnalysisTable> table = analyse(clip, *request);
  if (!table) {
    report_error(options.input.file, table.error());
    return ExitCode::BadInput;
  }
  for (const std::string& note : table->notes) report_note(options.input.file, {}, note);
  return write_analysis_table(options.output, *table, request->frame_time_s.value_or(clip.motion.frame_time_s()),
                              clip.motion.frame_count());
}

std::string quantity_list() {
  std::string list;
  for (const Quantity& quantity : quantities()) {
    const bool of_joint = quantity.owner == QuantityOwner::Point || quantity.owner == QuantityOwner::Joint;
    list += fmt::format("{}{}{}", list.empty() ? "" : " ", quantity.name, of_joint ? ":J" : "");
  }
  return list;
}

}  // namespace

void add_analyse_command(CLI::App& program, ExitCode& exit_code) {
  const auto options = std::make_shared<AnalyseOptions>();
  CLI::App* command = program.add_subcommand("analyse", "Write quantities of kinematics and mechanics as CSV, in SI units");
  add_input(*command, options->input);
  command->add_option("-q,--quantities", options->quantities,
                      "What to write, apart by commas: " + quantity_list() + "; J is a joint, * is all; J+X/Y/Z is a point fixed to it, @FRAME behind it a frame of reference")
      ->expected(1)
      ->take_all();
  command->add_flag("--judge", options->judges, "Say what speaks for or against the unit of length, the frame time and the floor");
  command->add_option("--model", options->model, "JSON file with the masses of the segments; quantities with mass need it");
  command->add_option("--save-model", options->save_model, "JSON file to write with the masses that are used, as --model reads it");
  CLI::Option* body = command->add_option("--body", options->body, "Masses by a table, by the names of the joints and the lengths of the bones")
                          ->check(CLI::IsMember({"deleva-male", "deleva-female", "winter", "rods"}))
                          ->excludes("--model");
  command->add_option("--mass", options->mass_kg, "Mass of the body in kg, for --body")->check(CLI::Range(1e-3, 1e4))->needs(body);
  command->add_option("--support", options->support, "What holds the body")
      ->check(CLI::IsMember({"pivot", "flight", "ground", "auto"}))
      ->capture_default_str();
  command->add_option("--derivative", options->derivative, "central, butterworth:HZ, savgol:WINDOW,DEGREE, gcv, or spline:DEG,MM for a known noise")
      ->capture_default_str();
  command->add_option("--frame-time", options->frame_time_s, "Seconds per frame, in place of the file's")
      ->check(CLI::Range(1e-9, 1e9));
  command->add_option("--contact", options->contacts, "JOINT:FIRST:LAST, frames from 1: what hangs on the joint touches the floor in them")
      ->expected(1)
      ->take_all();
  command->add_option("--no-contact", options->no_contacts, "The same where it does not, whatever the motion tells")
      ->expected(1)
      ->take_all();
  command->add_option("-o,--output", options->output, "CSV file to write; standard output by default");
  command->callback([options, &exit_code] { exit_code = run_analyse(*options); });
}

}  // namespace marey::cli
