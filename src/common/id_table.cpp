// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/id_table.h"

#include <utility>

namespace goal_alignment {

void IdTable::insert(std::uint64_t hash, Id id) {
  parts_.resize(kParts);
  Part& part = parts_[(hash >> 32U) % kParts];
  if (2 * part.taken >= part.slots.size()) grow(part);
  const std::size_t mask = part.slots.size() - 1;
  std::size_t at = tagOf(hash) & mask;
  while (part.slots[at].id != kNone)
    at = (at + 1) & mask;
  part.slots[at] = {id, tagOf(hash)};
  ++part.taken;
}

void IdTable::grow(Part& part) {
  constexpr std::size_t kFirst = 16;
  std::vector<Slot> larger(part.slots.empty() ? kFirst : 2 * part.slots.size());
  const std::size_t mask = larger.size() - 1;
  for (const Slot& slot : part.slots) {
    if (slot.id == kNone) continue;
    std::size_t at = slot.tag & mask;
    while (larger[at].id != kNone)
      at = (at + 1) & mask;
    larger[at] = slot;
  }
  slots_ += larger.size() - part.slots.size();
  part.slots = std::move(larger);
}

}  // namespace goal_alignment
