#include "cli/export_json.h"

#include <nlohmann/json.hpp>

namespace marey::cli {
namespace {

using Json = nlohmann::ordered_json;

Json target_json(const TargetTraits& target) {
  Json needs = Json::array();
  for (const TargetNeed& need : target.needs) {
    const RequirementTraits& requirement = traits_of(need.requirement);
    needs.push_back({{"id", requirement.id}, {"file", requirement.sentence}, {"reason", need.reason}});
  }
  return {{"id", target.id},         {"name", target.name},     {"audience", target.audience},
          {"needs", std::move(needs)}, {"remark", target.remark}, {"source", target.source}};
}

std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'; }

}  // namespace

std::string targets_json() {
  Json targets = Json::array();
  for (const TargetTraits& target : export_targets()) targets.push_back(target_json(target));
  return text_of({{"targets", std::move(targets)}});
}

std::string export_json(ExportTarget target, const ExportedClip& clip) {
  Json changes = Json::array();
  for (const ExportChange& change : clip.changes) {
    changes.push_back({{"kind", export_change_id(change.kind)},
                       {"is_loss", change.is_loss},
                       {"count", change.count},
                       {"message", change.message}});
  }
  Json names = Json::array();
  for (const ExportedName& name : clip.names) {
    names.push_back({{"joint_index", name.joint}, {"before", name.before}, {"after", name.after}});
  }
  return text_of({{"target", traits_of(target).id},
                  {"changes", std::move(changes)},
                  {"names", std::move(names)},
                  {"nodes", clip.nodes},
                  {"added_frames", clip.added_frames},
                  {"largest_move", clip.largest_move}});
}

}  // namespace marey::cli
