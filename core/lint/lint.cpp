#include "core/lint/lint.h"

#include "core/lint/curve_findings.h"
#include "core/lint/floor_findings.h"
#include "core/lint/freeze_findings.h"
#include "core/lint/name_findings.h"
#include "core/lint/reference_pose.h"
#include "core/lint/skeleton_findings.h"
#include "core/lint/turn_findings.h"

namespace marey {

LintReport lint_clip(const Clip& clip, const LintOptions& options) {
  LintReport report;
  add_name_findings(clip.skeleton, report);
  add_skeleton_findings(clip.skeleton, report);
  const bool has_reference_pose = add_reference_pose(clip, report);
  const FrameRange moving = has_reference_pose ? FrameRange{1, clip.motion.frame_count() - 1}
                                               : FrameRange{0, clip.motion.frame_count()};
  add_curve_findings(clip, moving, options, report);
  add_turn_findings(clip, moving, options, report);
  add_freeze_findings(clip, options, report);
  add_floor_findings(clip, moving, options, report);
  return report;
}

}  // namespace marey
