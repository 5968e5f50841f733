#include "wasm/views/about_view.h"

#include <array>
#include <string>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/overlay_window.h"

namespace marey::app {
namespace {

constexpr float kPadding = 20.0f;
constexpr float kNameColumn = 190.0f;
constexpr float kLicenceColumn = 110.0f;

constexpr char kPurpose[] =
    "A viewer and editor for BVH motion capture. Named after Étienne-Jules Marey (1830-1904), who drew human movement as "
    "curves and as several positions on one plate.";
constexpr char kPrivacy[] =
    "Nothing leaves this computer: files are read and written inside of this tab, and the page asks no other server for "
    "anything. It keeps your settings in this browser, no cookies and no statistics.";

struct Component {
  const char* name;
  const char* licence;
  const char* use;
};

constexpr std::array kComponents = {
    Component{"Dear ImGui, stb", "MIT", "controls and text"},
    Component{"GLM", "MIT", "vectors and quaternions"},
    Component{"{fmt}, fast_float", "MIT", "numbers out and in"},
    Component{"JSON for Modern C++", "MIT", "the page's interface"},
    Component{"Emscripten, musl, libc++", "MIT, Apache-2.0", "WebAssembly"},
    Component{"Inter, JetBrains Mono", "OFL-1.1", "typefaces"},
    Component{"Lucide", "ISC, MIT", "icons"},
};

void draw_components(const ViewContext& context) {
  for (const Component& component : kComponents) {
    const float left = ImGui::GetCursorPosX();
    ImGui::TextUnformatted(component.name);
    ImGui::SameLine(left + kNameColumn);
    ui::dim_text(context, component.licence);
    ImGui::SameLine(left + kNameColumn + kLicenceColumn);
    ui::dim_text(context, component.use);
  }
}

void draw_heading(const ViewContext& context, const char* title) {
  ImGui::Dummy(ImVec2(0.0f, 8.0f));
  ImGui::PushFont(context.fonts.semibold, 0.0f);
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
}

}  // namespace

void AboutView::draw(ViewContext& context, bool& open) {
  begin_overlay(context, {"##about", ImVec2(560.0f, 560.0f), 0.4f}, open);
  draw_overlay_title(context, "About Marey", "about.close", open);
  ImGui::BeginChild("text", ImVec2(ImGui::GetWindowWidth() - 2.0f * kPadding, ImGui::GetContentRegionAvail().y - 16.0f),
                    ImGuiChildFlags_NavFlattened);
  ImGui::PushTextWrapPos(ImGui::GetContentRegionAvail().x);
  ui::dim_text(context, std::string("Version ") + version_text());
  ImGui::Dummy(ImVec2(0.0f, 4.0f));
  ImGui::TextUnformatted(kPurpose);
  draw_heading(context, "Privacy");
  ImGui::TextUnformatted(kPrivacy);
  context.items.add_last("about.privacy", kPrivacy);
  draw_heading(context, "Licences");
  ImGui::TextUnformatted("Marey is free software under the MIT licence. It ships with:");
  draw_components(context);
  ImGui::Dummy(ImVec2(0.0f, 8.0f));
  const char* label = licences_open_ ? "Hide the licence texts" : "Show the licence texts";
  if (ui::text_button(context, "about.licences", label, "The full texts, as the licences ask for.")) {
    licences_open_ = !licences_open_;
  }
  if (licences_open_) {
    ImGui::PushFont(context.fonts.mono, Fonts::kSmallSize);
    ui::dim_text(context, notices_text());
    ImGui::PopFont();
  }
  ImGui::PopTextWrapPos();
  ImGui::EndChild();
  end_overlay();
}

}  // namespace marey::app
