// SPDX-License-Identifier: BSD-3-Clause
#include "dialogue_tasks.h"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "pddl_text.h"

namespace goal_alignment::benchmarks {
namespace {

// The texts of 0 … count - 1 in a row.
std::string row(int count, const std::function<std::string(const std::string&)>& text) {
  std::string result;
  for (int i = 0; i < count; ++i)
    result += text(std::to_string(i)) + " ";
  return result;
}

session::Input taskOf(const std::string& robot_domain, const std::string& human_domain,
                      const std::string& problem, std::vector<GroundName> plan) {
  session::Input input;
  input.robot_domain = {"robot_domain", robot_domain};
  input.human_domain = {"human_domain", human_domain};
  input.robot_problem = {"robot_problem", problem};
  input.human_problem = {"human_problem", problem};
  input.human_plan = std::move(std::move(plan));
  return input;
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

// Tiles slide to where no tile is; only the person believes that two may change places.
std::string tiles(const std::string& more) {
  return R"((define (domain generated)
  (:predicates (tile ?t) (beside ?a ?b) (at ?t ?c) (blank ?c))
  (:action slide :parameters (?t ?from ?to)
    :precondition (and (tile ?t) (at ?t ?from) (blank ?to) (beside ?from ?to))
    :effect (and (at ?t ?to) (blank ?from) (not (at ?t ?from)) (not (blank ?to)))) )" +
         more + ")";
}

std::string party(const std::string& condition) {
  return R"((define (domain party)
    (:predicates (guest ?g) (chair ?c) (free ?c) (seated ?g))
    (:action seat :parameters (?g ?c)
      :precondition (and (guest ?g) (chair ?c))" +
         condition + R"() :effect (and (seated ?g) (not (free ?c))))))";
}

}  // namespace

session::Input seatedGuests(int guests) {
  std::string objects = "spare";
  std::string init = "(chair spare)";
  std::vector<GroundName> plan;
  for (int i = 0; i < guests; ++i) {
    const std::string guest = numbered("g", i);
    objects += " " + guest;
    init += " (guest " + guest + ")";
    plan.push_back({"seat", {guest, numbered("c", std::max(0, i - 1))}});
    if (i == 0) continue;
    const std::string chair = numbered("c", i - 1);
    objects += " " + chair;
    init.append(" (chair ").append(chair).append(") (free ").append(chair).append(")");
  }
  return taskOf(party(" (free ?c)"), party(""),
                "(define (problem evening) (:domain party) (:objects " + objects + ") (:init " +
                    init + ") (:goal (seated g0)))",
                std::move(plan));
}

session::Input sweptRooms(int rooms) {
  const auto objects = row(rooms, [](const auto& i) { return "r" + i; });
  const auto init =
      row(rooms, [](const auto& i) { return "(room r" + i + ") (quiet r" + i + ")"; });
  const auto goal = row(rooms, [](const auto& i) { return "(clean r" + i + ")"; });
  std::vector<GroundName> plan;
  for (int i = 0; i < rooms; ++i)
    plan.push_back(GroundName{"sweep", {"r" + std::to_string(i)}});
  return taskOf(sweeping("(not (quiet ?r))"), sweeping(""), problemOf(objects, init, goal),
                std::move(plan));
}

session::Input longText(int rooms) {
  const auto objects = row(rooms, [](const auto& i) { return "r" + i; });
  const auto init = row(rooms, [](const auto& i) { return "(room r" + i + ")"; });
  return taskOf(sweeping("(not (quiet ?r))"), sweeping(""), problemOf(objects, init, "(clean r0)"),
                {GroundName{"sweep", {"r0"}}});
}

session::Input wideAction(int rooms) {
  const std::string domain = R"((define (domain generated)
  (:predicates (room ?r) (clean ?r) (toured ?a ?b ?c ?d ?e ?f))
  (:action sweep :parameters (?r) :precondition (room ?r) :effect (clean ?r))
  (:action tour :parameters (?a ?b ?c ?d ?e ?f)
    :precondition (and (room ?a) (room ?b) (room ?c) (room ?d) (room ?e) (room ?f))
    :effect (toured ?a ?b ?c ?d ?e ?f))))";
  const auto objects = row(rooms, [](const auto& i) { return "r" + i; });
  const auto init = row(rooms, [](const auto& i) { return "(room r" + i + ")"; });
  return taskOf(domain, domain, problemOf(objects, init, "(clean r0)"),
                {GroundName{"sweep", {"r0"}}});
}

session::Input swappedTiles(int side) {
  const auto cell = [&](int row, int column) { return "c" + std::to_string(row * side + column); };
  std::string init = "(blank " + cell(0, 0) + ") ";
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k + 1 < side; ++k) {
      const std::string across = cell(i, k) + " " + cell(i, k + 1);
      const std::string back = cell(i, k + 1) + " " + cell(i, k);
      const std::string down = cell(k, i) + " " + cell(k + 1, i);
      const std::string up = cell(k + 1, i) + " " + cell(k, i);
      for (const std::string& pair : {across, back, down, up})
        init += "(beside " + pair + ") ";
    }
  }
  std::string objects = "c0";
  for (int i = 1; i < side * side; ++i) {
    const std::string number = std::to_string(i);
    objects += " t" + number + " c" + number;
    init += "(tile t" + number + ") (at t" + number + " c" + number + ") ";
  }
  const std::string swap = R"((:action swap :parameters (?s ?t ?a ?b)
    :precondition (and (at ?s ?a) (at ?t ?b) (beside ?a ?b))
    :effect (and (at ?s ?b) (at ?t ?a) (not (at ?s ?a)) (not (at ?t ?b)))))";
  return taskOf(tiles(""), tiles(swap), problemOf(objects, init, "(at t1 c2)"),
                {GroundName{"swap", {"t1", "t2", "c1", "c2"}}});
}

session::Input carriedBalls(int balls) {
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
  const auto objects = row(balls, [](const auto& i) { return "b" + i; });
  const auto init =
      row(balls, [](const auto& i) { return "(ball b" + i + ") (lies b" + i + " here0)"; });
  const auto goal = row(balls, [](const auto& i) { return "(lies b" + i + " there0)"; });
  std::vector<GroundName> plan;
  for (int i = 0; i < balls; ++i) {
    const std::string ball = "b" + std::to_string(i);
    plan.push_back(GroundName{"pick", {ball, "here0", "left"}});
    plan.push_back(GroundName{"move", {"here0", "there0"}});
    plan.push_back(GroundName{"drop", {ball, "there0", "left"}});
    plan.push_back(GroundName{"move", {"there0", "here0"}});
  }
  return taskOf(domain, domain,
                problemOf(objects + "here0 there0 left right",
                          init + "(room here0) (room there0) (hand left) (hand right) (free left) "
                                 "(free right) (here here0)",
                          goal),
                std::move(plan));
}

}  // namespace goal_alignment::benchmarks
