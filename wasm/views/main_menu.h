#pragma once

#include <span>
#include <string_view>

#include "wasm/views/menu.h"

namespace marey::app {

struct MainMenu {
  std::string_view title;
  MenuEntries entries;
};

/// File, Edit, Clip, View, Help.
[[nodiscard]] std::span<const MainMenu> main_menus();

/// The commands that a narrow page offers in its one menu.
[[nodiscard]] MenuEntries compact_menu();

}  // namespace marey::app
