#include "tests/app/support/app_stage.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <utility>

namespace marey::app {

AppStage::AppStage(WindowSize window, std::string preferences, const ImFontLoader* other_letters) : window_(window) {
  headless_log() = HeadlessLog{};
  headless_log().preferences = std::move(preferences);
  FontFiles fonts = ImGuiStage::font_files();
  fonts.other_letters = other_letters;
  app_ = std::make_unique<App>(backend_, fonts);
  settle();
}

bool AppStage::frame() {
  now_s_ += 1.0 / 60.0;
  const bool more = app_->frame(window_, now_s_);
  ImGuiStage::accept_textures();
  return more;
}

int AppStage::settle(int limit) {
  int drawn = 1;
  while (frame() && drawn < limit) ++drawn;
  return drawn;
}

void AppStage::open_sample(const std::string& id) {
  std::ifstream file(std::string(MAREY_SOURCE_DIR) + "/web/samples/" + id + ".bvh", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  ASSERT_FALSE(text.empty()) << "sample " << id << " is missing";
  ASSERT_TRUE(open_text(id + ".bvh", text).ok());
}

Status AppStage::open_text(std::string file_name, const std::string& text) {
  Status status = app_->open_file(std::move(file_name), text);
  for (int i = 0; i < 4; ++i) frame();
  return status;
}

void AppStage::hover(const std::string& item_id) {
  ImGuiStage::move_mouse(center_of(app_->items(), item_id));
  frame();
  frame();
}

void AppStage::click(const std::string& item_id) { click_at(center_of(app_->items(), item_id)); }

void AppStage::click_at(ImVec2 position) {
  ImGuiStage::move_mouse(position);
  frame();
  frame();
  ImGuiStage::press_mouse(true);
  frame();
  ImGuiStage::press_mouse(false);
  for (int i = 0; i < 4; ++i) frame();
  wait(1.0);
}

void AppStage::double_click(const std::string& item_id) {
  ImGuiStage::move_mouse(center_of(app_->items(), item_id));
  frame();
  for (int i = 0; i < 2; ++i) {
    ImGuiStage::press_mouse(true);
    frame();
    ImGuiStage::press_mouse(false);
    frame();
  }
  for (int i = 0; i < 4; ++i) frame();
  wait(1.0);
}

void AppStage::drag(const std::string& item_id, ImVec2 by) {
  constexpr int kSteps = 8;
  const ImVec2 from = center_of(app_->items(), item_id);
  ImGuiStage::move_mouse(from);
  frame();
  ImGuiStage::press_mouse(true);
  frame();
  for (int step = 1; step <= kSteps; ++step) {
    const float share = static_cast<float>(step) / kSteps;
    ImGuiStage::move_mouse(ImVec2(from.x + by.x * share, from.y + by.y * share));
    frame();
  }
  ImGuiStage::press_mouse(false);
  for (int i = 0; i < 4; ++i) frame();
  wait(1.0);
}

void AppStage::press(ImGuiKeyChord chord) {
  ImGuiStage::key_event(chord, true);
  frame();
  ImGuiStage::key_event(chord, false);
  for (int i = 0; i < 4; ++i) frame();
}

void AppStage::type(const std::string& text) {
  ImGuiStage::type(text);
  for (int i = 0; i < 3; ++i) frame();
}

const UiItem& AppStage::item(const std::string& item_id) {
  static const UiItem kNone;
  for (const UiItem& item : app_->items().list()) {
    if (item.id == item_id) return item;
  }
  ADD_FAILURE() << "no visible item " << item_id;
  return kNone;
}

std::string small_bvh(int frames, const std::string& tip_name) {
  std::string text =
      "HIERARCHY\nROOT Root\n{\n  OFFSET 0 0 0\n  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
      "  JOINT Middle\n  {\n    OFFSET 0 10 0\n    CHANNELS 3 Zrotation Xrotation Yrotation\n    JOINT " +
      tip_name +
      "\n    {\n      OFFSET 0 10 0\n      CHANNELS 3 Zrotation Xrotation Yrotation\n      End Site\n      {\n"
      "        OFFSET 0 10 0\n      }\n    }\n  }\n}\nMOTION\nFrames: " +
      std::to_string(frames) + "\nFrame Time: 0.1\n";
  for (int frame = 0; frame < frames; ++frame) {
    text += "0 0 0 " + std::to_string(frame) + " 0 0 0 0 0 0 0 0\n";
  }
  return text;
}

}  // namespace marey::app
