#include "wasm/app/json_reading.h"

#include <gtest/gtest.h>

#include <string>

namespace marey::app {
namespace {

using Json = nlohmann::json;

TEST(JsonReading, GivesWhatTheLibraryGives) {
  for (const char* text : {"null", "true", "-12", "18446744073709551615", "0.1", "1e300", "\"a\\u00e9\\n\"", "[]", "{}", "[[], {}, [1, [2, {\"a\": []}]], 3]",
                           R"({"a": {"b": [1, {"c": null}], "d": 2}, "e": "f", "a2": [true, false]})", R"({"same": 1, "same": [2]})"}) {
    const auto read = read_json(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(*read, Json::parse(text)) << text;
    EXPECT_EQ(read->dump(), Json::parse(text).dump()) << text;
  }
}

TEST(JsonReading, SaysWhereTheTextIsNone) {
  const auto place_of = [](std::string_view text) { return read_json(text).error().place; };
  EXPECT_EQ(place_of("{\n  \"segments\": [,]\n}"), (TextPlace{2, 16}));
  EXPECT_EQ(place_of("[1, 2"), (TextPlace{1, 6}));
  EXPECT_EQ(place_of(""), (TextPlace{1, 1}));
  EXPECT_EQ(place_of("{} {}"), (TextPlace{1, 4}));
  EXPECT_FALSE(read_json("[1e400]")) << "larger than any number";
}

// Lists in lists take no stack: neither while they are read nor while they are forgotten.
TEST(JsonReading, IsAsDeepAsTheText) {
  constexpr int kDepth = 300'000;
  EXPECT_TRUE(read_json(std::string(kDepth, '[') + std::string(kDepth, ']')));
  EXPECT_FALSE(read_json(std::string(kDepth, '[')));
}

}  // namespace
}  // namespace marey::app
