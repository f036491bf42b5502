// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/atom_table.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <utility>
#include <vector>

namespace goal_alignment::pddl {
namespace {

using Plain = std::pair<PredicateId, std::vector<ObjectId>>;

RC_GTEST_PROP(AtomTable, NumbersAtomsInTheOrderOfTheirComing, (std::vector<Plain> atoms)) {
  AtomTable table;
  std::map<Plain, AtomId> expected;
  for (const Plain& plain : atoms) {
    const AtomView atom(plain.first, plain.second);
    const auto next = static_cast<AtomId>(expected.size());
    const auto [known, is_new] = expected.emplace(plain, next);
    RC_ASSERT(table.find(atom) == (is_new ? AtomTable::kNone : known->second));
    RC_ASSERT(table.insert(atom) == std::make_pair(known->second, is_new));
    RC_ASSERT(table[known->second] == atom);
  }
  RC_ASSERT(table.size() == expected.size());
}

}  // namespace
}  // namespace goal_alignment::pddl
