// SPDX-License-Identifier: BSD-3-Clause
#include "action_reader.h"

#include <string>

#include "declaration_reader.h"
#include "foreign_keyword.h"
#include "formula_reader.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/near_name.h"
#include "number_reader.h"

namespace goal_alignment::pddl {

namespace {

/// A function with its value in the initial state. PDDL 2.1 lets one without arguments stand bare.
ast::Atom readCostFunction(TokenReader& reader) {
  const bool bare = reader.atWord();
  if (!bare) reader.open();
  if (reader.atWord("+") || reader.atWord("-") || reader.atWord("*") || reader.atWord("/")) {
    reader.failUnsupported(reader.current().position, "arithmetic in an action cost");
  }
  if (reader.atWord("total-cost")) {
    reader.failUnsupported(reader.current().position, "'total-cost' as an action cost");
  }
  if (bare) return {reader.name("a function"), {}};
  ast::Atom function = readAtom(reader, Terms::WithParameters, "a function");
  reader.close();
  return function;
}

/// What follows `(increase`: `(total-cost) n` or `(total-cost) (f term …)`.
ast::CostEffect readIncrease(TokenReader& reader) {
  const bool bare = reader.atWord();
  if (!bare) reader.open("'(total-cost)'");
  if (reader.atName() && !reader.atWord("total-cost")) {
    reader.failUnsupported(
        reader.current().position,
        "'increase' of " + inQuotes(reader.current().text) + " (a numeric fluent)");
  }
  reader.word("total-cost", "'total-cost'");
  if (!bare) reader.close();
  ast::CostEffect cost;
  if (reader.atOpen() || (reader.atName() && !atNumber(reader))) {
    cost.function = readCostFunction(reader);
  } else {
    cost.constant = readCost(reader);
  }
  return cost;
}

/// Bounds what a single action can cost.
constexpr std::size_t kMaxCosts = 100;

/// Conditions are copied to all that stands below them, so this bounds what an effect grows to.
constexpr int kDeepestEffect = 10;

/// Fills an action's effects and cost. A cost is no effect on the state, so the two are told apart
/// while reading:
///
///     effect := () | (and effect …) | atom | (not atom) | (increase (total-cost) cost)
///             | (forall (variable …) effect) | (when condition effect)
class EffectReader {
 public:
  EffectReader(TokenReader& reader, ast::Action& action) : reader_(reader), action_(action) {}

  void read() {
    reader_.open();
    readConjuncts(action_.effect, action_.conditional);
  }

 private:
  // Enters behind the `(`, leaves behind its `)`.
  void readConjuncts(std::vector<ast::Literal>& literals,
                     std::vector<ast::ConditionalEffect>& conditional) {
    if (reader_.atWord("and")) {
      reader_.word("'and'");
      while (!reader_.atClose()) {
        reader_.open("'(' or ')'");
        readConjuncts(literals, conditional);
      }
    } else if (reader_.atWord("not")) {
      literals.push_back(readDelete());
    } else if (reader_.atWord("forall") || reader_.atWord("when")) {
      conditional.push_back(readConditional());
    } else if (reader_.atWord("increase")) {
      readCostEffect();
    } else if (!reader_.atClose()) {
      literals.push_back({readEffectAtom("a predicate, 'and', 'not', 'increase' or ')'")});
    }
    reader_.close();
  }

  ast::ConditionalEffect readConditional() {
    const Token keyword = reader_.word("'forall' or 'when'");
    if (++depth_ > kDeepestEffect) {
      reader_.failUnsupported(keyword.position, "'forall' and 'when' nested deeper than " +
                                                    std::to_string(kDeepestEffect));
    }
    ast::ConditionalEffect effect;
    if (toLower(keyword.text) == "forall") {
      effect.variables = readVariables(reader_);
    } else {
      effect.condition = readCondition(reader_, Terms::WithParameters);
    }
    reader_.open("an effect's '('");
    readConjuncts(effect.literals, effect.nested);
    --depth_;
    return effect;
  }

  ast::Literal readDelete() {
    reader_.word("'not'");
    reader_.open("an atom's '('");
    ast::Literal literal{readEffectAtom("a predicate"), true};
    reader_.close();
    return literal;
  }

  // What the reader expects here names no `=`: an effect can't make two objects equal.
  ast::Atom readEffectAtom(const std::string& what) {
    return readAtom(reader_, Terms::WithParameters, what);
  }

  void readCostEffect() {
    const Token increase = reader_.word("'increase'");
    if (depth_ > 0) {
      reader_.failUnsupported(increase.position, "a cost inside of 'forall' or 'when'");
    }
    if (action_.costs.size() == kMaxCosts) {
      reader_.failUnsupported(increase.position,
                              "more than " + std::to_string(kMaxCosts) + " costs of one action");
    }
    action_.costs.push_back(readIncrease(reader_));
  }

  TokenReader& reader_;
  ast::Action& action_;
  int depth_ = 0;  ///< of `forall` and `when` around what is being read
};

/// What follows one of the three keywords. The place is set for errors deeper down.
void readPart(TokenReader& reader, const std::string& keyword, ast::Action& action) {
  const std::string of_action = " of action " + inQuotes(action.name.spelling);
  if (keyword == ":parameters") {
    reader.setPlace("the parameters" + of_action);
    reader.open();
    action.parameters = readTypedList(reader, ListOf::Variables, "a parameter such as '?x'");
    reader.close();
  } else if (keyword == ":precondition") {
    reader.setPlace("the precondition" + of_action);
    action.precondition = readCondition(reader, Terms::WithParameters);
  } else {
    reader.setPlace("the effect" + of_action);
    EffectReader(reader, action).read();
  }
}

}  // namespace

ast::Action readAction(TokenReader& reader) {
  ast::Action action;
  action.name = reader.name("the action's name");
  SectionLog log;
  while (!reader.atClose()) {
    reader.setPlace("action " + inQuotes(action.name.spelling));
    if (!reader.atWord(":parameters") && !reader.atWord(":precondition") &&
        !reader.atWord(":effect")) {
      refuseForeign(reader);
      const std::string found(reader.atWord() ? reader.current().text : "");
      reader.failExpecting("':parameters', ':precondition', ':effect' or ')'",
                           suggestion(found, {":parameters", ":precondition", ":effect"}));
    }
    log.note(reader);
    // The parts come in any order, and any of them may be missing.
    const Token keyword = reader.word("a keyword");
    readPart(reader, toLower(keyword.text), action);
  }
  return action;
}

}  // namespace goal_alignment::pddl
