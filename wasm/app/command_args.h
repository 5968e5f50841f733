#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace marey::app {

/// {"error": sentence}, what a command returns when its arguments are wrong.
[[nodiscard]] nlohmann::json command_error(std::string_view sentence);

/// Reads the arguments of a command and collects the first complaint. Missing arguments give the fallback.
///
///     CommandArgs read(args);
///     const double sigma = read.number("sigma", 2.0, 0.1, 200.0);
///     if (read.failed()) return read.error();
class CommandArgs {
 public:
  explicit CommandArgs(const nlohmann::json& args) : args_(args) {}

  /// A finite number within [low, high].
  [[nodiscard]] double number(std::string_view key, double fallback, double low, double high);
  /// A whole number within [low, high].
  [[nodiscard]] int whole(std::string_view key, int fallback, int low, int high);
  [[nodiscard]] bool boolean(std::string_view key, bool fallback);
  [[nodiscard]] std::string text(std::string_view key, std::string_view fallback);
  [[nodiscard]] bool has(std::string_view key) const;

  [[nodiscard]] bool failed() const { return !complaint_.empty(); }
  [[nodiscard]] nlohmann::json error() const { return command_error(complaint_); }

 private:
  [[nodiscard]] const nlohmann::json* find(std::string_view key) const;
  void complain(std::string sentence);

  const nlohmann::json& args_;
  std::string complaint_;
};

}  // namespace marey::app
