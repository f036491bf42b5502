// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "goal_alignment/common/random_source.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/session/session.h"
#include "oracles/lifted_space.h"

namespace goal_alignment::oracles {

/// Which candidates, by bit.
using CandidateBits = std::uint64_t;

/// A small HAGL problem with its oracle, and everything about it found out by enumeration.
class Hagl {
 public:
  session::Input input;  ///< as a session takes it
  pddl::Model robot;
  pddl::Model human;
  std::vector<Literal> specified;   ///< G^H, sorted
  std::vector<Literal> candidates;  ///< S^H \ G^H, sorted
  std::set<Literal> true_goal;      ///< G*

  /// Finds out what the robot can have; call it once the rest is there.
  void analyse();

  std::size_t size() const { return candidates.size(); }
  CandidateBits all() const { return (CandidateBits{1} << size()) - 1; }
  std::vector<Literal> fluents(CandidateBits set) const;
  CandidateBits bits(const std::vector<Literal>& fluents) const;
  CandidateBits wanted() const;
  bool wants(const Literal& fluent) const { return true_goal.count(fluent) > 0; }

  /// Whether the robot can have the candidates together with the specified goal.
  bool achievable(CandidateBits set) const { return achievable_[set]; }
  /// Whether the robot can have the candidate by itself.
  bool achievableAlone(std::size_t candidate) const;
  /// The unachievable sets of which every proper subset is achievable.
  std::set<CandidateBits> minimalConflicts() const;
  /// C(π^H) − C(π̂*_f) in the human model, unit costs, for every candidate.
  std::vector<double> costDifferences() const;

 private:
  std::vector<bool> achievable_;   // by set
  std::set<CandidateBits> alone_;  // what the reachable states hold of the candidates
};

/// The human's model lacks some preconditions and deletes of the robot's, believes other things of
/// the initial state, and each may know predicates and objects that the other does not. π^H is a
/// random walk in the human's model, G^H and G* are drawn from where it ends.
Hagl randomHagl(RandomSource& random, std::size_t most_candidates = 9);

/// A random problem that needs a dialogue: G^H is achievable for the robot, all of S^H is not.
Hagl randomDisputedHagl(RandomSource& random, std::size_t most_candidates = 9);

}  // namespace goal_alignment::oracles
