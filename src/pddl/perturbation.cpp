// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/perturbation.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/lexer.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/parser.h"

namespace goal_alignment::pddl {
namespace {

constexpr std::string_view kNothing = "(and)";

// A word or a list of the text. The ast does not say where a formula begins and ends.
struct Expression {
  std::string_view text;
  std::vector<Expression> parts;  // of a list

  bool is(std::string_view lower_case) const { return toLower(text) == lower_case; }
  bool hasHead(std::string_view lower_case) const {
    return !parts.empty() && parts.front().is(lower_case);
  }
};

// Of a text that has been parsed: parentheses match, and are not nested too deep to recurse.
Expression readExpression(Lexer& lexer, const Token& first) {
  if (first.kind == Token::Kind::Word) return {first.text, {}};
  Expression list;
  Token token = lexer.next();
  for (; token.kind != Token::Kind::Close; token = lexer.next())
    list.parts.push_back(readExpression(lexer, token));
  const char* begin = first.text.data();
  list.text = {begin, static_cast<std::size_t>(token.text.data() + 1 - begin)};
  return list;
}

// What may be forgotten.
struct Piece {
  std::string_view text;
  std::string_view action;
  const char* kind;
  bool in_conjunction;  // taken out, nothing need stand in its place
};

class Collector {
 public:
  explicit Collector(const Expression& domain) {
    for (const Expression& section : domain.parts) {
      if (section.hasHead(":action")) readAction(section);
    }
  }

  std::vector<Piece> preconditions;
  std::vector<Piece> deletes;

 private:
  void readAction(const Expression& action) {
    action_ = action.parts[1].text;
    for (std::size_t i = 2; i + 1 < action.parts.size(); ++i) {
      if (action.parts[i].is(":precondition")) addConjuncts(action.parts[i + 1], false);
      if (action.parts[i].is(":effect")) addDeletes(action.parts[i + 1], false);
    }
  }

  void addConjuncts(const Expression& formula, bool in_conjunction) {
    if (formula.hasHead("and")) {
      for (std::size_t i = 1; i < formula.parts.size(); ++i)
        addConjuncts(formula.parts[i], true);
    } else if (!formula.parts.empty()) {
      preconditions.push_back({formula.text, action_, "precondition", in_conjunction});
    }
  }

  void addDeletes(const Expression& effect, bool in_conjunction) {
    if (effect.hasHead("and")) {
      for (std::size_t i = 1; i < effect.parts.size(); ++i)
        addDeletes(effect.parts[i], true);
    } else if (effect.hasHead("forall") || effect.hasHead("when")) {
      addDeletes(effect.parts[2], false);
    } else if (effect.hasHead("not")) {
      deletes.push_back({effect.text, action_, "delete", in_conjunction});
    }
  }

  std::string_view action_;
};

using Pieces = std::vector<Piece>;

[[noreturn]] void refuseCount(const Source& domain, std::size_t count, const std::string& what,
                              const std::string& but) {
  throw std::invalid_argument(domain.name + ": can't forget " + std::to_string(count) + " " + what +
                              ", " + but);
}

// A random one of them, which they are without then.
Piece drawn(Pieces& pieces, RandomSource& random) {
  std::swap(pieces[random.below(pieces.size())], pieces.back());
  const Piece piece = pieces.back();
  pieces.pop_back();
  return piece;
}

// What goes with a piece: the blanks before it, and its line where nothing else stands there.
std::string_view withItsLine(std::string_view piece, std::string_view text) {
  auto begin = static_cast<std::size_t>(piece.data() - text.data());
  std::size_t end = begin + piece.size();
  while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '\t'))
    --begin;
  const std::size_t next = text.find_first_not_of(" \t\r", end);
  const bool ends_line = next != std::string_view::npos && text[next] == '\n';
  if (begin > 0 && text[begin - 1] == '\n' && ends_line) end = next + 1;
  return text.substr(begin, end - begin);
}

// The text without the pieces.
Perturbation without(const Source& domain, Pieces pieces) {
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece& a, const Piece& b) { return a.text.data() < b.text.data(); });
  Perturbation result;
  const std::string_view text = domain.text;
  std::size_t copied = 0;
  for (const Piece& piece : pieces) {
    const std::string_view out = piece.in_conjunction ? withItsLine(piece.text, text) : piece.text;
    const auto begin = static_cast<std::size_t>(out.data() - text.data());
    result.text += text.substr(copied, begin - copied);
    if (!piece.in_conjunction) result.text += kNothing;
    copied = begin + out.size();
    result.forgotten.push_back(std::string(piece.kind) + " " + std::string(piece.text) + " of " +
                               std::string(piece.action));
  }
  result.text += text.substr(copied);
  return result;
}

bool isSound(const Source& domain) {
  try {
    checkDomain(parseDomain(domain));
    return true;
  } catch (const SemanticError&) {
    return false;
  }
}

// Those drawn. A precondition may be what tells that a variable is of the type that an effect
// needs: nobody could read a domain without it.
Pieces drawPreconditions(const Source& domain, Pieces pieces, std::size_t count,
                         RandomSource& random) {
  Pieces chosen;
  while (chosen.size() < count && !pieces.empty()) {
    chosen.push_back(drawn(pieces, random));
    if (!isSound({domain.name, without(domain, chosen).text})) chosen.pop_back();
  }
  if (chosen.size() < count) {
    refuseCount(domain, count, "preconditions",
                std::to_string(chosen.size()) + " is the most that leaves a domain");
  }
  return chosen;
}

}  // namespace

Perturbation perturb(const Source& domain, std::size_t preconditions, std::size_t deletes,
                     RandomSource& random) {
  checkDomain(parseDomain(domain));
  Lexer lexer(domain);
  const Expression read = readExpression(lexer, lexer.next());
  Collector all(read);
  const auto require = [&](const Pieces& pieces, std::size_t count, const std::string& what) {
    if (count <= pieces.size()) return;
    refuseCount(domain, count, what, "there are " + std::to_string(pieces.size()));
  };
  require(all.preconditions, preconditions, "preconditions");
  require(all.deletes, deletes, "delete effects");
  Pieces chosen = drawPreconditions(domain, all.preconditions, preconditions, random);
  for (; deletes > 0; --deletes)
    chosen.push_back(drawn(all.deletes, random));
  return without(domain, std::move(chosen));
}

}  // namespace goal_alignment::pddl
