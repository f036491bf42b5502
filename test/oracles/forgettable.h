// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/pddl/ast.h"

/// How much of a domain may be forgotten, counted in the ast instead of in the text.
namespace goal_alignment::oracles {

struct Forgettable {
  std::size_t preconditions = 0;
  std::size_t deletes = 0;
};

inline std::size_t deletesOf(const std::vector<pddl::ast::Literal>& literals,
                             const std::vector<pddl::ast::ConditionalEffect>& conditional) {
  std::size_t count = 0;
  for (const pddl::ast::Literal& literal : literals)
    count += literal.negated ? 1 : 0;
  for (const pddl::ast::ConditionalEffect& effect : conditional)
    count += deletesOf(effect.literals, effect.nested);
  return count;
}

inline Forgettable forgettableOf(const pddl::ast::Domain& domain) {
  Forgettable counts;
  for (const pddl::ast::Action& action : domain.actions) {
    counts.preconditions += action.precondition.size();
    counts.deletes += deletesOf(action.effect, action.conditional);
  }
  return counts;
}

}  // namespace goal_alignment::oracles
