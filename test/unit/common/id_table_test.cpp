// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/id_table.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace goal_alignment {
namespace {

TEST(IdTable, IsEmptyAtFirst) {
  const IdTable table;
  EXPECT_EQ(table.find(1, [](IdTable::Id) { return true; }), IdTable::kNone);
  EXPECT_EQ(table.bytes(), 0U);
  table.prefetch(1);
}

// Few hashes for many keys: all that can collide does.
RC_GTEST_PROP(IdTable, FindsWhatAMapFinds, (std::vector<std::uint16_t> keys, bool spread)) {
  const auto hash = [&](std::uint16_t key) {
    return spread ? key * 0x9e3779b97f4a7c15ULL : std::uint64_t{key % 3U};
  };
  IdTable table;
  std::vector<std::uint16_t> known;
  std::unordered_map<std::uint16_t, IdTable::Id> expected;
  for (const std::uint16_t key : keys) {
    const auto is_it = [&](IdTable::Id id) { return known[id] == key; };
    const auto next = static_cast<IdTable::Id>(known.size());
    const auto [entry, is_new] = expected.emplace(key, next);
    RC_ASSERT(table.find(hash(key), is_it) == (is_new ? IdTable::kNone : entry->second));
    if (!is_new) continue;
    known.push_back(key);
    table.insert(hash(key), next);
    RC_ASSERT(table.find(hash(key), is_it) == next);
  }
}

}  // namespace
}  // namespace goal_alignment
