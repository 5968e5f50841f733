#include "tests/app/support/imgui_stage.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>

namespace marey::app {
namespace {

std::vector<std::byte> read_font(const std::string& path) {
  std::ifstream file(std::string(MAREY_SOURCE_DIR) + "/node_modules/" + path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::vector<std::byte> font(bytes.size());
  if (!font.empty()) std::memcpy(font.data(), bytes.data(), bytes.size());
  return font;
}

}  // namespace

ImGuiStage::ImGuiStage() : context_(ImGui::CreateContext()) {
  ImGuiIO& io = ImGui::GetIO();
  io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
  io.IniFilename = nullptr;
}

ImGuiStage::~ImGuiStage() {
  for (ImTextureData* texture : ImGui::GetPlatformIO().Textures) {
    texture->SetTexID(ImTextureID_Invalid);
    texture->SetStatus(ImTextureStatus_Destroyed);
  }
  ImGui::DestroyContext(context_);
}

void ImGuiStage::accept_textures() {
  for (ImTextureData* texture : ImGui::GetPlatformIO().Textures) {
    if (texture->Status == ImTextureStatus_WantCreate) texture->SetTexID(1);
    if (texture->Status == ImTextureStatus_WantDestroy) {
      texture->SetTexID(ImTextureID_Invalid);
      texture->SetStatus(ImTextureStatus_Destroyed);
    } else if (texture->Status != ImTextureStatus_Destroyed) {
      texture->SetStatus(ImTextureStatus_OK);
    }
  }
}

FontFiles ImGuiStage::font_files() {
  FontFiles files;
  files.text = read_font("@expo-google-fonts/inter/400Regular/Inter_400Regular.ttf");
  files.semibold = read_font("@expo-google-fonts/inter/600SemiBold/Inter_600SemiBold.ttf");
  files.mono = read_font("@expo-google-fonts/jetbrains-mono/400Regular/JetBrainsMono_400Regular.ttf");
  files.icons = read_font("lucide-static/font/lucide.ttf");
  return files;
}

void ImGuiStage::key_event(ImGuiKeyChord chord, bool down) {
  ImGuiIO& io = ImGui::GetIO();
  for (const ImGuiKey modifier : {ImGuiMod_Ctrl, ImGuiMod_Shift, ImGuiMod_Alt}) {
    if ((chord & modifier) != 0) io.AddKeyEvent(modifier, down);
  }
  io.AddKeyEvent(static_cast<ImGuiKey>(chord & ~ImGuiMod_Mask_), down);
}

ImVec2 center_of(const UiItems& items, const std::string& id) {
  for (const UiItem& item : items.list()) {
    if (item.id == id) return {(item.min.x + item.max.x) * 0.5f, (item.min.y + item.max.y) * 0.5f};
  }
  ADD_FAILURE() << "no visible item " << id;
  return {-1.0f, -1.0f};
}

bool is_shown(const UiItems& items, const std::string& id) {
  for (const UiItem& item : items.list()) {
    if (item.id == id) return true;
  }
  return false;
}

}  // namespace marey::app
