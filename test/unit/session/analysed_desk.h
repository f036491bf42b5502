// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <utility>

#include "samples.h"
#include "session/analysis.h"
#include "session/dialogue.h"
#include "session/thinking_budget.h"

namespace goal_alignment::session::samples {

/// The desk with all its conflicts found and nobody asked yet, for tests of a session's parts. The
/// candidates are (down a) (down c) (free) (held a) (held b) (red a).
struct AnalysedDesk {
  explicit AnalysedDesk(Options chosen = {})
      : options(std::move(chosen)),
        budget(options.time_limit, options.memory_limit),
        analysis(options, budget) {
    analysis.read(desk());
    analysis.analyseRobot();
    analysis.believe();
    analysis.findConflicts(~none());
    dialogue = Dialogue(analysis.problem());
  }

  achievability::CandidateSet none() const {
    return achievability::CandidateSet(analysis.problem().candidates.size());
  }

  achievability::CandidateSet setOf(const std::vector<std::string>& texts) const {
    achievability::CandidateSet set = none();
    for (const std::string& text : texts)
      set.set(*Dialogue(analysis.problem()).find(literal(text)));
    return set;
  }

  void answer(const std::vector<std::string>& texts, AnswerKind kind) {
    dialogue.answer(literals(texts), kind, "me", false);
  }

  Options options;
  ThinkingBudget budget;
  Analysis analysis;
  Dialogue dialogue;
};

}  // namespace goal_alignment::session::samples
