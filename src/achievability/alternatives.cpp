// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <utility>

#include "goal_alignment/achievability/achievability.h"

/// What to give up of all that is wanted: the cheapest sets that hit all conflicts within it, where
/// giving up f costs −log(1 − belief). Conflicts that nobody knows yet come to light as the sets
/// that hit the known ones are checked.
namespace goal_alignment::achievability {

namespace {

/// Sets taken up in order before what is there is completed in a hurry.
constexpr std::size_t kMaxNodes = 5'000;

/// No belief is so sure that giving it up would be out of the question, or cost nothing.
constexpr double kMinCost = 1e-9;
constexpr double kMaxCost = 50;

/// A set that is to be given up, and what must stay on this branch: other branches give that up, so
/// that none is met twice.
struct Node {
  CandidateSet given_up;
  CandidateSet kept;
  double bound = 0;  ///< no set below costs less
  double cost = 0;   ///< of what is given up so far
};

/// The least bound first; of equals the one that is furthest on, and then the first by index.
struct IsWorse {
  bool operator()(const Node& a, const Node& b) const {
    if (a.bound != b.bound) return a.bound > b.bound;
    if (a.cost != b.cost) return a.cost < b.cost;
    return a.given_up < b.given_up;
  }
};

std::vector<double> costs(const std::vector<double>& belief) {
  std::vector<double> result;
  for (const double p : belief) {
    const double cost = -std::log1p(-std::min(p, 1.0));
    result.push_back(std::clamp(cost, kMinCost, kMaxCost));
  }
  return result;
}

class HittingSets {
 public:
  HittingSets(const CandidateSet& wanted, const std::vector<double>& belief)
      : wanted_(wanted), costs_(costs(belief)) {
    push({CandidateSet(wanted.size()), CandidateSet(wanted.size())}, {});
  }

  bool empty() const { return open_.empty(); }
  Node pop() {
    Node node = open_.top();
    open_.pop();
    return node;
  }

  /// Known to be more than is needed.
  bool superfluous(const CandidateSet& given_up) const {
    return std::any_of(found_.begin(), found_.end(),
                       [&](const CandidateSet& known) { return known.is_subset_of(given_up); });
  }

  /// The smallest conflict within what is wanted that the set does not hit, or null.
  const Conflict* unhit(const CandidateSet& given_up,
                        const std::vector<Conflict>& conflicts) const {
    const Conflict* smallest = nullptr;
    for (const Conflict& conflict : conflicts) {
      if (!conflict.members.is_subset_of(wanted_) || conflict.members.intersects(given_up))
        continue;
      if (smallest == nullptr || conflict.members.count() < smallest->members.count())
        smallest = &conflict;
    }
    return smallest;
  }

  /// One node for each way to hit the conflict.
  void branch(const Node& node, const CandidateSet& conflict,
              const std::vector<Conflict>& conflicts) {
    CandidateSet kept = node.kept;
    for (const std::size_t candidate : members(conflict - node.kept)) {
      Node child = {node.given_up, kept};
      child.given_up.set(candidate);
      if (!superfluous(child.given_up)) push(std::move(child), conflicts);
      kept.set(candidate);
    }
  }

  /// The cheapest way to hit one conflict more.
  std::size_t cheapestOf(const CandidateSet& conflict) const {
    const std::vector<std::size_t> all = members(conflict);
    return *std::min_element(all.begin(), all.end(),
                             [&](std::size_t a, std::size_t b) { return costs_[a] < costs_[b]; });
  }

  void add(const CandidateSet& given_up) { found_.push_back(given_up); }
  std::size_t count() const { return found_.size(); }

  /// What was found, the cheapest first.
  std::vector<CandidateSet> found() && {
    std::stable_sort(found_.begin(), found_.end(),
                     [&](const auto& a, const auto& b) { return costOf(a) < costOf(b); });
    return std::move(found_);
  }

 private:
  // Members in the order of their index, so that a subset never costs more, rounding included.
  double costOf(const CandidateSet& set) const {
    double sum = 0;
    for (const std::size_t candidate : members(set))
      sum += costs_[candidate];
    return sum;
  }

  void push(Node node, const std::vector<Conflict>& conflicts) {
    node.cost = costOf(node.given_up);
    node.bound = node.cost;
    // Conflicts that share nothing are paid for apart.
    CandidateSet paid = ~wanted_ | node.kept;
    CandidateSet used(wanted_.size());
    for (const Conflict& conflict : conflicts) {
      if (!conflict.members.is_subset_of(wanted_) || conflict.members.intersects(node.given_up))
        continue;
      const CandidateSet left = conflict.members - paid;
      if (left.none()) return;  // it can't be hit any more
      if (left.intersects(used)) continue;
      used |= left;
      node.bound += costs_[cheapestOf(left)];
    }
    open_.push(std::move(node));
  }

  CandidateSet wanted_;
  std::vector<double> costs_;
  std::priority_queue<Node, std::vector<Node>, IsWorse> open_;
  std::vector<CandidateSet> found_;
};

/// Goes through the sets; what its steps return is false when the limits end them.
class Alternatives {
 public:
  Alternatives(Achievability& robot, const CandidateSet& wanted, const std::vector<double>& belief,
               std::size_t most, const Limits& limits)
      : robot_(robot), wanted_(wanted), most_(most), limits_(limits), sets_(wanted, belief) {}

  std::vector<CandidateSet> run() {
    LimitMonitor monitor(limits_);
    for (std::size_t taken = 0; !sets_.empty() && sets_.count() < most_; ++taken) {
      if (monitor.poll() != LimitReason::None) break;
      const Node node = sets_.pop();
      if (sets_.superfluous(node.given_up)) continue;
      if (!(taken < kMaxNodes ? takeUp(node) : complete(node))) break;
    }
    return std::move(sets_).found();
  }

 private:
  /// In order: the set is what is looked for, or a conflict says how to go on from it.
  bool takeUp(const Node& node) {
    bool interrupted = false;
    const auto conflict = conflictLeft(node.given_up, interrupted);
    if (conflict) {
      sets_.branch(node, *conflict, robot_.conflicts());
    } else if (!interrupted) {
      sets_.add(node.given_up);
    }
    return !interrupted;
  }

  /// In a hurry: the cheapest of each conflict, and back what that makes needless.
  bool complete(const Node& node) {
    CandidateSet given_up = node.given_up;
    bool interrupted = false;
    while (const auto conflict = conflictLeft(given_up, interrupted)) {
      if (conflict->none()) return true;
      given_up.set(sets_.cheapestOf(*conflict));
    }
    for (const std::size_t candidate : members(given_up)) {
      if (interrupted) return false;
      CandidateSet less = given_up;
      if (!conflictLeft(less.reset(candidate), interrupted) && !interrupted) given_up = less;
    }
    if (!interrupted && !sets_.superfluous(given_up)) sets_.add(given_up);
    return !interrupted;
  }

  /// A conflict, be it a suspected one, in what is wanted without the set; none: there is a plan.
  std::optional<CandidateSet> conflictLeft(const CandidateSet& given_up, bool& interrupted) {
    if (const Conflict* known = sets_.unhit(given_up, robot_.conflicts())) return known->members;
    const CandidateSet rest = wanted_ - given_up;
    const Check check = robot_.check(rest, limits_);
    if (check.verdict == Verdict::Achievable) return std::nullopt;
    if (const Conflict* found = sets_.unhit(given_up, robot_.conflicts())) return found->members;
    interrupted = true;
    return std::nullopt;
  }

  Achievability& robot_;
  CandidateSet wanted_;
  std::size_t most_;
  Limits limits_;
  HittingSets sets_;
};

}  // namespace

std::vector<CandidateSet> Achievability::alternatives(const CandidateSet& wanted,
                                                      const std::vector<double>& belief,
                                                      std::size_t most, const Limits& limits) {
  return Alternatives(*this, wanted, belief, most, limits).run();
}

}  // namespace goal_alignment::achievability
