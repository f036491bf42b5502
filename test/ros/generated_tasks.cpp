// SPDX-License-Identifier: BSD-3-Clause
#include "generated_tasks.h"

#include <functional>

namespace goal_alignment::test {
namespace {

// The texts of 0 … count - 1 in a row.
std::string row(int count, const std::function<std::string(const std::string&)>& text) {
  std::string result;
  for (int i = 0; i < count; ++i)
    result += text(std::to_string(i)) + " ";
  return result;
}

AlignGoal taskOf(const std::string& robot_domain, const std::string& human_domain,
                 const std::string& problem, const std::vector<PlanStep>& plan) {
  AlignGoal goal;
  goal.source = AlignGoal::TEXT;
  goal.robot_domain = robot_domain;
  goal.human_domain = human_domain;
  goal.robot_problem = goal.human_problem = problem;
  goal.task.person = "Ann";
  goal.task.plan = plan;
  goal.max_questions = -1;
  return goal;
}

std::string problemOf(const std::string& objects, const std::string& init,
                      const std::string& goal) {
  return "(define (problem generated) (:domain generated) (:objects " + objects + ") (:init " +
         init + ") (:goal (and " + goal + ")))";
}

// An action that takes what `loses` says away.
std::string sweeping(const std::string& loses) {
  return R"((define (domain generated)
  (:predicates (room ?r) (clean ?r) (quiet ?r))
  (:action sweep :parameters (?r) :precondition (room ?r) :effect (and (clean ?r) )" +
         loses + ")))";
}

std::string pigeons(const std::string& loses) {
  return R"((define (domain generated)
  (:predicates (waiting ?p) (free ?h) (housed ?p) (in ?p ?h))
  (:action enter :parameters (?p ?h) :precondition (and (waiting ?p) (free ?h))
    :effect (and (housed ?p) (in ?p ?h) (not (waiting ?p)) )" +
         loses + R"())
  (:action leave :parameters (?p ?h) :precondition (in ?p ?h)
    :effect (and (waiting ?p) (free ?h) (not (housed ?p)) (not (in ?p ?h))))))";
}

}  // namespace

AlignGoal sweepRooms(int rooms) {
  const auto objects = row(rooms, [](const auto& i) { return "r" + i; });
  const auto init =
      row(rooms, [](const auto& i) { return "(room r" + i + ") (quiet r" + i + ")"; });
  const auto goal = row(rooms, [](const auto& i) { return "(clean r" + i + ")"; });
  std::vector<PlanStep> plan;
  for (int i = 0; i < rooms; ++i)
    plan.push_back(step("sweep", {"r" + std::to_string(i)}));
  return taskOf(sweeping("(not (quiet ?r))"), sweeping(""), problemOf(objects, init, goal), plan);
}

AlignGoal longToRead() {
  constexpr int kRooms = 200'000;
  const auto objects = row(kRooms, [](const auto& i) { return "r" + i; });
  const auto init = row(kRooms, [](const auto& i) { return "(room r" + i + ")"; });
  return taskOf(sweeping("(not (quiet ?r))"), sweeping(""), problemOf(objects, init, "(clean r0)"),
                {step("sweep", {"r0"})});
}

AlignGoal longToGround() {
  constexpr int kRooms = 32;
  const std::string domain = R"((define (domain generated)
  (:predicates (room ?r) (clean ?r) (toured ?a ?b ?c ?d ?e ?f))
  (:action sweep :parameters (?r) :precondition (room ?r) :effect (clean ?r))
  (:action tour :parameters (?a ?b ?c ?d ?e ?f)
    :precondition (and (room ?a) (room ?b) (room ?c) (room ?d) (room ?e) (room ?f))
    :effect (toured ?a ?b ?c ?d ?e ?f))))";
  const auto objects = row(kRooms, [](const auto& i) { return "r" + i; });
  const auto init = row(kRooms, [](const auto& i) { return "(room r" + i + ")"; });
  return taskOf(domain, domain, problemOf(objects, init, "(clean r0)"), {step("sweep", {"r0"})});
}

AlignGoal longToAnalyse() {
  constexpr int kHoles = 15;
  constexpr int kPigeons = kHoles + 1;
  const auto objects = row(kPigeons, [](const auto& i) { return "p" + i; }) +
                       row(kHoles, [](const auto& i) { return "h" + i; });
  const auto init = row(kPigeons, [](const auto& i) { return "(waiting p" + i + ")"; }) +
                    row(kHoles, [](const auto& i) { return "(free h" + i + ")"; });
  std::vector<PlanStep> plan;
  for (int i = 0; i < kPigeons; ++i)
    plan.push_back(step("enter", {"p" + std::to_string(i), "h0"}));
  return taskOf(pigeons("(not (free ?h))"), pigeons(""), problemOf(objects, init, "(housed p0)"),
                plan);
}

AlignGoal longToPlan() {
  constexpr int kBalls = 24;
  const std::string domain = R"((define (domain generated)
  (:predicates (room ?r) (ball ?b) (hand ?h) (here ?r) (lies ?b ?r) (free ?h) (holds ?h ?b))
  (:action move :parameters (?from ?to) :precondition (and (room ?from) (room ?to) (here ?from))
    :effect (and (here ?to) (not (here ?from))))
  (:action pick :parameters (?b ?r ?h)
    :precondition (and (ball ?b) (room ?r) (hand ?h) (lies ?b ?r) (here ?r) (free ?h))
    :effect (and (holds ?h ?b) (not (lies ?b ?r)) (not (free ?h))))
  (:action drop :parameters (?b ?r ?h)
    :precondition (and (ball ?b) (room ?r) (hand ?h) (holds ?h ?b) (here ?r))
    :effect (and (lies ?b ?r) (free ?h) (not (holds ?h ?b))))))";
  const auto balls = row(kBalls, [](const auto& i) { return "b" + i; });
  const auto init =
      row(kBalls, [](const auto& i) { return "(ball b" + i + ") (lies b" + i + " here0)"; });
  const auto goal = row(kBalls, [](const auto& i) { return "(lies b" + i + " there0)"; });
  std::vector<PlanStep> plan;
  for (int i = 0; i < kBalls; ++i) {
    const std::string ball = "b" + std::to_string(i);
    plan.push_back(step("pick", {ball, "here0", "left"}));
    plan.push_back(step("move", {"here0", "there0"}));
    plan.push_back(step("drop", {ball, "there0", "left"}));
    plan.push_back(step("move", {"there0", "here0"}));
  }
  return taskOf(domain, domain,
                problemOf(balls + "here0 there0 left right",
                          init + "(room here0) (room there0) (hand left) (hand right) (free left) "
                                 "(free right) (here here0)",
                          goal),
                plan);
}

}  // namespace goal_alignment::test
