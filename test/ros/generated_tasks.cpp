// SPDX-License-Identifier: BSD-3-Clause
#include "generated_tasks.h"

#include "generators/dialogue_tasks.h"
#include "scenario.h"

namespace goal_alignment::test {
namespace {

AlignGoal goalOf(const session::Input& input) {
  AlignGoal goal;
  goal.source = AlignGoal::TEXT;
  goal.robot_domain = input.robot_domain.text;
  goal.robot_problem = input.robot_problem.text;
  goal.human_domain = input.human_domain.text;
  goal.human_problem = input.human_problem.text;
  goal.task.person = "Ann";
  for (const GroundName& action : input.human_plan)
    goal.task.plan.push_back(step(action.name, action.arguments));
  goal.max_questions = -1;
  return goal;
}

}  // namespace

AlignGoal sweepRooms(int rooms) {
  return goalOf(benchmarks::sweptRooms(rooms));
}

AlignGoal seatGuests(int guests) {
  return goalOf(benchmarks::seatedGuests(guests));
}

AlignGoal longToRead(int rooms) {
  return goalOf(benchmarks::longText(rooms));
}

AlignGoal longToGround() {
  return goalOf(benchmarks::wideAction(32));
}

AlignGoal longToAnalyse() {
  return goalOf(benchmarks::swappedTiles(5));
}

AlignGoal longToPlan() {
  return goalOf(benchmarks::carriedBalls(24));
}

}  // namespace goal_alignment::test
