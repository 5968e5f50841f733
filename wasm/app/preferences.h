#pragma once

#include <string>
#include <string_view>

#include "wasm/app/view_options.h"

namespace marey::app {

enum class ThemeChoice { System, Dark, Light };

/// What the lower part of a narrow page shows below the transport.
enum class Sheet { None, Curves, Joints, Inspector };

/// Sizes that the splitters set, in ImGui units.
struct PanelSizes {
  float outliner_width = 240.0f;
  float inspector_width = 300.0f;
  float curves_height = 284.0f;  ///< of ruler and curves together
  bool operator==(const PanelSizes&) const = default;
};

/// What is kept between visits: nothing of the files that were opened.
struct Preferences {
  ThemeChoice theme = ThemeChoice::System;
  PanelSizes sizes;
  ViewOptions options;
  Sheet sheet = Sheet::Curves;
  bool welcome_seen = false;
  bool operator==(const Preferences&) const = default;
};

inline constexpr float kLargestInterfaceScale = 2.5f;

/// JSON text. Unknown keys are ignored, values out of range are brought into it, anything else leaves the default: a
/// preference can never keep the page from starting.
[[nodiscard]] std::string write_preferences(const Preferences& preferences);
[[nodiscard]] Preferences read_preferences(std::string_view json_text);

[[nodiscard]] std::string_view theme_choice_name(ThemeChoice choice);

}  // namespace marey::app
