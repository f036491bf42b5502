// SPDX-License-Identifier: BSD-3-Clause
#include "guests.h"

#include <algorithm>

#include "scenario.h"

namespace goal_alignment::test {
namespace {

std::string party(const std::string& condition) {
  return R"((define (domain party)
    (:predicates (guest ?g) (chair ?c) (free ?c) (seated ?g))
    (:action seat :parameters (?g ?c)
      :precondition (and (guest ?g) (chair ?c))" +
         condition + R"() :effect (and (seated ?g) (not (free ?c))))))";
}

std::string numbered(const std::string& letter, int number) {
  return letter + std::to_string(number);
}

}  // namespace

AlignGoal seatGuests(int guests) {
  AlignGoal goal;
  goal.source = AlignGoal::TEXT;
  goal.task.person = "Ann";
  goal.max_questions = -1;
  std::string objects = "spare";
  std::string init = "(chair spare)";
  for (int i = 0; i < guests; ++i) {
    const std::string guest = numbered("g", i);
    objects += " " + guest;
    init += " (guest " + guest + ")";
    goal.task.plan.push_back(step("seat", {guest, numbered("c", std::max(0, i - 1))}));
    if (i == 0) continue;
    const std::string chair = numbered("c", i - 1);
    objects += " " + chair;
    init.append(" (chair ").append(chair).append(") (free ").append(chair).append(")");
  }
  goal.robot_problem = "(define (problem evening) (:domain party) (:objects " + objects +
                       ") (:init " + init + ") (:goal (seated g0)))";
  goal.human_problem = goal.robot_problem;
  goal.robot_domain = party(" (free ?c)");
  goal.human_domain = party("");
  return goal;
}

}  // namespace goal_alignment::test
