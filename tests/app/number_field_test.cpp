#include <gtest/gtest.h>

#include <vector>

#include "tests/app/support/widget_stage.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

using ui::NumberEvent;

// A number that takes every change, as a document under apply_gesture does.
class NumberField : public testing::Test {
 protected:
  void take(const ui::NumberResult& result) {
    if (result.event == NumberEvent::None) return;
    events_.push_back(result);
    value_ = result.value;
  }

  [[nodiscard]] std::vector<ui::NumberResult> events_of(NumberEvent kind) const {
    std::vector<ui::NumberResult> found;
    for (const auto& event : events_) {
      if (event.event == kind) found.push_back(event);
    }
    return found;
  }

  double value_ = 10.0;
  std::vector<ui::NumberResult> events_;
  ui::NumberFormat format_{.unit = "°", .decimals = 1, .step = 0.5, .low = -100.0, .high = 100.0};
  WidgetStage stage_{[this](ViewContext& context) {
    take(ui::number_field(context, "field", "Angle", value_, format_));
    ui::text_button(context, "other", "Other", "Nothing.");
  }};
};

TEST_F(NumberField, DragIsOneGestureThatEndsCommitted) {
  stage_.move_to("field");
  stage_.button(true);
  for (int i = 0; i < 10; ++i) stage_.move_by(ImVec2(2.0f, 0.0f));
  stage_.button(false);
  stage_.frame(2);
  EXPECT_DOUBLE_EQ(value_, 20.0);
  ASSERT_FALSE(events_of(NumberEvent::Live).empty());
  ASSERT_EQ(events_of(NumberEvent::Committed).size(), 1u);
  for (const auto& event : events_) EXPECT_EQ(event.gesture, events_.front().gesture);
  EXPECT_NE(events_.front().gesture, 0u);
}

TEST_F(NumberField, TwoDragsAreTwoGestures) {
  for (int drag = 0; drag < 2; ++drag) {
    stage_.move_to("field");
    stage_.button(true);
    for (int i = 0; i < 4; ++i) stage_.move_by(ImVec2(3.0f, 0.0f));
    stage_.button(false);
    stage_.frame(40);
  }
  const auto committed = events_of(NumberEvent::Committed);
  ASSERT_EQ(committed.size(), 2u);
  EXPECT_NE(committed[0].gesture, committed[1].gesture);
}

TEST_F(NumberField, AClickChangesNothing) {
  stage_.click("field");
  EXPECT_TRUE(events_.empty());
}

TEST_F(NumberField, EscapeDuringADragGivesTheOldValueBack) {
  stage_.move_to("field");
  stage_.button(true);
  for (int i = 0; i < 5; ++i) stage_.move_by(ImVec2(4.0f, 0.0f));
  EXPECT_NE(value_, 10.0);
  stage_.press(ImGuiKey_Escape);
  ASSERT_EQ(events_of(NumberEvent::Cancelled).size(), 1u);
  EXPECT_DOUBLE_EQ(value_, 10.0);
  stage_.move_by(ImVec2(30.0f, 0.0f));
  stage_.button(false);
  stage_.frame(2);
  EXPECT_DOUBLE_EQ(value_, 10.0);
}

TEST_F(NumberField, DragStopsAtTheBounds) {
  stage_.move_to("field");
  stage_.button(true);
  for (int i = 0; i < 30; ++i) stage_.move_by(ImVec2(20.0f, 0.0f));
  EXPECT_DOUBLE_EQ(value_, 100.0);
  stage_.button(false);
}

TEST_F(NumberField, DoubleClickTypes) {
  stage_.double_click("field");
  stage_.type("-42,5");
  stage_.press(ImGuiKey_Enter);
  ASSERT_EQ(events_.size(), 1u);
  EXPECT_EQ(events_[0].event, NumberEvent::Committed);
  EXPECT_DOUBLE_EQ(value_, -42.5);
}

TEST_F(NumberField, EscapeLeavesTypingWithoutAChange) {
  stage_.double_click("field");
  stage_.type("7");
  stage_.press(ImGuiKey_Escape);
  stage_.frame(4);
  EXPECT_TRUE(events_.empty());
  EXPECT_DOUBLE_EQ(value_, 10.0);
}

TEST_F(NumberField, AClickElsewhereKeepsWhatWasTyped) {
  stage_.double_click("field");
  stage_.type("33");
  stage_.click("other");
  stage_.frame(3);
  EXPECT_DOUBLE_EQ(value_, 33.0);
}

TEST_F(NumberField, WhatIsNoNumberIsSaidAndChangesNothing) {
  stage_.double_click("field");
  stage_.type("ten");
  stage_.press(ImGuiKey_Enter);
  EXPECT_TRUE(events_.empty());
  EXPECT_NE(stage_.status().find("ten"), std::string::npos);
}

TEST_F(NumberField, ArrowKeysStepTheFocusedFieldInOneGesture) {
  stage_.click("field");
  stage_.frame(40);
  stage_.press(ImGuiKey_UpArrow);
  stage_.press(ImGuiKey_UpArrow);
  stage_.press(ImGuiKey_DownArrow);
  EXPECT_DOUBLE_EQ(value_, 10.5);
  ASSERT_EQ(events_.size(), 3u);
  EXPECT_EQ(events_[0].gesture, events_[2].gesture);
}

TEST_F(NumberField, ArrowKeysDoNothingWithoutTheFocus) {
  stage_.press(ImGuiKey_UpArrow);
  EXPECT_TRUE(events_.empty());
}

TEST_F(NumberField, TabAndEnterReachItWithoutAMouse) {
  stage_.press(ImGuiKey_Tab);
  stage_.press(ImGuiKey_Enter);
  stage_.frame(3);
  stage_.type("5");
  stage_.press(ImGuiKey_Enter);
  EXPECT_DOUBLE_EQ(value_, 5.0);
}

}  // namespace
}  // namespace marey::app
