#include "wasm/app/json_reading.h"

#include <string>
#include <utility>
#include <vector>

#include "core/base/text_place.h"

namespace marey::app {
namespace {

using nlohmann::json;

/// Builds a value out of what nlohmann's parser finds. Its own builders can do more and weigh more.
class JsonBuilder {
 public:
  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(json::number_integer_t value) { return add(value); }
  bool number_unsigned(json::number_unsigned_t value) { return add(value); }
  bool number_float(json::number_float_t value, const std::string& /*spelling*/) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(json::binary_t& value) { return add(std::move(value)); }
  bool start_object(std::size_t /*size*/) { return open(json::object()); }
  bool start_array(std::size_t /*size*/) { return open(json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& name) {
    key_ = std::move(name);
    return true;
  }
  template <class ParseError>
  bool parse_error(std::size_t position, const std::string& /*token*/, const ParseError& /*error*/) {
    error_at_ = position > 0 ? position - 1 : 0;
    return false;
  }

  [[nodiscard]] json take() { return std::move(root_); }
  [[nodiscard]] std::size_t error_at() const { return error_at_; }

 private:
  // Nothing is put into a list while something in it is open, so pointers hold.
  json* put(json value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    json& parent = *open_.back();
    if (parent.is_object()) return &(parent[key_] = std::move(value));
    parent.push_back(std::move(value));
    return &parent.back();
  }
  bool add(json value) {
    put(std::move(value));
    return true;
  }
  bool open(json value) {
    open_.push_back(put(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  json root_;
  std::vector<json*> open_;
  std::string key_;
  std::size_t error_at_ = 0;
};

}  // namespace

Result<json> read_json(std::string_view text) {
  JsonBuilder builder;
  if (json::sax_parse(text, &builder)) return builder.take();
  return Error{DiagnosticCode::InvalidArgument, text_place(text, builder.error_at()), "This is not valid JSON.", {}, {}};
}

}  // namespace marey::app
