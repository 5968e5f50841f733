#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/editing/clip_operations.h"
#include "tests/core/bvh/bvh_texts.h"

namespace marey::test {
namespace {

// Each row is written in a way of its own.
const std::vector<std::string> kRows = {"1.0 2 3.00\n", "4.50  5e0 6\n", "\t7 +8 9.000\n", "10\t11 12.5\n", "13.0 14 15.00\n"};

std::string file_of(const std::vector<std::string>& rows) {
  std::string text;
  for (const std::string& row : rows) text += row;
  return one_joint_file(std::to_string(rows.size()), text);
}

TEST(FramesLeftOut, LeaveTheBytesOfAllOthers) {
  const int count = size_of(kRows);
  for (int first = 0; first < count; ++first) {
    for (int removed = 1; removed <= count - first && removed < count; ++removed) {
      Document document(read_or_fail(file_of(kRows)), "rows.bvh");
      ASSERT_TRUE(document.apply(make_remove_frames_edit({first, removed})));
      std::vector<std::string> left = kRows;
      left.erase(left.begin() + first, left.begin() + first + removed);
      // What stood between the header and the first number is part of the header.
      if (first == 0 && left[0][0] == '\t') left[0].erase(0, 1);
      EXPECT_EQ(document.save_text(), file_of(left)) << first << " " << removed;
      ASSERT_TRUE(document.undo());
      EXPECT_EQ(document.save_text(), file_of(kRows));
    }
  }
}

TEST(FramesLeftOut, KeepTheirBytesWhenAnEditFollows) {
  Document document(read_or_fail(file_of(kRows)), "rows.bvh");
  ASSERT_TRUE(document.apply(make_remove_frames_edit({1, 1})));
  ASSERT_TRUE(document.apply(make_remove_frames_edit({1, 1})));
  EXPECT_EQ(document.save_text(), file_of({kRows[0], kRows[3], kRows[4]}));
}

TEST(FramesBeyondTheCount, AreTakenAndTheCountIsTold) {
  const BvhClip more = read_or_fail(one_joint_file("2", "1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_EQ(more.motion.frame_count(), 3);
  EXPECT_EQ(more.declared_frames, 2);
  EXPECT_EQ(read_or_fail(one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n")).declared_frames, 0);
  EXPECT_EQ(read_or_fail(one_joint_file("4", "1 2 3\n4 5 6\n7 8 9\n")).declared_frames, 0);
}

}  // namespace
}  // namespace marey::test
