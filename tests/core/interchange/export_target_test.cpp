#include "core/interchange/export_target.h"

#include <gtest/gtest.h>

#include <set>

namespace marey {
namespace {

TEST(ExportTargets, AreFoundByTheirIdsInAnyCase) {
  EXPECT_EQ(static_cast<int>(export_targets().size()), kExportTargetCount);
  std::set<std::string_view> ids;
  for (const TargetTraits& target : export_targets()) {
    EXPECT_EQ(find_export_target(target.id), target.target);
    EXPECT_EQ(&traits_of(target.target), &target);
    ids.insert(target.id);
  }
  EXPECT_EQ(static_cast<int>(ids.size()), kExportTargetCount);
  EXPECT_EQ(find_export_target("BLENDER"), ExportTarget::Blender);
  EXPECT_FALSE(find_export_target("paint"));
}

TEST(ExportTargets, SayWhatTheyNeedAndHowThatIsKnown) {
  std::set<Requirement> needed;
  for (const TargetTraits& target : export_targets()) {
    EXPECT_TRUE(target.audience.ends_with('.')) << target.id;
    EXPECT_FALSE(target.source.empty()) << target.id;
    EXPECT_FALSE(target.needs.empty()) << target.id;
    for (const TargetNeed& need : target.needs) {
      EXPECT_TRUE(need.reason.ends_with('.')) << target.id;
      EXPECT_TRUE(target.asks_for(need.requirement));
      needed.insert(need.requirement);
    }
  }
  EXPECT_EQ(static_cast<int>(needed.size()), kRequirementCount) << "a requirement that nobody has";
  EXPECT_FALSE(traits_of(ExportTarget::Blender).asks_for(Requirement::OneRoot));
}

}  // namespace
}  // namespace marey
