// SPDX-License-Identifier: BSD-3-Clause
#include "hard_tasks.h"

#include <string>

namespace goal_alignment::benchmarks {
namespace {

std::string named(const std::string& name, int i) {
  return name + std::to_string(i);
}

std::string allOf(const std::string& name, int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += " " + named(name, i);
  return text;
}

session::Input withOneDomain(const std::string& domain, const std::string& problem) {
  session::Input input;
  input.robot_domain = {"robot_domain", domain};
  input.human_domain = {"human_domain", domain};
  input.robot_problem = {"robot_problem", problem};
  input.human_problem = {"human_problem", problem};
  return input;
}

}  // namespace

session::Input longText(int facts) {
  std::string problem =
      "(define (problem long) (:domain text) (:objects" + allOf("o", facts) + ")\n(:init";
  for (int i = 0; i < facts; ++i)
    problem += " (next " + named("o", i) + " " + named("o", (i + 1) % facts) + ")\n";
  problem += ")\n(:goal (at o1)))";
  session::Input input = withOneDomain(
      "(define (domain text) (:predicates (next ?a ?b) (at ?a))"
      " (:action go :parameters (?a ?b) :precondition (next ?a ?b) :effect (at ?b)))",
      problem);
  input.human_plan = {GroundName::parse("(go o0 o1)")};
  return input;
}

session::Input wideAction(int objects) {
  std::string problem =
      "(define (problem wide) (:domain join) (:objects" + allOf("o", objects) + ")\n(:init";
  for (int i = 0; i < objects; ++i)
    problem += " (free " + named("o", i) + ")";
  problem += ")\n(:goal (met o0 o1)))";
  session::Input input = withOneDomain(
      "(define (domain join) (:predicates (free ?a) (met ?a ?b))"
      " (:action meet :parameters (?a ?b ?c ?d ?e)"
      " :precondition (and (free ?a) (free ?b) (free ?c) (free ?d) (free ?e))"
      " :effect (and (met ?a ?b) (met ?c ?d) (not (free ?e)))))",
      problem);
  input.human_plan = {GroundName::parse("(meet o0 o1 o2 o3 o4)")};
  return input;
}

session::Input tooFewPegs(int pegs) {
  const auto domain = [](const std::string& takes) {
    return "(define (domain pegs) (:requirements :typing) (:types ring peg)"
           " (:predicates (loose ?r - ring) (on ?r - ring ?p - peg) (hung ?r - ring)"
           " (free ?p - peg) (ready))"
           " (:action hang :parameters (?r - ring ?p - peg)"
           " :precondition (and (loose ?r) (free ?p))"
           " :effect (and (hung ?r) (on ?r ?p) (not (loose ?r)) " +
           takes +
           "))"
           " (:action take :parameters (?r - ring ?p - peg) :precondition (on ?r ?p)"
           " :effect (and (loose ?r) (free ?p) (not (on ?r ?p)) (not (hung ?r))))"
           " (:action tidy :parameters () :effect (ready)))";
  };
  std::string problem = "(define (problem too-few) (:domain pegs) (:objects" +
                        allOf("r", pegs + 1) + " - ring" + allOf("p", pegs) + " - peg)\n(:init";
  for (int i = 0; i <= pegs; ++i)
    problem += " (loose " + named("r", i) + ")";
  for (int i = 0; i < pegs; ++i)
    problem += " (free " + named("p", i) + ")";
  problem += ")\n(:goal (ready)))";
  session::Input input = withOneDomain(domain("(not (free ?p))"), problem);
  input.human_domain.text = domain("");
  for (int i = 0; i <= pegs; ++i)
    input.human_plan.push_back({"hang", {named("r", i), "p" + std::to_string(i % pegs)}});
  input.human_plan.push_back({"tidy", {}});
  return input;
}

session::Input turnedTower(int blocks) {
  std::string init = " (on b0 table) (clear " + named("b", blocks - 1) + ")";
  std::string goal = " (on " + named("b", blocks - 1) + " table)";
  session::Input input;
  std::vector<GroundName> plan;
  for (int i = 1; i < blocks; ++i) {
    init += " (on " + named("b", i) + " " + named("b", i - 1) + ")";
    goal += " (on " + named("b", i - 1) + " " + named("b", i) + ")";
  }
  plan.push_back({"to-table", {named("b", blocks - 1), named("b", blocks - 2)}});
  for (int i = blocks - 2; i > 0; --i)
    plan.push_back({"move", {named("b", i), named("b", i - 1), named("b", i + 1)}});
  plan.push_back({"from-table", {"b0", "b1"}});
  const std::string problem = "(define (problem turn) (:domain tower) (:objects" +
                              allOf("b", blocks) + ")\n(:init" + init + ")\n(:goal (and" + goal +
                              ")))";
  input = withOneDomain(
      "(define (domain tower) (:requirements :equality) (:constants table)"
      " (:predicates (on ?a ?b) (clear ?a))"
      " (:action move :parameters (?a ?b ?c) :precondition (and (on ?a ?b) (clear ?a) (clear ?c)"
      " (not (= ?b table)) (not (= ?a ?c))) :effect (and (on ?a ?c) (clear ?b) (not (on ?a ?b))"
      " (not (clear ?c))))"
      " (:action to-table :parameters (?a ?b) :precondition (and (on ?a ?b) (clear ?a)"
      " (not (= ?b table))) :effect (and (on ?a table) (clear ?b) (not (on ?a ?b))))"
      " (:action from-table :parameters (?a ?c) :precondition (and (on ?a table) (clear ?a)"
      " (clear ?c) (not (= ?a ?c))) :effect (and (on ?a ?c) (not (on ?a table))"
      " (not (clear ?c)))))",
      problem);
  input.human_plan = std::move(plan);
  return input;
}

}  // namespace goal_alignment::benchmarks
