// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "formula_reader.h"
#include "goal_alignment/pddl/near_name.h"
#include "goal_alignment/pddl/parser.h"
#include "planner_output.h"

namespace goal_alignment::pddl {

namespace {

/// Names of plans and goals match without case; their spelling is the model's business.
GroundName groundName(const ast::Atom& atom) {
  GroundName ground{toLower(atom.predicate.spelling), {}};
  for (const ast::Name& term : atom.terms)
    ground.arguments.push_back(toLower(term.spelling));
  return ground;
}

constexpr const char* kAction = "an action such as '(go a b)' or 'go(a, b)'";
constexpr std::size_t kNone = std::string_view::npos;

/// Characters of the number at the front, as planners print times.
std::size_t numberLength(std::string_view text) {
  const bool number = text.find_first_of("0123456789.") == 0;
  return number ? std::min(text.find_first_not_of("0123456789.eE+-"), text.size()) : 0;
}

/// Steps as planners and people write them.
class PlanReader {
 public:
  explicit PlanReader(const Source& source) : reader_(source) {}

  PlanText read() {
    PlanText plan;
    while (!reader_.atEnd()) {
      const bool numbered = skipNumber();
      plan.positions.push_back(reader_.current().position);
      plan.steps.push_back(readStep(numbered));
    }
    return plan;
  }

  /// The text is one step. Alone it needs neither number nor parentheses: `go a b`.
  GroundName readSingle() {
    skipNumber();
    GroundName step = readStep(true);
    reader_.finish();
    return step;
  }

 private:
  /// `3:`, `0.001:`, `3 :` or `3.` before a step, which may follow without a blank.
  bool skipNumber() {
    if (!reader_.atWord()) return false;
    const std::string_view text = reader_.current().text;
    const std::size_t length = numberLength(text);
    if (length == 0) return false;
    if (length < text.size() && text[length] == ':') {
      reader_.prefix(length + 1);
      return true;
    }
    if (length < text.size()) return false;
    reader_.word("a number");
    if (reader_.atWord() && reader_.current().text.front() == ':') {
      reader_.prefix(1);
    } else if (text.back() != '.') {
      reader_.failExpecting("':' behind the step's number");
    }
    return true;
  }

  GroundName readStep(bool bare) {
    GroundName step = reader_.atOpen() ? readList() : readWords(bare);
    skipDuration();
    return step;
  }

  /// `(go a b)`. An action's name may be a word that formulas reserve: here it can't be mistaken.
  GroundName readList() {
    reader_.open();
    ast::Atom action;
    action.predicate = reader_.name("an action's name");
    action.terms = readTerms(reader_, Terms::ObjectsOnly);
    line_ = reader_.close().line;
    return groundName(action);
  }

  /// `go(a, b)`, or `GO A B` up to the line's end, which is no step where nothing else says so.
  GroundName readWords(bool bare) {
    if (!reader_.atName()) reader_.failExpecting(kAction);
    const Token name = reader_.word(kAction);
    GroundName step{toLower(name.text), {}};
    line_ = name.position.line;
    if (reader_.atOpen() && (bare ? onLine() : isBehind(name))) {
      reader_.open();
      readArguments(step.arguments);
    } else if (bare) {
      while (onLine() && reader_.atName() && reader_.current().text.front() != '[')
        step.arguments.push_back(toLower(reader_.name("an object").spelling));
    } else {
      reader_.fail(name.position,
                   std::string("expected ") + kAction + ", found " + inQuotes(name.text));
    }
    return step;
  }

  /// `a, b)`; blanks do for commas.
  void readArguments(std::vector<std::string>& arguments) {
    bool comma = false;
    while (comma || !reader_.atClose()) {
      const std::size_t end = reader_.atName() ? reader_.current().text.find(',') : 0;
      if (end == 0) reader_.failExpecting(comma ? "an object" : "an object or ')'");
      arguments.push_back(toLower(reader_.prefix(end).text));
      comma = reader_.atWord() && reader_.current().text.front() == ',';
      if (comma) reader_.prefix(1);
    }
    line_ = reader_.close().line;
  }

  /// `[1.000]` behind a step, or LPG's `[D:1.00; C:0.10]`, whose end reads like a comment.
  void skipDuration() {
    const auto at_duration = [&] {
      constexpr const char* kCharacters = "[]0123456789.:,eE+-DC";
      return onLine() && reader_.atWord() &&
             reader_.current().text.find_first_not_of(kCharacters) == kNone;
    };
    if (!reader_.atWord() || reader_.current().text.front() != '[') return;
    for (bool end = false; !end && at_duration();)
      end = reader_.word("a duration").text.back() == ']';
  }

  /// Without a blank: `Plan: (go a b)` is no action `plan:`.
  bool isBehind(const Token& word) const {
    return onLine() && reader_.current().position.column ==
                           word.position.column + static_cast<int>(word.text.size());
  }
  bool onLine() const { return reader_.current().position.line == line_; }

  TokenReader reader_;
  int line_ = 0;  ///< of what was read last
};

}  // namespace

PlanText parsePlan(const Source& source) {
  const Source plan_alone = withoutChatter(source);
  PlanText plan = PlanReader(plan_alone).read();
  plan.source_name = source.name;
  return plan;
}

GroundName parseStep(const Source& source) {
  return PlanReader(source).readSingle();
}

std::vector<Literal> parseLiterals(const Source& source) {
  std::vector<Literal> literals;
  TokenReader reader(source);
  reader.setPlace("a list of literals");
  while (!reader.atEnd()) {
    reader.open("a literal's '('");
    const bool negated = reader.atWord("not");
    if (negated) {
      reader.word("'not'");
      reader.open("an atom's '('");
    }
    literals.push_back({groundName(readAtom(reader, Terms::ObjectsOnly, "a predicate")), negated});
    if (negated) reader.close();
    reader.close();
  }
  return literals;
}

}  // namespace goal_alignment::pddl
