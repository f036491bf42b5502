// SPDX-License-Identifier: BSD-3-Clause
#include "oracles/dialogues.h"

#include <algorithm>
#include <limits>

namespace goal_alignment::oracles {

using questions::Knowledge;
using questions::Situation;

bool hasEnded(const Situation& situation) {
  bool any_live = false;
  for (const auto& conflict : situation.conflicts) {
    bool hit = false;
    bool open = false;
    for (std::size_t f = 0; f < situation.knowledge.size(); ++f) {
      if (!conflict.members.test(f)) continue;
      hit = hit || situation.knowledge[f] == Knowledge::NotWanted;
      open = open || situation.knowledge[f] == Knowledge::Open;
    }
    if (!hit && !open) return true;
    any_live = any_live || !hit;
  }
  return !any_live;
}

double BestDialogue::cost(const std::vector<Knowledge>& knowledge) {
  situation_.knowledge = knowledge;
  if (hasEnded(situation_)) return 0;
  const auto found = known_.find(knowledge);
  if (found != known_.end()) return found->second;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < knowledge.size(); ++f) {
    if (knowledge[f] == Knowledge::Open) best = std::min(best, costOf(knowledge, f));
  }
  known_[knowledge] = best;
  return best;
}

double BestDialogue::costOf(std::vector<Knowledge> knowledge, std::size_t candidate) {
  const double p = situation_.probability[candidate];
  knowledge[candidate] = Knowledge::Wanted;
  const double if_wanted = cost(knowledge);
  knowledge[candidate] = Knowledge::NotWanted;
  return 1 + p * if_wanted + (1 - p) * cost(knowledge);
}

}  // namespace goal_alignment::oracles
