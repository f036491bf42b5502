// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/ast.h"

/// PDDL 1.2/2.1 text to ast (Ghallab et al. 1998; Fox & Long 2003), the part named in doc/pddl.md:
/// :adl :constants :action-costs.
///
/// All functions are O(text), keep no state, and throw SyntaxError or UnsupportedError; those with
/// limits poll them at every token and throw LimitReached.
namespace goal_alignment::pddl {

ast::Domain parseDomain(const Source& source, const Limits& limits = {});

ast::Problem parseProblem(const Source& source, const Limits& limits = {});

/// Ground actions `(name obj …)` or `name(obj, …)` with `;` comments, each perhaps numbered or
/// timed as planners print them (`3: …`, `0.001: … [1.000]`); and, where they are numbered, FF's
/// `NAME OBJ …`, with what FF prints around a plan. Steps keep their position.
struct PlanText {
  std::string source_name;
  std::vector<GroundName> steps;
  std::vector<SourcePosition> positions;
};
PlanText parsePlan(const Source& source);

/// A single step in any of these forms, or `name obj …` alone.
GroundName parseStep(const Source& source);

/// One ground literal `(p obj …)` or `(not (p obj …))` a line; comments as in a plan.
std::vector<Literal> parseLiterals(const Source& source);

}  // namespace goal_alignment::pddl
