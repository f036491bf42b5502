// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/spatial_facts/rules.h"

namespace goal_alignment::spatial_facts {

/// What somebody knows about a FramePair.
struct Sighting {
  bool known = false;
  Vector position;            ///< of the origin of `of`, in `in`
  std::optional<double> age;  ///< seconds; none: it never moves. Negative: it lies in the future
  std::string why;            ///< why it is not known
};

/// Atoms of one group that nobody can tell just now.
struct Doubt {
  GroundName key;  ///< see Rule::key
  std::vector<GroundName> atoms;
  Unknown unknown = Unknown::Fail;
  std::string reason;  ///< names frame and age
};

/// What the rules say of their atoms.
struct Observation {
  std::shared_ptr<const Rules> rules;  ///< null: there are none
  std::set<GroundName> holds;          ///< all other atoms that the rules own are false, but for
  std::vector<Doubt> doubts;           ///< these

  /// The atoms that are neither true nor false, with Unknown::Fail. Empty: all can be told.
  std::vector<GroundName> unknown() const;
  /// One or two sentences that name the unknown atoms, the frames and their age.
  std::string unknownFactsMessage() const;
  /// Replaces all atoms that the rules own. What the file is trusted for stays; what is unknown
  /// goes.
  void overlay(std::set<GroundName>& atoms) const;

  /// Whether the same is true, and the same unknown.
  bool tellsTheSame(const Observation& other) const;
};

/// Looks at where things are, once and again, and remembers what it saw: what is in a region leaves
/// it only when it is more than the margin outside.
class Observer {
 public:
  explicit Observer(std::shared_ptr<const Rules> rules);

  const std::shared_ptr<const Rules>& rules() const { return rules_; }

  /// `sightings` in the order of Rules::pairs(). O(pairs + probes · shapes of a region).
  Observation observe(const std::vector<Sighting>& sightings);

 private:
  // By group: what was so when it was last known.
  struct Memory {
    std::vector<bool> held;             // by probe
    std::optional<std::size_t> region;  // with exactly_one: which option
  };

  std::shared_ptr<const Rules> rules_;
  std::vector<std::vector<Memory>> memories_;  // by rule, by group
};

}  // namespace goal_alignment::spatial_facts
