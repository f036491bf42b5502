// SPDX-License-Identifier: BSD-3-Clause
#include <exception>
#include <optional>
#include <string>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/parser.h"
#include "token_reader.h"

namespace goal_alignment::pddl {

namespace {

/// The word behind `(define (`: what the text defines. Nothing where it does not begin like that.
std::optional<ast::Name> definedKind(const Source& source) {
  try {
    TokenReader reader(source);
    reader.open();
    reader.word("define", "'define'");
    reader.open();
    return reader.name("'domain' or 'problem'");
  } catch (const SyntaxError&) {
    return std::nullopt;  // whoever reads all of it says so
  }
}

bool defines(const std::optional<ast::Name>& defined, std::string_view kind) {
  return defined && toLower(defined->spelling) == kind;
}

void refuseSwapped(const Source& domain, const Source& problem) {
  const std::optional<ast::Name> first = definedKind(domain);
  if (!defines(first, "problem") || !defines(definedKind(problem), "domain")) return;
  throw SyntaxError(domain.name, first->position,
                    "expected 'domain', found 'problem': the two files are the wrong way round; " +
                        problem.name + " defines the domain");
}

/// The parsed text, or nothing and one fault more.
template <typename Parse>
auto parsedOrFault(Parse parse, const Source& source, std::vector<std::string>& faults)
    -> std::optional<decltype(parse(source, Limits{}))> {
  try {
    return parse(source, Limits{});
  } catch (const std::exception& fault) {
    faults.emplace_back(fault.what());
    return std::nullopt;
  }
}

}  // namespace

Model readModel(const Source& domain, const Source& problem, const Limits& limits) {
  refuseSwapped(domain, problem);
  return link(parseDomain(domain, limits), parseProblem(problem, limits), limits);
}

std::vector<std::string> faults(const Source& domain, const Source& problem) {
  std::vector<std::string> found;
  try {
    refuseSwapped(domain, problem);
  } catch (const std::exception& fault) {
    return {fault.what()};
  }
  const auto domain_ast = parsedOrFault(parseDomain, domain, found);
  const auto problem_ast = parsedOrFault(parseProblem, problem, found);
  if (!domain_ast || !problem_ast) return found;
  try {
    link(*domain_ast, *problem_ast);
  } catch (const std::exception& fault) {
    found.emplace_back(fault.what());
  }
  return found;
}

}  // namespace goal_alignment::pddl
