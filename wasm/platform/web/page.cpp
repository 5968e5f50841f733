#include "wasm/platform/web/page.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <cmath>
#include <cstring>
#include <new>

#include "wasm/platform/web/browser_letters.h"
#include "wasm/platform/web/host.h"

namespace marey::app {
namespace {

constexpr char kCanvasSelector[] = "#canvas";

Page& page_of(ImGuiContext* /*context*/) { return *static_cast<Page*>(ImGui::GetPlatformIO().Platform_ClipboardUserData); }

void copy_text(ImGuiContext* context, const char* text) {
  page_of(context).set_clipboard_text(text);
  marey_host_set_clipboard_text(text, std::strlen(text));
}

void place_text_input(ImGuiContext* context, ImGuiViewport* /*viewport*/, ImGuiPlatformImeData* data) {
  const float scale = page_of(context).app().css_per_unit();
  marey_host_set_text_input(data->WantTextInput ? 1 : 0, data->InputPos.x * scale, data->InputPos.y * scale,
                            data->InputLineHeight * scale);
}

}  // namespace

Page::Page() = default;

Page::~Page() {
  app_.reset();
  if (imgui_ == nullptr) return;
  if (ImGui::GetIO().BackendRendererUserData != nullptr) ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(imgui_);
}

Status Page::start(FontFiles fonts) {
  if (Status started = gl_.start(kCanvasSelector); !started) return started;
  // Without memory ImGui throws too, instead of writing through a null pointer.
  ImGui::SetAllocatorFunctions([](std::size_t size, void*) { return ::operator new(size); },
                               [](void* memory, void*) { ::operator delete(memory); });
  imgui_ = ImGui::CreateContext();
  ImGui::GetIO().ConfigMacOSXBehaviors = backend_.system_preferences().apple_keys;
  connect_imgui();
  if (!ImGui_ImplOpenGL3_Init("#version 300 es")) {
    return Error{DiagnosticCode::InvalidArgument, {}, "The graphics driver refused the page's shaders.", "", ""};
  }
  if (Status started = scene_renderer_.start(); !started) return started;
  fonts.other_letters = &browser_letters();
  app_ = std::make_unique<App>(backend_, fonts);
  return {};
}

void Page::connect_imgui() {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendPlatformName = "marey_web";
  ImGuiPlatformIO& platform = ImGui::GetPlatformIO();
  platform.Platform_ClipboardUserData = this;
  platform.Platform_SetClipboardTextFn = copy_text;
  platform.Platform_GetClipboardTextFn = [](ImGuiContext* context) { return page_of(context).clipboard_text_.c_str(); };
  platform.Platform_SetImeDataFn = place_text_input;
}

bool Page::frame(double now_ms) {
  const double begin_ms = backend_.now_ms();
  input_.set_css_per_unit(app_->css_per_unit());
  ImGui_ImplOpenGL3_NewFrame();
  const bool wants_more = app_->frame(window_, now_ms / 1000.0);
  draw();
  note_cost(begin_ms);
  return wants_more || Input::has_waiting_events();
}

void Page::note_cost(double begin_ms) {
  const SceneRenderer::Count scene = scene_renderer_.take_count();
  const ImDrawData& interface = *ImGui::GetDrawData();
  int calls = scene.calls;
  for (const ImDrawList* list : interface.CmdLists) calls += list->CmdBuffer.Size;
  app_->note_cost({.cpu_ms = backend_.now_ms() - begin_ms, .draw_calls = calls, .vertices = scene.vertices + interface.TotalVtxCount});
}

void Page::draw() {
  const auto width = static_cast<int>(std::lround(window_.css_width * window_.device_pixel_ratio));
  const auto height = static_cast<int>(std::lround(window_.css_height * window_.device_pixel_ratio));
  scene_renderer_.draw(app_->scene(), width, height, window_.device_pixel_ratio * app_->css_per_unit());
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Page::forget_letters() { forget_drawn_letters(*ImGui::GetIO().Fonts); }

void Page::lose_context() {
  ImGui_ImplOpenGL3_DestroyDeviceObjects();
  scene_renderer_.release();
}

Status Page::restore_context() { return scene_renderer_.start(); }

}  // namespace marey::app
