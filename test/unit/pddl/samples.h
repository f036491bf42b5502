// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "goal_alignment/pddl/exceptions.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/parser.h"

/// What the tests of `pddl` and `validation` share: one small task and ways to get at errors.
namespace goal_alignment::pddl::samples {

/// Uses types, constants, costs, equality and negation, in mixed case.
inline const std::string kTeaDomain = R"((define (domain Tea)
  (:requirements :strips :typing)
  (:types cup kettle - vessel vessel place)
  (:constants Table - place)
  (:predicates (at ?v - vessel ?p - place) (hot ?k - kettle) (full ?v - vessel) (HandEmpty))
  (:functions (total-cost) - number (way ?from ?to - place) - number)
  (:action Heat
    :parameters (?k - kettle)
    :precondition (and (at ?k Table) (not (hot ?k)))
    :effect (and (hot ?k) (increase (total-cost) 5)))
  (:action pour
    :parameters (?k - kettle ?c - cup)
    :precondition (and (hot ?k) (not (full ?c)))
    :effect (and (full ?c) (not (hot ?k))))
  (:action move
    :parameters (?v - vessel ?from ?to - place)
    :precondition (and (HandEmpty) (at ?v ?from) (not (= ?from ?to)))
    :effect (and (not (at ?v ?from)) (at ?v ?to) (increase (total-cost) (way ?from ?to))))
))";

inline const std::string kTeaProblem = R"((define (problem two-cups)
  (:domain tea)
  (:objects Mug glass - cup Pot - kettle shelf - place)
  (:init (HandEmpty) (at Pot shelf) (at Mug table) (at glass table)
    (= (total-cost) 0) (= (way shelf table) 3) (= (way table shelf) 4))
  (:goal (and (full mug) (not (hot pot))))
  (:metric minimize (total-cost))))";

/// A part of an ast, with the text that its names point into.
template <typename Part>
struct Held : Part {
  std::shared_ptr<const Source> source;
};

template <typename Part>
Held<Part> held(const Part& part, const std::shared_ptr<const Source>& source) {
  return {part, source};
}

inline Model tea() {
  return readModel({"tea.pddl", kTeaDomain}, {"two-cups.pddl", kTeaProblem});
}

/// The text with the first `from` replaced: a fault put into a good sample.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the sample has no '" + from + "'");
  return text.replace(at, from.size(), to);
}

/// what() of the error of exactly this type, or what came instead.
template <typename Error>
std::string errorOf(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  } catch (const std::exception& other) {
    return std::string("an error of another type: ") + other.what();
  }
  return "no error";
}

template <typename Error>
std::string domainError(const std::string& text) {
  return errorOf<Error>([&] { parseDomain({"d.pddl", text}); });
}

template <typename Error>
std::string problemError(const std::string& text) {
  return errorOf<Error>([&] { parseProblem({"p.pddl", text}); });
}

inline std::string linkError(const std::string& domain, const std::string& problem) {
  return errorOf<SemanticError>([&] { readModel({"d.pddl", domain}, {"p.pddl", problem}); });
}

}  // namespace goal_alignment::pddl::samples
