// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/phrasing/vocabulary.h"

namespace goal_alignment::phrasing {

/// The alternatives to what can't be had, in a spoken dialogue: what the robot says next, given
/// what it hears or does not hear. It ends with a choice, with "none", or when after `retries` of
/// either kind nothing was understood: what is said hours later chooses nothing.
class SpokenChoice {
 public:
  /// `vocabulary`, which knows what is said at the end, outlives this. `told` is said first; the
  /// first `listed` alternatives are in it already. `offered` names each by what has to be left
  /// out.
  SpokenChoice(const Vocabulary& vocabulary, const std::string& told, std::size_t listed,
               std::vector<std::string> offered, int retries);

  /// What the person's words, or their silence, lead to.
  struct Turn {
    bool ended = false;
    std::optional<std::size_t> chosen;  ///< of `offered`
    std::string say;                    ///< may be empty
  };

  const std::string& asked() const { return asked_; }
  Turn hear(const std::string& said);
  Turn silence();

 private:
  std::string choices(std::size_t listed) const;
  std::string answers() const;

  const Vocabulary& vocabulary_;
  const EndSayings& sayings_;
  std::vector<std::string> offered_;
  std::string asked_;
  int misunderstandings_left_;
  int silences_left_;
};

/// "It has 12 steps. The first: …. The last: …." `steps` in words; none: nothing is said.
std::string spokenPlan(const EndSayings& sayings, const std::vector<std::string>& steps);

}  // namespace goal_alignment::phrasing
