// SPDX-License-Identifier: BSD-3-Clause
#include "alternatives.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <utility>

/// What to give up of all that is wanted: the cheapest sets that hit all conflicts within it, where
/// giving up f costs −log(1 − belief). Conflicts that are not known yet come to light when a set
/// that hits the known ones is checked.
namespace goal_alignment::achievability {

namespace {

/// How many sets are expanded in order; those that are left then are completed greedily.
constexpr std::size_t kMaxNodes = 5'000;

/// However sure the belief, giving a candidate up costs something and is never out of the question.
constexpr double kMinCost = 1e-9;
constexpr double kMaxCost = 50;

/// A set to give up, and what must not be given up on this branch: other branches do that, so that
/// no set is visited twice.
struct Node {
  CandidateSet given_up;
  CandidateSet kept;
  double bound = 0;  ///< no set on this branch costs less
  double cost = 0;   ///< of what is given up so far
};

/// The lowest bound first; of equals the one that has given up most, and then the first by index.
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

/// The branches still open and the sets found, by what the conflicts known so far say.
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

  /// Whether a subset was found before, so that this set gives up more than is needed.
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

  /// The cheapest member of the conflict.
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
    // Conflicts that share no candidate are paid for separately.
    CandidateSet paid = ~wanted_ | node.kept;
    CandidateSet used(wanted_.size());
    for (const Conflict& conflict : conflicts) {
      if (!conflict.members.is_subset_of(wanted_) || conflict.members.intersects(node.given_up))
        continue;
      const CandidateSet left = conflict.members - paid;
      if (left.none()) return;  // nothing on this branch can hit it
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

/// The search through the sets. Its steps return false when the limits end them.
class Alternatives {
 public:
  Alternatives(Achievability& robot, const CandidateSet& wanted, const std::vector<double>& belief,
               std::size_t max_sets, const Limits& limits)
      : robot_(robot),
        wanted_(wanted),
        max_sets_(max_sets),
        limits_(limits),
        sets_(wanted, belief) {}

  std::vector<CandidateSet> run() {
    LimitMonitor monitor(limits_);
    for (std::size_t taken = 0; !sets_.empty() && sets_.count() < max_sets_; ++taken) {
      if (monitor.poll() != LimitReason::None) break;
      const Node node = sets_.pop();
      if (sets_.superfluous(node.given_up)) continue;
      if (!(taken < kMaxNodes ? expand(node) : completeGreedily(node))) break;
    }
    return std::move(sets_).found();
  }

 private:
  /// The set is one that is looked for, or a conflict that it does not hit gives its children.
  bool expand(const Node& node) {
    bool interrupted = false;
    const auto conflict = conflictLeft(node.given_up, interrupted);
    if (conflict) {
      sets_.branch(node, *conflict, robot_.conflicts());
    } else if (!interrupted) {
      sets_.add(node.given_up);
    }
    return !interrupted;
  }

  /// Gives up the cheapest member of each conflict, then takes back what that made needless.
  bool completeGreedily(const Node& node) {
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

  /// A conflict, proven or suspected, in what is wanted without the set. Nothing: there is a plan,
  /// or the limits ended the check, which `interrupted` says.
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
  std::size_t max_sets_;
  Limits limits_;
  HittingSets sets_;
};

}  // namespace

std::vector<CandidateSet> findAlternatives(Achievability& robot, const CandidateSet& wanted,
                                           const std::vector<double>& belief,
                                           std::size_t max_alternatives, const Limits& limits) {
  return Alternatives(robot, wanted, belief, max_alternatives, limits).run();
}

}  // namespace goal_alignment::achievability
