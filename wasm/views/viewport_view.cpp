#include "wasm/views/viewport_view.h"

#include "wasm/views/viewport/camera_control.h"
#include "wasm/views/viewport/figure_drawing.h"
#include "wasm/views/viewport/overlay.h"
#include "wasm/views/viewport/stage.h"
#include "wasm/views/viewport/viewport_commands.h"
#include "wasm/views/viewport/viewport_input.h"

namespace marey::app {
namespace {

constexpr float kLegendInset = 12.0f;
constexpr float kOutlineWidth = 2.0f;
constexpr float kProjectorOutlineWidth = 3.0f;

void clear_figure(Scene& scene) {
  scene.bones.clear();
  scene.balls.clear();
  scene.outlined_bones.clear();
  scene.outlined_balls.clear();
  scene.ellipsoids.clear();
  scene.line_points.clear();
  scene.lines.clear();
}

void add_camera(const CameraView& view, Scene& scene) {
  scene.view = glm::mat4(view.view());
  scene.projection = glm::mat4(view.projection());
  scene.eye = glm::vec3(view.eye());
  scene.orthographic = view.orthographic();
}

}  // namespace

void ViewportView::add_commands(CommandRegistry& registry, const Session& session) {
  add_viewport_commands(registry, session, state_);
}

void ViewportView::build_scene(const ViewContext& context, Scene& scene) {
  const FigureCache& figure = state_.figure;
  clear_figure(scene);
  add_camera(state_.view, scene);
  add_stage(figure.stage(), state_.camera.pose(), figure.pose_box(), context.theme, context.options, scene);
  scene.outline_width = context.options.projector ? kProjectorOutlineWidth : kOutlineWidth;
  strobe_.update(context.session, figure, context.options.show_strobe, context.options.strobe_every_frames,
                 context.theme, scene);
  if (figure.empty()) return;
  add_figure(figure.shape(), figure.pose(), context.session.selection, context.hover.joint, context.theme, scene);
  add_tethers(figure.shape(), figure.pose(), context.theme, scene);
  trails_.add(context.session, figure, state_.view, context.options, context.theme, scene);
  add_ground_line(figure.stage(), state_.view, scene);
}

void ViewportView::draw(ViewContext& context, Scene& scene) {
  const ImVec2 size = ImGui::GetContentRegionAvail();
  state_.corner = ImGui::GetCursorScreenPos();
  scene.x = state_.corner.x;
  scene.y = state_.corner.y;
  scene.width = size.x;
  scene.height = size.y;
  if (size.x < 1.0f || size.y < 1.0f) return;

  ImGui::SetNextItemAllowOverlap();
  ImGui::InvisibleButton(
      "viewport.canvas", size,
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  context.items.add_last("viewport.canvas", "Viewport");
  state_.figure.update(context.session, context.clip_serial);
  handle_viewport_input(context, state_);
  update_camera(context, state_, {static_cast<double>(size.x), static_cast<double>(size.y)});
  build_scene(context, scene);
  if (!state_.figure.empty()) solids_.add(context, state_.figure, scene);
  arrows_.add(context, state_, scene);
  if (!state_.figure.empty()) labels_.draw(context, state_);
  draw_overlay(context, state_);
  draw_arrow_legend(context, arrows_, {state_.corner.x + kLegendInset, state_.corner.y + (context.options.show_strobe ? 72.0f : 36.0f)});
}

}  // namespace marey::app
