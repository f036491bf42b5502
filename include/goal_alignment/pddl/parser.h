// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/ast.h"

/// PDDL 1.2/2.1 text to ast (Ghallab et al. 1998; Fox & Long 2003), the part named in README.md:
/// :adl :constants :action-costs.
///
/// All functions are O(text), keep no state, and throw SyntaxError or UnsupportedError; those with
/// limits poll them at every token and throw LimitReached.
namespace goal_alignment::pddl {

ast::Domain parseDomain(const Source& source, const Limits& limits = {});

ast::Problem parseProblem(const Source& source, const Limits& limits = {});

/// One ground action `(name obj …)` a line, `;` comments, blank lines. Steps keep their position.
struct PlanText {
  std::string source_name;
  std::vector<GroundName> steps;
  std::vector<SourcePosition> positions;
};
PlanText parsePlan(const Source& source);

/// One ground literal `(p obj …)` or `(not (p obj …))` a line; comments as in a plan.
std::vector<Literal> parseLiterals(const Source& source);

}  // namespace goal_alignment::pddl
