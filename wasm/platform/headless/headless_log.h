#pragma once

#include <string>
#include <vector>

#include "wasm/platform/backend.h"

namespace marey::app {

/// What the program has asked of the headless Backend, and what it is to answer. One for all Backends of a test
/// program; tests clear it before they start.
struct HeadlessLog {
  int file_requests = 0;
  int other_requests = 0;  ///< for a clip beside the open one
  int model_requests = 0;
  int stopped_loadings = 0;
  std::vector<std::pair<std::string, std::string>> downloads;  ///< name, bytes
  std::vector<std::string> samples;
  std::vector<std::string> announcements;
  std::vector<std::string> faults;
  std::vector<std::string> links;
  std::string clipboard;
  std::string file_name;
  bool dirty = false;
  std::string mouse_cursor = "default";
  double draw_after_s = 0.0;  ///< of the last request
  std::string preferences;  ///< what store_preferences was given, and load_preferences returns
  int preference_writes = 0;
  SystemPreferences system;
  double now_ms = 0.0;
  Backend::Memory memory;
};

[[nodiscard]] HeadlessLog& headless_log();

}  // namespace marey::app
