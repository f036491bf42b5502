// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/parser.h"

/// A task small enough to work out by hand; the tests of `alignment` and `session` share it.
///
/// The robot has one hand; the human believes that it can take one thing after the other, and that
/// what it takes stays down as well. The goal is (down b), the plan takes a and b. So S^H holds
/// besides: (down a) (down c) (free) (held a) (held b) (red a); and with (down b) the robot can't
/// have
/// {(held b)}, nor {(held a), (free)}, nor {(held a), (down a)}. (down c) and (red a) are never in
/// the way.
namespace goal_alignment::samples {

inline const std::string kDeskRobotDomain = R"((define (domain desk)
  (:predicates (free) (held ?x) (down ?x) (red ?x))
  (:action take :parameters (?x) :precondition (and (free) (down ?x))
    :effect (and (held ?x) (not (free)) (not (down ?x))))
  (:action put :parameters (?x) :precondition (held ?x)
    :effect (and (down ?x) (free) (not (held ?x))))))";

inline const std::string kDeskHumanDomain = R"((define (domain desk)
  (:predicates (free) (held ?x) (down ?x) (red ?x))
  (:action take :parameters (?x) :precondition (and (free) (down ?x)) :effect (held ?x))
  (:action put :parameters (?x) :precondition (held ?x)
    :effect (and (down ?x) (free) (not (held ?x))))))";

inline const std::string kDeskProblem = R"((define (problem two) (:domain desk)
  (:objects A B C)
  (:init (free) (down a) (down b) (down c) (red a))
  (:goal (down b))))";

inline pddl::Model deskRobot() {
  return pddl::readModel({"robot_domain.pddl", kDeskRobotDomain},
                         {"robot_problem.pddl", kDeskProblem});
}

inline pddl::Model deskHuman() {
  return pddl::readModel({"human_domain.pddl", kDeskHumanDomain},
                         {"human_problem.pddl", kDeskProblem});
}

inline std::vector<GroundName> deskPlan() {
  return {{"take", {"a"}}, {"take", {"b"}}};
}

}  // namespace goal_alignment::samples
