#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/support/imgui_stage.h"
#include "wasm/app/app.h"
#include "wasm/platform/headless/headless_log.h"

namespace marey::app {

/// The whole program on the headless backend, used by mouse and keys as a person uses the page.
class AppStage {
 public:
  /// `preferences`: what a former visit left; by default the welcome was seen. `other_letters`: as in FontFiles.
  explicit AppStage(WindowSize window = {}, std::string preferences = R"({"welcomeSeen":true})",
                    const ImFontLoader* other_letters = nullptr);

  App& app() { return *app_; }
  HeadlessLog& log() { return headless_log(); }
  [[nodiscard]] nlohmann::json state() { return app_->state(); }

  /// One frame, 1/60 s later. Returns whether the program wants another one.
  bool frame();
  /// Frames until the program comes to rest, at most `limit`; returns how many were drawn.
  int settle(int limit = 200);
  void wait(double seconds) { now_s_ += seconds; }
  void resize(WindowSize window) { window_ = window; }

  /// Opens web/samples/<id>.bvh.
  void open_sample(const std::string& id);
  Status open_text(std::string file_name, const std::string& text);

  void hover(const std::string& item_id);
  void click(const std::string& item_id);
  void double_click(const std::string& item_id);
  void drag(const std::string& item_id, ImVec2 by);
  void press(ImGuiKeyChord chord);
  void type(const std::string& text);
  /// A click on a place of the window.
  void click_at(ImVec2 position);

  [[nodiscard]] bool shows(const std::string& item_id) { return is_shown(app_->items(), item_id); }
  [[nodiscard]] const UiItem& item(const std::string& item_id);

 private:
  ImGuiStage imgui_;
  Backend backend_;
  WindowSize window_;
  double now_s_ = 10.0;
  std::unique_ptr<App> app_;
};

/// A figure of three joints, "Root", "Middle" and `tip_name`, with `frames` frames.
[[nodiscard]] std::string small_bvh(int frames = 5, const std::string& tip_name = "Tip");

}  // namespace marey::app
