#include "wasm/app/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace marey::app {
namespace {

TEST(NumberText, ShowsFixedDecimalsAndNoNegativeZero) {
  EXPECT_EQ(displayed_number(12.3456, 2), "12.35");
  EXPECT_EQ(displayed_number(-0.0001, 2), "0.00");
  EXPECT_EQ(displayed_number(-0.01, 2), "-0.01");
  EXPECT_EQ(displayed_number(7.0, 0), "7");
  EXPECT_EQ(displayed_number(std::numeric_limits<double>::quiet_NaN(), 2), "–");
}

TEST(NumberText, ReadsWhatPeopleType) {
  EXPECT_EQ(read_typed_number("12.5", "°"), 12.5);
  EXPECT_EQ(read_typed_number(" -3,25 ° ", "°"), -3.25);
  EXPECT_EQ(read_typed_number("+4", ""), 4.0);
  EXPECT_EQ(read_typed_number("1e3 units", "units"), 1000.0);
}

TEST(NumberText, RefusesWhatIsNoNumber) {
  for (const char* text : {"", " ", "abc", "12 apples", "1.2.3", "nan", "inf", "--4", "1e999"}) {
    EXPECT_FALSE(read_typed_number(text, "°")) << text;
  }
}

TEST(NumberText, EditableTextReadsBackTheSameBits) {
  for (const double value : {93.042686, -1.0 / 3.0, 1e-9, 123456789.125}) {
    EXPECT_EQ(read_typed_number(editable_number(value), ""), value);
  }
}

}  // namespace
}  // namespace marey::app
