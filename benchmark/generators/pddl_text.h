// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

/// Models as parts that a generator can put together, or take parts from, before they become text.
namespace goal_alignment::benchmarks {

/// A name and its type: an object, a parameter, a type and its parent.
struct Typed {
  std::string name;
  std::string type;
};

/// `?a ?b - van ?p - spot`, or the same without question marks; `object` where no type is given.
std::vector<Typed> typed(std::string_view text);

struct PredicateParts {
  std::string name;
  std::vector<Typed> parameters;
};

/// Literals are texts, `(on ?a ?b)`.
struct ActionParts {
  std::string name;
  std::vector<Typed> parameters;
  std::vector<std::string> condition;
  std::vector<std::string> add;
  std::vector<std::string> del;
};

struct DomainParts {
  std::string name;
  std::vector<Typed> types;
  std::vector<PredicateParts> predicates;
  std::vector<ActionParts> actions;
  std::string whole =
      {};  ///< where it is not empty, the text; the parts but for the name are empty

  std::string text() const;
  /// Whether `type` is `of` or below it.
  bool isA(const std::string& type, const std::string& of) const;
  /// Null where there is none.
  const PredicateParts* predicate(const std::string& wanted) const;
  /// Throws std::out_of_range.
  ActionParts& action(const std::string& wanted);
};

struct ProblemParts {
  std::vector<Typed> objects;
  std::vector<std::string> init;
  std::vector<std::string> goal;

  /// `count` objects `stem0`, `stem1`, …; returns their names.
  std::vector<std::string> addObjects(const std::string& stem, int count, const std::string& type);
};

/// A planning task.
struct Models {
  DomainParts domain;
  ProblemParts problem;
  /// Fluent predicates whose last argument can be another object without the state making no sense.
  std::vector<std::string> displaceable = {};

  std::string problemText() const;
};

/// `(name argument …)`.
std::string atom(std::initializer_list<std::string_view> words);

/// `stem` followed by the number.
std::string numbered(const std::string& stem, int number);

}  // namespace goal_alignment::benchmarks
