#include "cli/clip_json.h"

#include <nlohmann/json.hpp>

#include "core/document/document.h"

namespace marey::cli {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const glm::dvec3& vector) { return {vector.x, vector.y, vector.z}; }

Json joint_json(const Skeleton& skeleton, JointIndex joint) {
  Json channels = Json::array();
  for (const Channel& channel : skeleton.channels(joint)) {
    const bool is_known = channel.kind != ChannelKind::Other;
    channels.push_back(is_known ? std::string(channel_keyword(channel.kind)) : channel.other_name);
  }
  return {{"name", skeleton.name(joint)},
          {"parent", skeleton.parent(joint)},
          {"offset", vector_json(skeleton.offset(joint))},
          {"channels", std::move(channels)}};
}

Json joints_json(const Skeleton& skeleton) {
  Json joints = Json::array();
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) joints.push_back(joint_json(skeleton, joint));
  for (const Node& node : skeleton.nodes()) {
    Json& joint = joints[idx(node.joint)];
    if (node.is_end_site && !joint.contains("end_site")) joint["end_site"] = vector_json(node.offset);
  }
  return joints;
}

Json diagnostics_json(const Diagnostics& diagnostics) {
  Json list = Json::array();
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    list.push_back({{"severity", severity_name(diagnostic.severity)},
                    {"code", diagnostic_id(diagnostic.code)},
                    {"line", diagnostic.place.line},
                    {"column", diagnostic.place.column},
                    {"message", diagnostic.message},
                    {"count", diagnostic.count}});
  }
  return list;
}

Json violation_json(const Skeleton& skeleton, const Violation& violation) {
  return {{"channel", channel_label(skeleton, violation.channel)},
          {"first_frame", violation.frames.first + 1},
          {"last_frame", violation.frames.end()},
          {"side", violation.is_above ? "above" : "below"},
          {"limit", violation.limit},
          {"worst", violation.worst},
          {"worst_frame", violation.worst_frame + 1}};
}

Json finding_json(const Skeleton& skeleton, const Finding& finding) {
  const FindingTraits& traits = traits_of(finding.kind);
  const auto frame = [&](bool is_last) {
    return finding.frames ? Json(is_last ? finding.frames->end() : finding.frames->first + 1) : Json();
  };
  return {{"kind", traits.id},
          {"severity", severity_name(Severity::Note)},
          {"joint", finding.joint ? Json(skeleton.name(*finding.joint)) : Json()},
          {"joint_index", finding.joint ? Json(*finding.joint) : Json()},
          {"channel", finding.channel ? Json(channel_label(skeleton, *finding.channel)) : Json()},
          {"first_frame", frame(false)},
          {"last_frame", frame(true)},
          {"count", finding.count},
          {"message", finding.message},
          {"suggestion", traits.suggestion},
          {"tools", std::vector<std::string>(traits.tools.begin(), traits.tools.end())}};
}

Json left_out_json(const LintReport& lint) {
  Json counts = Json::object();
  for (int kind = 0; kind < kFindingKindCount; ++kind) {
    const int count = lint.left_out[idx(kind)];
    if (count > 0) counts[std::string(traits_of(static_cast<FindingKind>(kind)).id)] = count;
  }
  return counts;
}

std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'; }

}  // namespace

std::string refusal_json(const Error& error) {
  return text_of({{"error",
                   {{"code", diagnostic_id(error.code)},
                    {"line", error.place.line},
                    {"column", error.place.column},
                    {"message", error.message}}}});
}

std::string check_json(const std::string& file, const BvhClip& clip, const LintReport& lint,
                       const std::vector<Violation>& violations) {
  Json findings = Json::array();
  for (const Finding& finding : lint.findings) findings.push_back(finding_json(clip.skeleton, finding));
  Json list = Json::array();
  for (const Violation& violation : violations) list.push_back(violation_json(clip.skeleton, violation));
  return text_of({{"file", file},
                  {"errors", clip.diagnostics.count(Severity::Error)},
                  {"warnings", clip.diagnostics.count(Severity::Warning)},
                  {"diagnostics", diagnostics_json(clip.diagnostics)},
                  {"findings", std::move(findings)},
                  {"findings_left_out", left_out_json(lint)},
                  {"violations", std::move(list)}});
}

std::string clip_json(const BvhClip& clip) {
  const Json json = {{"joints", joints_json(clip.skeleton)},
                     {"channel_count", clip.skeleton.channel_count()},
                     {"frame_count", clip.motion.frame_count()},
                     {"frame_time", clip.motion.frame_time_s()},
                     {"duration", clip.motion.duration_s()},
                     {"stature", compute_stature(clip.skeleton)},
                     {"metres_per_unit", guess_metres_per_unit(clip.skeleton)},
                     {"names_in", traits_of(clip.names_in).id},
                     {"diagnostics", diagnostics_json(clip.diagnostics)}};
  return text_of(json);
}

}  // namespace marey::cli
