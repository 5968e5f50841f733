#include "wasm/app/command_args.h"

#include <fmt/format.h>

#include <cmath>

namespace marey::app {

nlohmann::json command_error(std::string_view sentence) { return {{"error", std::string(sentence)}}; }

const nlohmann::json* CommandArgs::find(std::string_view key) const {
  if (!args_.is_object()) return nullptr;
  const auto found = args_.find(std::string(key));
  return found == args_.end() || found->is_null() ? nullptr : &*found;
}

bool CommandArgs::has(std::string_view key) const { return find(key) != nullptr; }

void CommandArgs::complain(std::string sentence) {
  if (complaint_.empty()) complaint_ = std::move(sentence);
}

double CommandArgs::number(std::string_view key, double fallback, double low, double high) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return fallback;
  const double number = value->is_number() ? value->get<double>() : NAN;
  if (number >= low && number <= high) return number;
  complain(fmt::format("'{}' must be a number from {} to {}, not {}.", key, low, high, value->dump()));
  return fallback;
}

int CommandArgs::whole(std::string_view key, int fallback, int low, int high) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return fallback;
  const double number = value->is_number() ? value->get<double>() : NAN;
  if (number >= low && number <= high && number == std::floor(number)) return static_cast<int>(number);
  complain(fmt::format("'{}' must be a whole number from {} to {}, not {}.", key, low, high, value->dump()));
  return fallback;
}

bool CommandArgs::boolean(std::string_view key, bool fallback) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return fallback;
  if (value->is_boolean()) return value->get<bool>();
  complain(fmt::format("'{}' must be true or false, not {}.", key, value->dump()));
  return fallback;
}

std::string CommandArgs::text(std::string_view key, std::string_view fallback) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return std::string(fallback);
  if (value->is_string()) return value->get<std::string>();
  complain(fmt::format("'{}' must be a text, not {}.", key, value->dump()));
  return std::string(fallback);
}

}  // namespace marey::app
