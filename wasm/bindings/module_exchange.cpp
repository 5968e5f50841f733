#include <emscripten/emscripten.h>

#include <memory>
#include <string_view>

#include "core/interchange/export.h"
#include "core/table/csv.h"
#include "core/table/csv_reader.h"
#include "core/text/readable.h"
#include "wasm/bindings/module_clip.h"

namespace {

marey::Clip clip_of(const marey::BvhClip& bvh) {
  marey::Clip clip{bvh.skeleton, bvh.motion, {}};
  clip.settings.position_rule = bvh.position_rule;
  clip.settings.names_in = bvh.names_in;
  return clip;
}

}  // namespace

/// Tables and copies for other programs; see module.cpp for how text comes and goes.
extern "C" {

/// As marey_reader_finish. `figure`: the clip whose channels the table has, null for a table of points.
EMSCRIPTEN_KEEPALIVE ModuleClip* marey_clip_parse_table(const char* text, size_t size, int strict, const ModuleClip* figure) {
  auto clip = std::make_unique<ModuleClip>();
  const std::string_view table(text, size);
  const marey::TableOptions options{.strict = strict != 0, .limits = {}};
  take_read(*clip, figure != nullptr ? read_channel_table(table, figure->bvh, options) : read_points_table(table, options));
  return clip.release();
}

/// Leaves the table as the clip's text. `length_unit` may be empty.
EMSCRIPTEN_KEEPALIVE void marey_clip_write_table(ModuleClip* clip, int of_positions, const char* length_unit,
                                                 size_t length_unit_size, int first, int count) {
  const marey::BvhClip& bvh = clip->bvh;
  const std::string_view unit(length_unit, length_unit_size);
  clip->text.clear();
  if (of_positions != 0) {
    append_position_header(bvh.skeleton, clip->text, unit);
    append_position_rows(bvh.skeleton, bvh.motion, {first, count}, bvh.position_rule, clip->text);
  } else {
    append_channel_header(bvh.skeleton, clip->text, unit);
    append_channel_rows(bvh.motion, {first, count}, clip->text);
  }
}

/// 1 with the file as the clip's text and what it costs as its report; 0 with an error as JSON as its text.
/// `reference_pose`, `decimals`, `line_end`: below 0 as the target wants it.
EMSCRIPTEN_KEEPALIVE int marey_clip_write_for(ModuleClip* clip, const char* target, size_t target_size, int reference_pose,
                                              int decimals, int line_end) {
  const auto wanted = marey::find_export_target(std::string_view(target, target_size));
  if (!wanted) {
    clip->text = describe_error({marey::DiagnosticCode::InvalidArgument, {}, "There is no such target.", {}, {}});
    return 0;
  }
  marey::ExportOptions options;
  if (reference_pose >= 0) options.reference_pose = reference_pose != 0;
  const marey::Result<marey::ExportedClip> exported = export_for_target(clip_of(clip->bvh), *wanted, options);
  if (!exported) {
    clip->text = describe_error(exported.error());
    return 0;
  }
  clip->text = write_exported(*exported, save_options(decimals, line_end));
  clip->report = describe_export(*exported);
  return 1;
}

EMSCRIPTEN_KEEPALIVE const char* marey_clip_report(const ModuleClip* clip) { return clip->report.data(); }
EMSCRIPTEN_KEEPALIVE size_t marey_clip_report_size(const ModuleClip* clip) { return clip->report.size(); }

}  // extern "C"
