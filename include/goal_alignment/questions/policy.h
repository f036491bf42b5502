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

  /// No fluent of it was answered NO: its answers still decide something.
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

/// One way to choose questions. A policy sees one dialogue from its begin to its end.
class Policy {
 public:
  virtual ~Policy() = default;

  /// The next question, or nothing where this policy has none left to ask.
  virtual std::optional<Choice> next(const Situation& situation) = 0;

  /// Whether it wants all conflicts (where the session finds them first) rather than going by
  /// planner calls alone.
  virtual bool usesConflicts() const = 0;
};

/// What a policy is made from. The functions are called when a policy needs what they give, for
/// they may search.
struct PolicyContext {
  std::vector<bool> is_static;  ///< by candidate
  bool ask_static = true;       ///< whether policies without conflicts ask about those
  std::uint64_t seed = 0;       ///< breaks ties
  std::function<std::vector<double>()> paper_beliefs;     ///< p as Algorithm 1 has it
  std::function<std::vector<bool>()> unachievable_alone;  ///< F̂
  /// Called every millisecond or so while a policy computes; may throw to make next() end.
  std::function<void()> poll;
};

/// Throws std::invalid_argument that names the policies there are.
std::unique_ptr<Policy> makePolicy(const std::string& name, PolicyContext setting);

/// The names makePolicy() knows, in the order of the documentation.
std::vector<std::string> policyNames();

}  // namespace goal_alignment::questions
