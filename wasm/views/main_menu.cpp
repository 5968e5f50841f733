#include "wasm/views/main_menu.h"

namespace marey::app {
namespace {

constexpr std::string_view kFile[] = {
    "file.open", "file.save", "file.save_as", "file.previous", "", "file.samples", "", "file.sample.giant-swing", "file.sample.walk", "file.sample.pendulum",
    "file.sample.double-pendulum", "file.sample.robot-arm"};

constexpr std::string_view kEdit[] = {
    "edit.undo", "edit.redo", "", "#Samples", "curve.select_all", "curve.select_none", "curve.smooth",
    "", "#Keys", "keys.set", "keys.delete", "operation.to-keys", "operation.to-samples", "layer.add", "layer.bake",
    "", "#Joints", "select.parent", "select.child", "select.all", "select.none"};

constexpr std::string_view kClip[] = {
    "play.toggle", "play.loop", "play.first", "play.last", "play.previous", "play.next", "", "#Speed", "play.slower",
    "play.faster", "play.normal_speed", "#Range", "play.range_in", "play.range_out", "play.range_clear", "#File says",
    "clip.up_axis.y", "clip.up_axis.z", "clip.positions.replace", "clip.positions.add",
    "clip.positions.per_joint",
    "#Frames", "clip.first_frame.leave_out", "clip.frames.declared"};

constexpr std::string_view kView[] = {
    "view.outliner", "view.inspector", "view.curves", "view.problems", "view.layers", "#Below the timeline", "view.curve_editor", "view.filter_explorer", "view.rotation_orders", "view.plots", "#Camera", "view.frame_all",
    "view.frame_selection", "view.front", "view.side", "view.top", "view.orthographic", "view.follow_root", "#Figure",
    "view.grid", "view.shadow", "view.names", "view.strobe", "view.trails", "#Interface", "view.theme.system",
    "view.theme.light", "view.theme.dark", "view.scale.larger", "view.scale.smaller", "view.scale.reset",
    "view.projector", "view.performance"};

constexpr std::string_view kAnalyse[] = {
    "analysis.layout", "view.plots", "file.open_other", "#Body", "analysis.body", "analysis.open_model", "analysis.save_model", "analysis.let_go",
    "#Contacts", "analysis.contact_on", "analysis.contact_off", "analysis.contact_auto", "analysis.next_event", "analysis.previous_event", "#In the view", "view.com",
    "view.solids", "view.arrows.velocity", "view.arrows.acceleration", "view.arrows.force", "view.arrows.torque", "view.arrows.angular_momentum", "view.arrows.reaction", "#Download",
    "analysis.save_csv", "analysis.save_svg", "analysis.save_png"};

constexpr std::string_view kHelp[] = {"help.shortcuts", "help.commands", "help.about"};

constexpr std::string_view kCompact[] = {
    "file.open", "file.save_as", "file.samples", "", "view.frame_all", "view.orthographic", "view.follow_root", "view.grid", "view.strobe",
    "view.trails", "view.names", "analysis.layout", "", "play.loop", "play.slower", "play.faster", "", "view.theme.light", "view.theme.dark",
    "view.performance", "help.about"};

constexpr MainMenu kMenus[] = {MainMenu{"File", kFile}, MainMenu{"Edit", kEdit}, MainMenu{"Clip", kClip},
                                            MainMenu{"View", kView}, MainMenu{"Analyse", kAnalyse}, MainMenu{"Help", kHelp}};

}  // namespace

std::span<const MainMenu> main_menus() { return kMenus; }

MenuEntries compact_menu() { return kCompact; }

}  // namespace marey::app
