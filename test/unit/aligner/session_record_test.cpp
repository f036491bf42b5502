// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/session_record.h"

#include <gtest/gtest.h>

#include "session_samples.h"

namespace goal_alignment::aligner {
namespace {

TEST(SessionRecord, labelsItsMessages) {
  SessionRecord record = samples::deskRecord();
  samples::think(record);
  const session::Snapshot now = record.session->snapshot();
  const AlignmentState state = record.stateMessage(now);
  EXPECT_EQ(state.session_id, "s1");
  EXPECT_EQ(state.person, "Ann");
  EXPECT_EQ(state.task_id, "desk");
  const AlignResult result = record.usageResult(now);
  EXPECT_EQ(result.session_id, "s1");
  EXPECT_EQ(result.failing_step, -1);
  EXPECT_EQ(result.candidates.size(), now.candidates.size());
}

TEST(SessionRecord, countsWhatEachGoalUses) {
  SessionRecord record = samples::deskRecord();
  samples::think(record);
  const session::Statistics first = record.session->statistics();
  record.usage.waiting_time = 3;
  AlignResult result = record.usageResult(record.session->snapshot());
  EXPECT_GT(result.planner_calls, 0U);
  EXPECT_EQ(result.planner_calls, first.planner_calls);
  EXPECT_EQ(result.thinking_time, first.total);
  EXPECT_EQ(result.waiting_time, 3);

  record.beginNextGoal();
  result = record.usageResult(record.session->snapshot());
  EXPECT_EQ(result.planner_calls, 0U);
  EXPECT_EQ(result.questions, 0U);
  EXPECT_EQ(result.thinking_time, 0);
  EXPECT_EQ(result.waiting_time, 0);
}

TEST(SessionRecord, saysWhereTheHumanPlanFails) {
  SessionRecord record = samples::deskRecord();
  EXPECT_EQ(record.planBreak(), "") << "not known yet";
  samples::think(record);
  EXPECT_EQ(record.planBreak(),
            "step 2 (take: b) can't be done: at that point \"free\" does not hold");
}

}  // namespace
}  // namespace goal_alignment::aligner
