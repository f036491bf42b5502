// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/achievability/candidate_set.h"

/// Which candidate to ask about next.
namespace goal_alignment::questions {

/// What is known of a candidate from the person.
enum class Knowledge : std::uint8_t { Open, Wanted, NotWanted, Unsure };

/// The dialogue as a policy sees it.
struct Situation {
  std::vector<Knowledge> knowledge;                ///< by candidate
  std::vector<double> probability;                 ///< p(f ∈ G*)
  std::vector<achievability::Conflict> conflicts;  ///< all that are known

  /// Whether no candidate of it was answered NO, so that its answers still decide something.
  bool isLive(const achievability::Conflict& conflict) const;
  /// How many of its candidates nobody has answered yet.
  std::size_t openMembers(const achievability::Conflict& conflict) const;
  /// The open candidates in live conflicts: no other answer decides anything.
  achievability::CandidateSet relevantCandidates() const;
};

/// The live conflict with the candidate in it that has the fewest open candidates, proven ones
/// first: the shortest reason for asking.
std::optional<std::size_t> smallestLiveConflict(const Situation& situation, std::size_t candidate);

/// What to ask, and the live conflict that makes its answer matter, if there is one.
struct Choice {
  std::size_t candidate = 0;
  std::optional<std::size_t> conflict;  ///< index in Situation::conflicts
};

/// One way to choose questions. A policy object serves one dialogue from its beginning to its end.
class Policy {
 public:
  virtual ~Policy() = default;

  /// The next question, or nothing where this policy has none left to ask.
  virtual std::optional<Choice> next(const Situation& situation) = 0;

  /// Whether it wants all conflicts (where the session finds them first) rather than going by
  /// planner calls alone.
  virtual bool usesConflicts() const = 0;
};

/// What a policy is made from. The functions may search, so they are called only when a policy
/// needs what they return.
struct PolicyContext {
  std::vector<bool> is_static;  ///< by candidate
  bool ask_static = true;       ///< whether policies without conflicts ask about those
  std::uint64_t seed = 0;       ///< breaks ties
  std::function<std::vector<double>()> paper_beliefs;  ///< p(f ∈ G*) as Algorithm 1 computes it
  std::function<std::vector<bool>()> unachievable_alone;  ///< F̂
  /// Called every millisecond or so while a policy computes; may throw to make next() end.
  std::function<void()> poll;
};

/// Throws std::invalid_argument for an unknown name, with the names that there are.
std::unique_ptr<Policy> makePolicy(const std::string& name, PolicyContext context);

/// The names makePolicy() knows, in the order of the documentation.
std::vector<std::string> policyNames();

}  // namespace goal_alignment::questions
