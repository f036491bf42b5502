// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <vector>

#include "goal_alignment/pddl/model.h"

namespace goal_alignment::pddl {

namespace {

class FormulaText {
 public:
  FormulaText(const Model& model, const std::vector<Parameter>& variables,
              const std::vector<ObjectId>& binding)
      : model_(model), variables_(variables), names_(variables.size()) {
    for (std::size_t i = 0; i < variables.size(); ++i) {
      const bool bound = i < binding.size() && binding[i] >= 0;
      names_[i] = bound ? model.objects[binding[i]].name.name : "?" + variables[i].name;
    }
  }

  std::string of(const Formula& formula) {
    switch (formula.kind) {
      case Formula::Kind::Literal:
        return negated(formula.literal.negated, atom(formula.literal.atom));
      case Formula::Kind::Equality:
        return equality(formula.equality);
      case Formula::Kind::And:
        return joined("and", formula);
      case Formula::Kind::Or:
        return joined("or", formula);
      case Formula::Kind::ForAll:
        return quantified("forall", formula);
      case Formula::Kind::Exists:
        return quantified("exists", formula);
    }
    return {};
  }

 private:
  const std::string& term(const Term& term) const {
    return term.is_parameter ? names_[term.index] : model_.objects[term.index].name.name;
  }

  static std::string negated(bool negated, const std::string& text) {
    return negated ? "(not " + text + ")" : text;
  }

  std::string atom(const LiftedAtom& atom) const {
    std::string text = "(" + model_.predicates[atom.predicate].name.name;
    for (const Term& argument : atom.terms)
      text += " " + term(argument);
    return text + ")";
  }

  std::string equality(const Equality& equality) const {
    const auto [first, second] = std::minmax(term(equality.left), term(equality.right));
    return negated(equality.negated, "(= " + first + " " + second + ")");
  }

  std::string joined(const std::string& word, const Formula& formula) {
    std::vector<std::string> parts;
    for (const Formula& part : formula.parts)
      parts.push_back(of(part));
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    if (parts.size() == 1) return parts.front();
    std::string text = "(" + word;
    for (const std::string& part : parts)
      text += " " + part;
    return text + ")";
  }

  std::string quantified(const std::string& word, const Formula& formula) {
    std::string text = "(" + word + " (";
    for (const int variable : formula.variables) {
      names_[variable] = "?" + std::to_string(++depth_);
      text += (text.back() == '(' ? "" : " ") + names_[variable];
      text += " - " + model_.types[variables_[variable].type].name.name;
    }
    text += ") " + of(formula.parts.front()) + ")";
    depth_ -= formula.variables.size();
    return text;
  }

  const Model& model_;
  const std::vector<Parameter>& variables_;
  std::vector<std::string> names_;  // of the variables, by index
  std::size_t depth_ = 0;           // quantified variables around what is being written
};

}  // namespace

std::string Model::text(const Formula& formula, const std::vector<Parameter>& variables,
                        const std::vector<ObjectId>& binding) const {
  return FormulaText(*this, variables, binding).of(formula);
}

std::string Model::goalConditionText() const {
  return goal_condition.trivial() ? "" : text(goal_condition, goal_variables);
}

}  // namespace goal_alignment::pddl
