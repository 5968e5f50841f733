#include "wasm/views/curves/curve_commands.h"

#include <cmath>
#include <functional>
#include <string>

#include "core/editing/curve_operations.h"
#include "wasm/app/command_args.h"
#include "wasm/app/icons.h"

namespace marey::app {
namespace {

using Json = nlohmann::json;
constexpr double kAnyNumber = 1e12;

Reason without_curves(const CurveCommandTargets& t) {
  return t.state.shown.empty() ? "Select a joint first." : "";
}

Reason without_samples(const CurveCommandTargets& t) {
  return t.session.selection.samples().empty() ? "Select samples in the curve editor first." : "";
}

Json apply(const CurveCommandTargets& t, Edit edit) {
  const bool changes = !edit.empty();
  const Status status = t.session.apply(std::move(edit));
  if (!status) return command_error(status.error().message);
  return {{"changed", changes}};
}

void select_everything(const CurveCommandTargets& t) {
  const FrameRange all{0, t.session.document.motion().frame_count()};
  for (const ChannelIndex channel : t.state.shown) t.session.selection.change_samples().add(channel, all);
}

Json select_run(const CurveCommandTargets& t, const Json& args) {
  CommandArgs read(args);
  const int channels = t.session.document.motion().channel_count();
  const int frames = t.session.document.motion().frame_count();
  if (channels == 0 || frames == 0) return command_error("The clip has no samples.");
  const int channel = read.whole("channel", 0, 0, channels - 1);
  const int first = read.whole("first", 0, 0, frames - 1);
  const int count = read.whole("count", 1, 1, frames);
  const bool add = read.boolean("add", false);
  if (read.failed()) return read.error();
  if (!add) t.session.selection.change_samples().clear();
  t.session.selection.change_samples().add(channel, {first, std::min(count, frames - first)});
  return {{"selected", t.session.selection.samples().count()}};
}

Json smooth(const CurveCommandTargets& t, const Json& args) {
  CommandArgs read(args);
  const double sigma = read.number("sigma", static_cast<double>(t.options.smooth_sigma_frames), 0.1, 200.0);
  if (read.failed()) return read.error();
  return apply(t, make_smooth_edit(t.session.document.clip(), t.session.selection.samples(), sigma));
}

Json move(const CurveCommandTargets& t, const Json& args) {
  CommandArgs read(args);
  const double delta = read.number("delta", 0.0, -kAnyNumber, kAnyNumber);
  const double radius = read.number("radius", 0.0, 0.0, 1000.0);
  if (read.failed()) return read.error();
  return apply(t, make_move_edit(t.session.document.clip(), t.session.selection.samples(), delta, {radius}));
}

Json scale(const CurveCommandTargets& t, const Json& args) {
  CommandArgs read(args);
  const Clip& clip = t.session.document.clip();
  const SampleSelection& samples = t.session.selection.samples();
  const double factor = read.number("factor", 1.0, -kAnyNumber, kAnyNumber);
  const double pivot = read.number("pivot", compute_selection_mean(clip, samples), -kAnyNumber, kAnyNumber);
  if (read.failed()) return read.error();
  return apply(t, make_scale_edit(clip, samples, factor, pivot));
}

Json set_value(const CurveCommandTargets& t, const Json& args) {
  CommandArgs read(args);
  if (!read.has("value")) return command_error("'value' is missing.");
  const double value = read.number("value", 0.0, -kAnyNumber, kAnyNumber);
  if (read.failed()) return read.error();
  return apply(t, make_value_edit(t.session.document.clip(), t.session.selection.samples(), value));
}

Json set_falloff(const CurveCommandTargets& t, const Json& args) {
  CommandArgs read(args);
  const double radius = read.number("radius", static_cast<double>(t.options.falloff_radius_frames), 0.0, 1000.0);
  if (read.failed()) return read.error();
  t.options.falloff_radius_frames = static_cast<float>(radius);
  return {{"radius", radius}};
}

Json locate(const CurveCommandTargets& t, const Json& args) {
  CommandArgs read(args);
  const Motion& motion = t.session.document.motion();
  if (motion.frame_count() == 0) return command_error("The clip has no samples.");
  const int channel = read.whole("channel", 0, 0, motion.channel_count() - 1);
  const int frame = read.whole("frame", 0, 0, motion.frame_count() - 1);
  if (read.failed()) return read.error();
  const ValueAxis& axis = t.state.axis_of(t.session.document.skeleton(), channel);
  const float scale = t.options.interface_scale;
  return {{"x", t.time.x_of(frame) * scale}, {"y", axis.y_of(motion.sample(channel, frame)) * scale}};
}

void add_page(CommandRegistry& registry, ViewOptions& options, CurvesPage page, Command command) {
  command.run = [&options, page](const Json&) -> Json {
    options.curves_page = page;
    options.show_curves = true;
    return nullptr;
  };
  command.checked = [&options, page] { return options.curves_page == page; };
  registry.add(std::move(command));
}

void add_pages(CommandRegistry& registry, ViewOptions& options) {
  add_page(registry, options, CurvesPage::Curves,
           {.id = "view.curve_editor", .label = "Curve editor", .help = "Shows the curves of the selected joints.",
            .shortcut = "Alt+1", .icon = icons::kChartSpline});
  add_page(registry, options, CurvesPage::Filter,
           {.id = "view.filter_explorer", .label = "Filter explorer",
            .help = "Shows a curve with its second derivative, its spectrum and its residuals, before and after an operation.",
            .shortcut = "Alt+2", .icon = icons::kWaves});
  add_page(registry, options, CurvesPage::Orders,
           {.id = "view.rotation_orders", .label = "Rotation orders",
            .help = "Shows the rotation of a joint in each of the six orders, and where it is near gimbal lock.",
            .shortcut = "Alt+3", .icon = icons::kRotate3d});
  add_page(registry, options, CurvesPage::Plots,
           {.id = "view.plots", .label = "Plots",
            .help = "Plots quantities of kinematics and mechanics over the frames, with their units.",
            .shortcut = "Alt+4", .icon = icons::kChartNoAxesCombined});
}

void add_view_commands(CommandRegistry& registry, CurveCommandTargets t) {
  registry.add({.id = "curve.fit",
                .label = "Fit curves",
                .help = "Shows the whole clip and the full height of its curves.",
                .shortcut = "Shift+A",
                .icon = icons::kMaximize,
                .run = [t](const Json&) -> Json {
                  t.time.fit(t.session.document.motion().frame_count());
                  fit_values(t.state, t.session, t.time);
                  return nullptr;
                },
                .blocked = [t] { return without_curves(t); }});
  registry.add({.id = "curve.fit_selection",
                .label = "Fit selected samples",
                .help = "Zooms the curves to the selected samples.",
                .shortcut = "Shift+F",
                .icon = icons::kFocus,
                .run = [t](const Json&) -> Json {
                  fit_selection(t.state, t.session, t.time);
                  return nullptr;
                },
                .blocked = [t] { return without_curves(t); }});
  registry.add({.id = "curve.falloff",
                .label = "Set falloff",
                .help = "Sets how many neighbouring frames follow a dragged sample.",
                .run = [t](const Json& args) { return set_falloff(t, args); },
                .in_palette = false});
  registry.add({.id = "curve.locate",
                .label = "Locate a sample",
                .help = "Gives the place of a sample on the page in CSS pixels.",
                .run = [t](const Json& args) { return locate(t, args); },
                .in_palette = false});
}

void add_selection_commands(CommandRegistry& registry, CurveCommandTargets t) {
  registry.add({.id = "curve.select_all",
                .label = "Select all samples",
                .help = "Selects every sample of the curves that are shown.",
                .shortcut = "Ctrl+A",
                .icon = icons::kSquareDashedMousePointer,
                .run = [t](const Json&) -> Json {
                  select_everything(t);
                  return {{"selected", t.session.selection.samples().count()}};
                },
                .blocked = [t] { return without_curves(t); }});
  registry.add({.id = "curve.select_none",
                .label = "Select no samples",
                .help = "Clears the selection of samples.",
                .shortcut = "Ctrl+Shift+A",
                .run = [t](const Json&) -> Json {
                  t.session.selection.change_samples().clear();
                  return nullptr;
                },
                .blocked = [t] { return without_samples(t); }});
  registry.add({.id = "curve.select",
                .label = "Select samples of a channel",
                .help = "Selects a run of samples of one channel.",
                .run = [t](const Json& args) { return select_run(t, args); },
                .in_palette = false});
}

void add_operation_commands(CommandRegistry& registry, CurveCommandTargets t) {
  const auto blocked = [t] { return without_samples(t); };
  registry.add({.id = "curve.smooth",
                .label = "Smooth",
                .help = "Smooths the selected samples with a Gaussian of the given width.",
                .shortcut = "Shift+S",
                .icon = icons::kWaves,
                .run = [t](const Json& args) { return smooth(t, args); },
                .blocked = blocked});
  registry.add({.id = "curve.move",
                .label = "Move samples",
                .help = "Moves the selected samples in value.",
                .run = [t](const Json& args) { return move(t, args); },
                .blocked = blocked,
                .in_palette = false});
  registry.add({.id = "curve.scale",
                .label = "Scale samples",
                .help = "Scales the selected samples about a pivot, their mean unless given.",
                .run = [t](const Json& args) { return scale(t, args); },
                .blocked = blocked,
                .in_palette = false});
  registry.add({.id = "curve.set_value",
                .label = "Set value of samples",
                .help = "Gives all selected samples one value.",
                .run = [t](const Json& args) { return set_value(t, args); },
                .blocked = blocked,
                .in_palette = false});
}

}  // namespace

void add_curve_commands(CommandRegistry& registry, CurveCommandTargets targets) {
  add_pages(registry, targets.options);
  add_view_commands(registry, targets);
  add_selection_commands(registry, targets);
  add_operation_commands(registry, targets);
}

}  // namespace marey::app
