#include "wasm/app/preferences.h"

#include <gtest/gtest.h>

namespace marey::app {
namespace {

TEST(Preferences, ComeBackAsWritten) {
  Preferences preferences;
  preferences.theme = ThemeChoice::Light;
  preferences.sizes.outliner_width = 312.0f;
  preferences.options.interface_scale = 1.75f;
  preferences.options.show_strobe = true;
  preferences.sheet = Sheet::Inspector;
  preferences.welcome_seen = true;
  const Preferences read = read_preferences(write_preferences(preferences));
  EXPECT_EQ(read.theme, ThemeChoice::Light);
  EXPECT_EQ(read.sizes.outliner_width, 312.0f);
  EXPECT_EQ(read.options.interface_scale, 1.75f);
  EXPECT_TRUE(read.options.show_strobe);
  EXPECT_EQ(read.sheet, Sheet::Inspector);
  EXPECT_TRUE(read.welcome_seen);
  EXPECT_EQ(write_preferences(read), write_preferences(preferences));
}

TEST(Preferences, RubbishGivesTheDefaults) {
  const std::string usual = write_preferences({});
  for (const char* text : {"", "null", "[1,2]", "{", "\"dark\"", "{\"theme\":7,\"sheet\":\"x\",\"outlinerWidth\":\"wide\"}",
                           "{\"sheet\":99}", "{\"sheet\":-1}"}) {
    EXPECT_EQ(write_preferences(read_preferences(text)), usual) << text;
  }
}

TEST(Preferences, NumbersAreBroughtIntoTheirRange) {
  const Preferences read = read_preferences(R"({"interfaceScale":40,"falloffRadiusFrames":-3,"curvesHeight":-5})");
  EXPECT_EQ(read.options.interface_scale, kLargestInterfaceScale);
  EXPECT_GE(read.options.falloff_radius_frames, 0.0f);
  EXPECT_GT(read.sizes.curves_height, 0.0f);
}

}  // namespace
}  // namespace marey::app
