// SPDX-License-Identifier: BSD-3-Clause
// The recorded dialogue that comes with the package, played into the panel by replay.launch.
#include <QTabWidget>

#include "rviz_scenario.h"

namespace goal_alignment::test {
namespace {

class Replay : public RvizScenario {};

TEST_F(Replay, aRecordedDialogueIsShownAndCanNotBeAnswered) {
  ASSERT_NO_FATAL_FAILURE(startRviz(configFor({"goal_alignment"})));
  ASSERT_TRUE(asks("matter"))
      << "the recording has another format: scripts/screenshots makes it anew";
  EXPECT_FALSE(part("yes")->isEnabled());
  EXPECT_TRUE(comesTrue([this] { return textOf("status").contains("A recording"); }));
  EXPECT_EQ(textOf("title"), "Tea, for Ada");
  savePicture("replay");
  EXPECT_TRUE(
      comesTrue([this] { return part<QTabWidget>("tabs")->tabText(2).startsWith("Plan ("); }, 120));
  EXPECT_FALSE(part("cancel")->isEnabled());
}

}  // namespace
}  // namespace goal_alignment::test
