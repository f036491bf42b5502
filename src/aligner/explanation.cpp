// SPDX-License-Identifier: BSD-3-Clause
#include "explanation.h"

#include <algorithm>
#include <vector>

#include "goal_alignment/phrasing/outcomes.h"
#include "speaker.h"

namespace goal_alignment::aligner {
namespace {

using session::CandidateState;
using session::CandidateView;
using session::ConflictView;

class WhySpeaker : public Speaker {
 public:
  explicit WhySpeaker(const ExplanationContext& explained) : Speaker(explained) {}

  void speakOf(const Literal& fluent) {
    if (contains(snapshot().specified, fluent)) {
      say("explain_asked_for", {that(fluent)});
    } else if (const CandidateView* candidate = snapshot().candidateOf(fluent)) {
      speakOf(*candidate);
    } else if (!modelsAreRead()) {
      admitIgnorance();
    } else {
      say("explain_irrelevant", {that(fluent)});
    }
  }

  // As it was told with the question.
  void speakOfOpenQuestion() {
    add(explained_.open_why);
    for (const ConflictView& conflict : snapshot().conflicts) {
      const auto rests = [&](const std::vector<Literal>& reason) { return conflict.isOf(reason); };
      const auto& reasons = explained_.open_conflicts;
      if (std::any_of(reasons.begin(), reasons.end(), rests)) note(conflict);
    }
  }

  // What the outcome rests on; where there is none, why nothing is asked.
  void speakOfOutcome() {
    const std::vector<Literal>& fluents = explained_.outcome_conflict;
    const ConflictView* conflict = fluents.empty() ? nullptr : snapshot().conflictOf(fluents);
    if (conflict != nullptr) {
      restOn(*conflict);
    } else if (explained_.outcome == session::OutcomeCode::GoalUnsolvable) {
      // There are no words for a condition.
      add(phrasing::goalUnsolvable(
          phrases(), snapshot().condition.empty() ? snapshot().specified : std::vector<Literal>{}));
      if (!explained_.human_plan_break.empty())
        say("own_plan_fails", {explained_.human_plan_break});
    } else if (hasEnded()) {
      say("explain_no_question");
    } else {
      admitIgnorance();
    }
  }

 private:
  void speakOf(const CandidateView& candidate) {
    const bool answered = speakOfAnswer(candidate);
    bool any = false;
    for (const ConflictView& conflict : snapshot().conflicts) {
      // One that a NO to something else has settled is no reason any more.
      const bool counts = conflict.live || candidate.state == CandidateState::NotWanted;
      if (!counts || !contains(conflict.fluents, candidate.fluent)) continue;
      restOn(conflict);
      any = true;
    }
    if (any || answered) return;
    if (candidate.state == CandidateState::Settled || snapshot().conflicts_complete) {
      say("explain_no_influence", {that(candidate.fluent)});
    } else {
      admitIgnorance();
    }
  }
};

class WhyNotSpeaker : public Speaker {
 public:
  explicit WhyNotSpeaker(const ExplanationContext& explained) : Speaker(explained) {}

  void speakOf(const Literal& fluent) {
    if (contains(snapshot().specified, fluent)) {
      say("why_not_asked_for", {that(fluent)});
    } else if (const CandidateView* candidate = snapshot().candidateOf(fluent)) {
      speakOf(*candidate);
    } else if (!modelsAreRead()) {
      admitIgnorance();
    } else {
      say("why_not_irrelevant", {that(fluent)});
    }
  }

  // Why the robot does not simply do as the person would.
  void speakOfHumanPlan() {
    const std::vector<GroundName>& plan = explained_.human_plan;
    if (!modelsAreRead()) {
      admitIgnorance();
    } else if (plan.empty()) {
      say("own_plan_missing");
    } else if (!explained_.human_plan_break.empty()) {
      say("own_plan_fails", {explained_.human_plan_break});
    } else if (!snapshot().robot_known) {
      admitIgnorance();
    } else if (!planIsFound()) {
      say("own_plan_works");
    } else if (explained_.plan == plan) {
      say("own_plan_followed");
    } else {
      add(phrases().counted("own_plan_left", explained_.plan.size()));
    }
  }

 private:
  bool planIsFound() const { return explained_.outcome == session::OutcomeCode::Success; }

  void speakOf(const CandidateView& candidate) {
    if (candidate.state == CandidateState::Asked) {
      say("why_not_does_ask", {that(candidate.fluent)});
      restOnThoseOf(candidate, true);
    } else if (speakOfAnswer(candidate)) {
      restOnThoseOf(candidate, candidate.state != CandidateState::NotWanted);
    } else {
      speakOfUnasked(candidate);
    }
    const bool kept = planIsFound() && candidate.state != CandidateState::NotWanted;
    if (kept) say("why_not_kept");
  }

  void speakOfUnasked(const CandidateView& candidate) {
    const std::vector<std::string> what = {that(candidate.fluent)};
    if (!candidate.conflicts.empty()) {
      say(hasEnded() ? "why_not_ended" : "why_not_yet", what);
      restOnThoseOf(candidate, true);
    } else if (candidate.state != CandidateState::Settled && !snapshot().conflicts_complete) {
      admitIgnorance();
    } else if (isInConflict(candidate)) {
      say("why_not_cleared", what);
      restOnThoseOf(candidate, false);
    } else {
      say("why_not_settled", what);
    }
  }

  bool isInConflict(const CandidateView& candidate) const {
    const auto& conflicts = snapshot().conflicts;
    return std::any_of(conflicts.begin(), conflicts.end(), [&](const ConflictView& conflict) {
      return contains(conflict.fluents, candidate.fluent);
    });
  }

  void restOnThoseOf(const CandidateView& candidate, bool live_only) {
    for (const ConflictView& conflict : snapshot().conflicts) {
      if (live_only && !conflict.live) continue;
      if (contains(conflict.fluents, candidate.fluent)) restOn(conflict);
    }
  }
};

}  // namespace

Explain::Response explainWhy(const ExplanationContext& explained,
                             const std::vector<Literal>& fluents) {
  WhySpeaker speaker(explained);
  if (fluents.empty() && !explained.open_why.empty()) {
    speaker.speakOfOpenQuestion();
    return speaker.response();
  }
  const std::vector<Literal>& about = fluents.empty() ? explained.open_question : fluents;
  for (const Literal& fluent : about)
    speaker.speakOf(fluent);
  if (about.empty()) speaker.speakOfOutcome();
  return speaker.response();
}

Explain::Response explainWhyNot(const ExplanationContext& explained,
                                const std::vector<Literal>& fluents) {
  WhyNotSpeaker speaker(explained);
  for (const Literal& fluent : fluents)
    speaker.speakOf(fluent);
  if (fluents.empty()) speaker.speakOfHumanPlan();
  return speaker.response();
}

}  // namespace goal_alignment::aligner
