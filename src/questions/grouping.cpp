// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/questions/grouping.h"

#include <algorithm>
#include <utility>

#include "live_conflict.h"

namespace goal_alignment::questions {

namespace {

/// How many combinations of answers are followed: the rest are too unlikely to count.
constexpr std::size_t kMaxLeaves = 64;

/// One combination of answers to the group.
struct Leaf {
  std::vector<Knowledge> knowledge;
  double probability = 1;
  bool open = true;  ///< the outcome is not decided yet
};

class Group {
 public:
  Group(Policy& policy, const Situation& situation) : policy_(policy), hypothetical_(situation) {
    leaves_.push_back({situation.knowledge, 1, !liveConflicts(situation).empty()});
  }

  /// P(the outcome is still open after the answers to the group).
  double undecided() const {
    double open = 0;
    double all = 0;
    for (const Leaf& leaf : leaves_) {
      all += leaf.probability;
      if (leaf.open) open += leaf.probability;
    }
    return all > 0 ? open / all : 0;
  }

  /// What the policy would ask at the likeliest open leaf.
  std::optional<std::size_t> nextCandidate() {
    const Leaf* likeliest = nullptr;
    for (const Leaf& leaf : leaves_) {
      if (!leaf.open) continue;
      if (likeliest == nullptr || leaf.probability > likeliest->probability) likeliest = &leaf;
    }
    if (likeliest == nullptr) return std::nullopt;
    hypothetical_.knowledge = likeliest->knowledge;
    const auto choice = policy_.next(hypothetical_);
    if (!choice) return std::nullopt;
    return choice->candidate;
  }

  void add(std::size_t candidate) {
    const double p = hypothetical_.probability[candidate];
    std::vector<Leaf> split;
    for (Leaf& leaf : leaves_) {
      Leaf yes = leaf;
      answer(yes, candidate, Knowledge::Wanted, p);
      split.push_back(std::move(yes));
      answer(leaf, candidate, Knowledge::NotWanted, 1 - p);
      split.push_back(std::move(leaf));
    }
    std::stable_sort(split.begin(), split.end(),
                     [](const Leaf& a, const Leaf& b) { return a.probability > b.probability; });
    if (split.size() > kMaxLeaves) split.resize(kMaxLeaves);
    leaves_ = std::move(split);
  }

 private:
  void answer(Leaf& leaf, std::size_t candidate, Knowledge knowledge, double probability) {
    leaf.knowledge[candidate] = knowledge;
    leaf.probability *= probability;
    if (!leaf.open) return;
    hypothetical_.knowledge = leaf.knowledge;
    leaf.open = !liveConflicts(hypothetical_).empty();
  }

  Policy& policy_;
  Situation hypothetical_;
  std::vector<Leaf> leaves_;
};

/// For policies that keep asking whatever the conflicts say.
std::vector<Choice> nextInOrder(Policy& policy, const Situation& situation,
                                std::size_t max_candidates) {
  Situation hypothetical = situation;
  std::vector<Choice> group;
  while (group.size() < max_candidates) {
    const auto choice = policy.next(hypothetical);
    if (!choice) break;
    hypothetical.knowledge[choice->candidate] = Knowledge::Unsure;  // leaves every reason alive
    group.push_back({choice->candidate, smallestLiveConflict(situation, choice->candidate)});
  }
  return group;
}

}  // namespace

std::vector<Choice> nextGroup(Policy& policy, const Situation& situation,
                              std::size_t max_candidates) {
  if (!policy.usesConflicts()) return nextInOrder(policy, situation, max_candidates);
  const auto first = max_candidates > 0 ? policy.next(situation) : std::nullopt;
  if (!first) return {};
  std::vector<Choice> chosen = {*first};
  Group group(policy, situation);
  group.add(first->candidate);
  while (chosen.size() < max_candidates && group.undecided() > kMinUndecided) {
    const auto candidate = group.nextCandidate();
    if (!candidate) break;
    chosen.push_back({*candidate, smallestLiveConflict(situation, *candidate)});
    group.add(*candidate);
  }
  return chosen;
}

}  // namespace goal_alignment::questions
