// SPDX-License-Identifier: BSD-3-Clause
// Aligns one instance folder with the core, the answers being those of a person who wants all that
// the robot asks about. Exit status 0: the session came to an outcome.
#include <goal_alignment/AlignAction.h>

#include <iostream>
#include <string>

#include "goal_alignment/pddl/parser.h"
#include "goal_alignment/session/session.h"

using namespace goal_alignment;  // NOLINT(google-build-using-namespace): a main of one file

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: consumer INSTANCE_FOLDER\n";
    return 2;
  }
  const std::string folder = std::string(argv[1]) + "/";
  session::Input input;
  input.robot_domain = pddl::readFile(folder + "robot_domain.pddl");
  input.robot_problem = pddl::readFile(folder + "robot_problem.pddl");
  input.human_domain = pddl::readFile(folder + "human_domain.pddl");
  input.human_problem = pddl::readFile(folder + "human_problem.pddl");
  input.human_plan = pddl::parsePlan(pddl::readFile(folder + "human_plan.txt")).steps;

  session::Session session{session::Options{}};
  session.begin(input);
  while (session.step() != session::State::Done) {
    if (session.state() != session::State::AwaitingAnswer) continue;
    for (const Literal& fluent : session.question()->fluents)
      session.answer({fluent}, session::AnswerKind::Yes, "consumer");
  }
  AlignResult result;
  result.outcome = static_cast<AlignResult::_outcome_type>(session.outcome().code);
  std::cout << "outcome " << result.outcome << ": " << session.outcome().message << '\n';
  return result.outcome == AlignResult::NONE ? 1 : 0;
}
