// SPDX-License-Identifier: BSD-3-Clause
#include <exception>

#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/parser.h"

namespace goal_alignment::pddl {

namespace {

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
  return link(parseDomain(domain, limits), parseProblem(problem, limits), limits);
}

std::vector<std::string> faults(const Source& domain, const Source& problem) {
  std::vector<std::string> found;
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
