#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/document/session.h"
#include "wasm/app/fonts.h"
#include "wasm/app/performance.h"
#include "wasm/app/ui_items.h"
#include "wasm/app/view_options.h"
#include "wasm/platform/backend.h"
#include "wasm/render/scene.h"

namespace marey::app {

/// Size of the window and of its pixels.
struct WindowSize {
  float css_width = 1280.0f;
  float css_height = 800.0f;
  float device_pixel_ratio = 1.0f;
};

struct AppParts;

/// The program: a session, the commands on it and the views of it. Knows no browser and no GL: the platform feeds input
/// to ImGui, calls frame(), draws scene() and then ImGui's draw data.
class App {
 public:
  App(Backend& backend, const FontFiles& fonts);
  ~App();
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  /// Opens a file. On an error, OutOfMemory among them, the open document stays as it was and the message is shown in
  /// the page.
  Status open_file(std::string file_name, std::string_view bytes);
  /// The same by pieces; see wasm/app/opening.h.
  Status begin_loading(std::string file_name, std::int64_t size, FileUse use = FileUse::Document);
  bool feed_loading(std::string_view bytes);
  Status finish_loading();
  void cancel_loading();

  /// Runs one frame between ImGui::NewFrame and ImGui::Render, both of which it calls. Returns true when a further
  /// frame is wanted without input (playing, animating, settling). What a panel throws is shown in its place; throws what
  /// stands in the way of two frames in turn.
  bool frame(const WindowSize& window, double now_s);

  /// What the last frame took, drawing included; for the performance card.
  void note_cost(const FrameCost& cost);

  [[nodiscard]] const Scene& scene() const;
  [[nodiscard]] const UiItems& items() const;
  /// Factor from ImGui units to CSS pixels: the interface scale.
  [[nodiscard]] float css_per_unit() const;

  /// What `window.marey` gives: design of the page API in docs/page-api.md.
  [[nodiscard]] nlohmann::json state() const;
  [[nodiscard]] nlohmann::json commands() const;
  nlohmann::json run_command(std::string_view id, const nlohmann::json& args);
  [[nodiscard]] std::string save_text() const;

  [[nodiscard]] Session& session();

 private:
  void draw_frame();

  std::unique_ptr<AppParts> parts_;
};

}  // namespace marey::app
