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

}  // namespace

std::string clip_json(const BvhClip& clip) {
  const Json json = {{"joints", joints_json(clip.skeleton)},
                     {"channel_count", clip.skeleton.channel_count()},
                     {"frame_count", clip.motion.frame_count()},
                     {"frame_time", clip.motion.frame_time_s()},
                     {"duration", clip.motion.duration_s()},
                     {"stature", compute_stature(clip.skeleton)},
                     {"metres_per_unit", guess_metres_per_unit(clip.skeleton)},
                     {"diagnostics", diagnostics_json(clip.diagnostics)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace marey::cli
