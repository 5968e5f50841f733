#include "core/biomechanics/body_model_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace marey {
namespace {

using Json = nlohmann::json;

Error model_error(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

/// As many numbers as wanted; nothing if the entry is something else.
template <std::size_t Count>
std::optional<std::array<double, Count>> read_numbers(const Json& entry) {
  if (!entry.is_array() || entry.size() != Count) return std::nullopt;
  std::array<double, Count> numbers{};
  for (std::size_t i = 0; i < Count; ++i) {
    if (!entry[i].is_number()) return std::nullopt;
    numbers[i] = entry[i].get<double>();
  }
  return numbers;
}

glm::dvec3 vector_of(const std::array<double, 3>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

JointIndex find_joint(const Skeleton& skeleton, const std::string& name) {
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (skeleton.name(joint) == name) return joint;
  }
  return kNoParent;
}

Result<Segment> read_segment(const Json& entry, const Skeleton& skeleton, std::size_t number) {
  const auto wrong = [&](std::string_view what) { return model_error(fmt::format("Segment {} of the model {}.", number, what)); };
  if (!entry.is_object() || !entry.contains("joint") || !entry["joint"].is_string()) return wrong("names no \"joint\"");
  const std::string name = entry["joint"];
  Segment segment;
  segment.joint = find_joint(skeleton, name);
  if (segment.joint == kNoParent) return wrong(fmt::format("hangs on a joint '{}', which the clip does not have", name));
  if (!entry.contains("mass_kg") || !entry["mass_kg"].is_number()) return wrong("has no number \"mass_kg\"");
  segment.mass_kg = entry["mass_kg"];
  const auto com = entry.contains("com_m") ? read_numbers<3>(entry["com_m"]) : std::nullopt;
  if (!com) return wrong("has no \"com_m\" of three numbers");
  segment.com_m = vector_of(*com);
  if (!entry.contains("inertia_kgm2")) return segment;
  const auto inertia = read_numbers<6>(entry["inertia_kgm2"]);
  if (!inertia) return wrong("has an \"inertia_kgm2\" that is not six numbers: Ixx, Iyy, Izz, Ixy, Ixz, Iyz");
  segment.inertia_kgm2 = symmetric_tensor(*inertia);
  return segment;
}

}  // namespace

Result<BodyModel> read_body_model(const Json& json, const Skeleton& skeleton) {
  if (!json.is_object() || !json.contains("segments") || !json["segments"].is_array()) {
    return model_error("The model is not an object with a list of \"segments\".");
  }
  BodyModel model;
  if (json.contains("metres_per_unit")) {
    if (!json["metres_per_unit"].is_number()) return model_error("\"metres_per_unit\" of the model is not a number.");
    model.metres_per_unit = json["metres_per_unit"].get<double>();
  }
  if (json.contains("gravity")) {
    const auto gravity = read_numbers<3>(json["gravity"]);
    if (!gravity) return model_error("\"gravity\" of the model is not three numbers, in metres per second squared.");
    model.gravity_mps2 = vector_of(*gravity);
  }
  for (const Json& entry : json["segments"]) {
    Result<Segment> segment = read_segment(entry, skeleton, model.segments.size() + 1);
    if (!segment) return segment.error();
    model.segments.push_back(*segment);
  }
  if (Status status = check_body_model(model, skeleton); !status) return status.error();
  return model;
}

Result<std::string> write_body_model(const BodyModel& model, const Skeleton& skeleton) {
  std::string text = "{";
  if (model.metres_per_unit) text += fmt::format("\n  \"metres_per_unit\": {},", *model.metres_per_unit);
  if (const auto& gravity = model.gravity_mps2) text += fmt::format("\n  \"gravity\": [{}, {}, {}],", gravity->x, gravity->y, gravity->z);
  text += "\n  \"segments\": [";
  for (std::size_t i = 0; i < model.segments.size(); ++i) {
    const Segment& segment = model.segments[i];
    const std::string& name = skeleton.name(segment.joint);
    if (find_joint(skeleton, name) != segment.joint) {
      return model_error(fmt::format("Two joints are named '{}', so a model cannot tell them apart. Rename one.", name));
    }
    const glm::dvec3& com = segment.com_m;
    const std::string quoted = Json(name).dump(-1, ' ', true, Json::error_handler_t::replace);
    text += fmt::format("{}\n    {{\"joint\": {}, \"mass_kg\": {}, \"com_m\": [{}, {}, {}], \"inertia_kgm2\": [{}]}}", i == 0 ? "" : ",", quoted,
                        segment.mass_kg, com.x, com.y, com.z, fmt::join(moments_of(segment.inertia_kgm2), ", "));
  }
  return text + "\n  ]\n}\n";
}

}  // namespace marey
