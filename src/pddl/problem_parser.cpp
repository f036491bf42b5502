// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <string>

#include "declaration_reader.h"
#include "formula_reader.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/pddl/parser.h"
#include "number_reader.h"

namespace goal_alignment::pddl {

namespace {

const Sections kSections{{":domain", ":requirements", ":objects", ":init", ":goal", ":metric"},
                         "a section of a problem, such as ':init'"};

/// (define (problem name) section …), in any order. Objects, initial facts and a metric may be
/// missing; the domain's name and a goal may not, since no plan could be asked for.
class ProblemParser {
 public:
  ProblemParser(const Source& source, const Limits& limits)
      : source_(std::make_shared<const Source>(source)), reader_(*source_, limits) {
    problem_.source = source_;
  }

  ast::Problem parse() {
    problem_.name = readHeader(reader_, "problem");
    while (!reader_.atClose()) {
      reader_.open("'(' or ')'");
      readSection();
      reader_.close();
    }
    const SourcePosition end = reader_.close();
    requireSection(problem_.domain_name.position, "(:domain …)", end);
    requireSection(problem_.goal_position, "(:goal …)", end);
    reader_.finish();
    return std::move(problem_);
  }

 private:
  void readSection() {
    reader_.setPlace("problem " + inQuotes(problem_.name.spelling));
    expectSection(reader_, kSections);
    log_.note(reader_);
    const Token token = reader_.word("a section");
    const std::string keyword = toLower(token.text);
    reader_.setPlace(keyword);
    if (keyword == ":domain") {
      problem_.domain_name = reader_.name("the domain's name");
    } else if (keyword == ":requirements") {
      readRequirements(reader_);
    } else if (keyword == ":objects") {
      problem_.objects = readTypedList(reader_, ListOf::Names, "an object");
    } else if (keyword == ":init") {
      readInit();
    } else if (keyword == ":goal") {
      problem_.goal_position = token.position;
      problem_.goal = readCondition(reader_, Terms::ObjectsOnly);
    } else {
      readMetric();
    }
  }

  // `:init` is a list of facts, not a formula.
  void readInit() {
    while (!reader_.atClose()) {
      reader_.open("'(' or ')'");
      if (reader_.atWord("=")) {
        readFunctionValue();
      } else if (reader_.atWord("not")) {
        readInitFalse();
      } else {
        problem_.init.push_back(readInitAtom());
      }
      reader_.close();
    }
  }

  void readInitFalse() {
    reader_.word("'not'");
    reader_.open("an atom's '('");
    problem_.init_false.push_back(readAtom(reader_, Terms::ObjectsOnly, "a predicate"));
    reader_.close();
  }

  /// Also meets `(at 5 (p))`, which looks like an atom up to its second `(`.
  ast::Atom readInitAtom() {
    refuseConjunction();
    refuseReserved(reader_);
    ast::Atom atom;
    atom.predicate = reader_.name("a predicate, 'not' or '='");
    const bool at = toLower(atom.predicate.spelling) == "at";
    while (!reader_.atClose()) {
      const bool number = atNumber(reader_);
      atom.terms.push_back(reader_.name("an object or ')'"));
      if (at && number && atom.terms.size() == 1 && reader_.atOpen()) {
        reader_.failUnsupported(atom.predicate.position, "a timed initial literal");
      }
    }
    return atom;
  }

  // Some write `(:init (and …))`; reading `and` as a predicate would give a puzzling error.
  void refuseConjunction() {
    if (!reader_.atWord("and")) return;
    reader_.failUnsupported(reader_.current().position, "'and' (list the facts themselves)");
  }

  /// `= (f obj …) n`, or `= f n` without arguments.
  void readFunctionValue() {
    const Token sign = reader_.word("'='");
    ast::FunctionValue value;
    if (reader_.atName()) {
      value.function.predicate = reader_.name("a function");
    } else {
      reader_.open("a function's '('");
      value.function = readAtom(reader_, Terms::ObjectsOnly, "a function");
      reader_.close();
    }
    if (reader_.atName() && !atNumber(reader_)) {
      reader_.failUnsupported(sign.position, "a function to an object (an object fluent)");
    }
    value.value = readCost(reader_);
    problem_.init_values.push_back(std::move(value));
  }

  // Only the sum of the actions' costs can be minimised; without a metric a step costs 1.
  void readMetric() {
    if (reader_.atWord("maximize")) {
      reader_.failUnsupported(reader_.current().position, "'maximize'");
    }
    reader_.word("minimize", "'minimize'");
    // PDDL 2.1 lets a function without arguments stand bare.
    const bool bare = reader_.atWord();
    if (!bare) reader_.open("'(total-cost)'");
    if (reader_.atWord() && !reader_.atWord("total-cost")) {
      reader_.failUnsupported(reader_.current().position,
                              "minimising " + inQuotes(reader_.current().text));
    }
    reader_.word("total-cost", "'total-cost'");
    if (!bare) reader_.close();
    problem_.minimises_total_cost = true;
  }

  /// `end`: the closing parenthesis, where the missing section should have stood. Text behind it
  /// has lost its way.
  void requireSection(SourcePosition position, const std::string& section,
                      SourcePosition end) const {
    if (position.line > 0) return;
    const std::string hint = reader_.atEnd() ? "" : reader_.bracketHint();
    reader_.fail(end, "expected " + section + ", found ')'" + hint);
  }

  std::shared_ptr<const Source> source_;
  TokenReader reader_;
  ast::Problem problem_;
  SectionLog log_;
};

}  // namespace

ast::Problem parseProblem(const Source& source, const Limits& limits) {
  return ProblemParser(source, limits).parse();
}

}  // namespace goal_alignment::pddl
