// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/alignment/beliefs.h"

namespace goal_alignment::session {

/// What "I don't know" means (doc: a plan must achieve the fluent, a proof may not rest on it).
enum class UnsurePolicy : std::uint8_t {
  AsYes = 0,  ///< the plan keeps the fluent, a proof of "no plan" may not use it
  Defer = 1,  ///< asks once more when nothing else is left to ask
  Abort = 2,  ///< the dialogue ends undecided
};

/// The final plan: any, one that costs the least, or one improved as long as the time limit lets.
enum class PlanMode : std::uint8_t { First, Optimal, Anytime };

/// All conflicts before the first question, or ask inside those already known.
enum class ConflictMode : std::uint8_t { Full, Lazy };

struct Options {
  std::string policy = "auto";  ///< a name of questions::policyNames()
  std::uint64_t seed = 0;       ///< breaks ties
  alignment::BeliefOptions belief;
  ConflictMode conflicts = ConflictMode::Full;
  /// Nothing: AsYes; for a session that is resumed, the one that it has.
  std::optional<UnsurePolicy> unsure_policy;
  std::size_t max_group_size = 1;    ///< fluents that one question may offer, 1 or more
  bool negative_candidates = false;  ///< "not f" is a candidate, too, where the robot may make f so
  /// Predicates that nobody is asked about. Their candidates are assumed to be wanted: a plan keeps
  /// them, a proof of "no plan" may not rest on them. Names match without case.
  std::vector<std::string> assumed_wanted_predicates;
  /// The same, assumed not to be wanted: what the plan promises then does not hold for them.
  std::vector<std::string> assumed_unwanted_predicates;
  /// What nobody was asked about is kept as long as that costs no more than this beyond a plan for
  /// what is wanted; else the person is asked. Not negative.
  double max_extra_cost = std::numeric_limits<double>::infinity();
  PlanMode plan = PlanMode::First;
  bool costs = false;             ///< use :action-costs where both models have them
  bool static_candidates = true;  ///< false takes static fluents out of policies `paper`, `ask-all`
  double time_limit =
      std::numeric_limits<double>::infinity();  ///< seconds of thinking, not waiting
  std::size_t memory_limit = std::size_t{2}
                             << 30U;  ///< bytes; accountable() says how many are counted
  int max_questions = -1;             ///< -1: as many as it takes
  int threads = 1;                    ///< for independent searches; the results do not depend on it
};

}  // namespace goal_alignment::session
