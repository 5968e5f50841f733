#include <nlohmann/json.hpp>

#include "wasm/bindings/module_clip.h"

namespace {

using marey::idx;
using nlohmann::json;

std::string to_text(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

json vector_json(const glm::dvec3& vector) { return json::array({vector.x, vector.y, vector.z}); }

json joint_json(const marey::Skeleton& skeleton, marey::JointIndex joint) {
  json channels = json::array();
  for (const marey::Channel& channel : skeleton.channels(joint)) {
    const bool is_known = channel.kind != marey::ChannelKind::Other;
    channels.push_back(is_known ? std::string(marey::channel_keyword(channel.kind)) : channel.other_name);
  }
  return {{"name", skeleton.name(joint)},
          {"parent", skeleton.parent(joint)},
          {"offset", vector_json(skeleton.offset(joint))},
          {"channels", std::move(channels)}};
}

json joints_json(const marey::Skeleton& skeleton) {
  json joints = json::array();
  for (marey::JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    joints.push_back(joint_json(skeleton, joint));
  }
  for (const marey::Node& node : skeleton.nodes()) {
    json& joint = joints[idx(node.joint)];
    if (node.is_end_site && !joint.contains("endSite")) joint["endSite"] = vector_json(node.offset);
  }
  return joints;
}

json diagnostics_json(const marey::Diagnostics& diagnostics) {
  json list = json::array();
  for (const marey::Diagnostic& diagnostic : diagnostics.list()) {
    list.push_back({{"severity", marey::severity_name(diagnostic.severity)},
                    {"code", marey::diagnostic_id(diagnostic.code)},
                    {"line", diagnostic.place.line},
                    {"column", diagnostic.place.column},
                    {"message", diagnostic.message},
                    {"count", diagnostic.count}});
  }
  return list;
}

}  // namespace

std::string describe_clip(const marey::BvhClip& bvh) {
  return to_text({{"joints", joints_json(bvh.skeleton)},
                  {"nodeCount", bvh.skeleton.node_count()},
                  {"channelCount", bvh.skeleton.channel_count()},
                  {"frameCount", bvh.motion.frame_count()},
                  {"frameTime", bvh.motion.frame_time_s()},
                  {"namesIn", marey::traits_of(bvh.names_in).id},
                  {"diagnostics", diagnostics_json(bvh.diagnostics)}});
}

std::string describe_export(const marey::ExportedClip& clip) {
  json changes = json::array();
  for (const marey::ExportChange& change : clip.changes) {
    changes.push_back({{"kind", marey::export_change_id(change.kind)},
                       {"isLoss", change.is_loss},
                       {"count", change.count},
                       {"message", change.message}});
  }
  json names = json::array();
  for (const marey::ExportedName& name : clip.names) {
    names.push_back({{"joint", name.joint}, {"before", name.before}, {"after", name.after}});
  }
  return to_text({{"changes", std::move(changes)}, {"names", std::move(names)}, {"largestMove", clip.largest_move}});
}

std::string describe_error(const marey::Error& error) {
  return to_text({{"code", marey::diagnostic_id(error.code)},
                  {"message", error.message},
                  {"line", error.place.line},
                  {"column", error.place.column}});
}
