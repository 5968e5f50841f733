#include "core/editing/clip_operations.h"

#include <fmt/format.h>

#include "core/biomechanics/own_segments.h"

namespace marey {
namespace {

std::string settings_edit_name(const ClipSettings& before, const ClipSettings& after) {
  const bool rule = before.position_rule != after.position_rule;
  const bool axis = before.up_axis != after.up_axis;
  const bool unit = before.metres_per_unit != after.metres_per_unit;
  const bool names = before.names_in != after.names_in;
  if ((rule ? 1 : 0) + (axis ? 1 : 0) + (unit ? 1 : 0) + (names ? 1 : 0) != 1) return "Change clip settings";
  if (rule) return "Change meaning of positions";
  if (axis) return "Change up axis";
  if (unit) return "Change unit of length";
  return "Read names as " + std::string(traits_of(after.names_in).label);
}

}  // namespace

Edit make_offset_edit(const Clip& clip, NodeIndex node, const glm::dvec3& offset_file_units) {
  Edit edit;
  const bool exists = node >= 0 && node < clip.skeleton.node_count();
  edit.name = exists ? "Set offset of " + node_label(clip.skeleton, node) : "Set offset";
  edit.offsets.push_back({node, offset_file_units});
  return edit;
}

Edit make_settings_edit(const Clip& clip, const ClipSettings& settings) {
  Edit edit;
  edit.name = settings_edit_name(clip.settings, settings);
  edit.settings = settings;
  return edit;
}

Edit make_body_edit(const Clip& clip, const BodyChoice& body) {
  Edit edit;
  const BodyChoice& before = clip.body;
  edit.name = body.table != before.table || body.is_only_own != before.is_only_own ? "Change table of the body"
              : body.mass_kg != before.mass_kg                                     ? "Change mass of the body"
              : body.gravity_mps2 != before.gravity_mps2                           ? "Change gravity"
              : body.parts != before.parts                                         ? "Change what a joint carries"
                                                                                   : "Change a segment";
  edit.body = body;
  return edit;
}

Edit make_model_edit(const Clip& clip, const BodyModel& model) {
  Edit edit;
  edit.name = "Open a model of the body";
  edit.body = choose_model(clip.body, model);
  if (!model.metres_per_unit) return edit;
  edit.settings = clip.settings;
  edit.settings->metres_per_unit = *model.metres_per_unit;
  return edit;
}

Edit make_frame_time_edit(double frame_time_s) {
  Edit edit;
  edit.name = fmt::format("Set frame time to {} s", frame_time_s);
  edit.frame_time_s = frame_time_s;
  return edit;
}

Edit make_remove_frames_edit(FrameRange frames) {
  Edit edit;
  edit.name = frames.count == 1 ? fmt::format("Remove frame {}", frames.first + 1)
                                : fmt::format("Remove frames {} to {}", frames.first + 1, frames.end());
  edit.frames = FramesChange{frames, {}, {}};
  return edit;
}

}  // namespace marey
