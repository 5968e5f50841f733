#include "wasm/app/preferences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "wasm/app/json_reading.h"

namespace marey::app {
namespace {

using nlohmann::json;

constexpr std::array kThemeNames = {"system", "dark", "light"};

// Visits each kept value once, for writing and for reading, so that the two cannot drift apart.
template <class Preferences, class Visit>
void visit_values(Preferences& preferences, const Visit& visit) {
  auto& options = preferences.options;
  visit("showOutliner", options.show_outliner);
  visit("showInspector", options.show_inspector);
  visit("showCurves", options.show_curves);
  visit("showGrid", options.show_grid);
  visit("showShadow", options.show_shadow);
  visit("showNames", options.show_names);
  visit("showStrobe", options.show_strobe);
  visit("showTrails", options.show_trails);
  visit("followRoot", options.follow_root);
  visit("showPerformance", options.show_performance);
  visit("orthographic", options.orthographic);
  visit("projector", options.projector);
  visit("welcomeSeen", preferences.welcome_seen);
  visit("falloffRadiusFrames", options.falloff_radius_frames, 0.0f, 1000.0f);
  visit("smoothSigmaFrames", options.smooth_sigma_frames, 0.1f, 1000.0f);
  visit("interfaceScale", options.interface_scale, 1.0f, kLargestInterfaceScale);
  visit("outlinerWidth", preferences.sizes.outliner_width, 100.0f, 2000.0f);
  visit("inspectorWidth", preferences.sizes.inspector_width, 100.0f, 2000.0f);
  visit("curvesHeight", preferences.sizes.curves_height, 60.0f, 4000.0f);
}

struct Writer {
  json& object;
  template <class Value, class... Bounds>
  void operator()(const char* name, const Value& value, Bounds...) const {
    object[name] = value;
  }
};

struct Reader {
  const json& object;
  void operator()(const char* name, bool& value) const {
    if (const auto found = object.find(name); found != object.end() && found->is_boolean()) value = found->get<bool>();
  }
  template <class Number>
  void operator()(const char* name, Number& value, Number low, Number high) const {
    const auto found = object.find(name);
    if (found == object.end() || !found->is_number()) return;
    const double number = found->get<double>();
    if (std::isfinite(number)) {
      value = static_cast<Number>(std::clamp(number, static_cast<double>(low), static_cast<double>(high)));
    }
  }
};

// Enums are kept as numbers 0 .. last.
template <class Enum>
void read_enum(const json& object, const char* name, Enum last, Enum& value) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_number_integer()) return;
  const auto number = found->get<std::int64_t>();
  if (number >= 0 && number <= static_cast<std::int64_t>(last)) value = static_cast<Enum>(number);
}

}  // namespace

std::string write_preferences(const Preferences& preferences) {
  json object;
  visit_values(preferences, Writer{object});
  object["theme"] = theme_choice_name(preferences.theme);
  object["sheet"] = static_cast<int>(preferences.sheet);
  return object.dump();
}

Preferences read_preferences(std::string_view json_text) {
  Preferences preferences;
  const Result<json> read = read_json(json_text);
  const json object = read ? *read : json();
  if (!object.is_object()) return preferences;
  visit_values(preferences, Reader{object});
  if (const auto theme = object.find("theme"); theme != object.end()) {
    for (std::size_t i = 0; i < kThemeNames.size(); ++i) {
      if (*theme == kThemeNames[i]) preferences.theme = static_cast<ThemeChoice>(i);
    }
  }
  read_enum(object, "sheet", Sheet::Inspector, preferences.sheet);
  return preferences;
}

std::string_view theme_choice_name(ThemeChoice choice) { return kThemeNames[static_cast<std::size_t>(choice)]; }

}  // namespace marey::app
