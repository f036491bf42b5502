// SPDX-License-Identifier: BSD-3-Clause
#include "views.h"

#include <algorithm>
#include <utility>

#include "decision.h"
#include "fluents.h"
#include "open_question.h"

namespace goal_alignment::session {

using achievability::Conflict;
using questions::Knowledge;

namespace {

CandidateState stateFor(Knowledge knowledge) {
  switch (knowledge) {
    case Knowledge::Wanted:
      return CandidateState::Wanted;
    case Knowledge::NotWanted:
      return CandidateState::NotWanted;
    case Knowledge::Unsure:
      return CandidateState::Unsure;
    case Knowledge::Open:
      break;
  }
  return CandidateState::Open;
}

std::vector<CandidateView> answersIn(const Dialogue& dialogue, const Analysis& analysis) {
  const alignment::Problem& problem = analysis.problem();
  const achievability::CandidateSet assumed = dialogue.assumed();
  std::vector<CandidateView> views;
  for (std::size_t f = 0; f < problem.candidates.size(); ++f) {
    CandidateView view;
    view.fluent = problem.candidates[f].fluent;
    view.is_static = problem.candidates[f].is_static;
    view.answered_by = dialogue.answeredBy(f);
    view.assumed = assumed.test(f);
    if (!analysis.beliefs().empty()) view.probability = analysis.beliefs()[f];
    view.state = stateFor(dialogue.knowledge()[f]);
    views.push_back(std::move(view));
  }
  return views;
}

void addConflicts(const Dialogue& dialogue, const Analysis& analysis, Snapshot& snapshot) {
  const questions::Situation now = analysis.situation(dialogue.knowledge());
  for (const Conflict& conflict : now.conflicts) {
    ConflictView view = {fluentsOf(analysis.problem(), conflict.members), conflict.proven,
                         conflict.minimal, now.isLive(conflict),
                         isUnachievableAlone(analysis, conflict)};
    for (const std::size_t f : achievability::members(conflict.members)) {
      CandidateView& candidate = snapshot.candidates[f];
      if (view.live) candidate.conflicts.push_back(snapshot.conflicts.size());
      if (conflict.proven && conflict.members.count() == 1) candidate.achievable = false;
    }
    snapshot.conflicts.push_back(std::move(view));
  }
}

/// What can't change the outcome any more.
void settle(const Analysis& analysis, bool is_done, std::vector<CandidateView>& candidates) {
  const achievability::Achievability& robot = analysis.robot();
  for (std::size_t f = 0; f < candidates.size(); ++f) {
    CandidateView& candidate = candidates[f];
    const bool free =
        candidate.conflicts.empty() && (robot.complete() || robot.alwaysTrue().test(f) || is_done);
    if (candidate.state == CandidateState::Open && free) candidate.state = CandidateState::Settled;
  }
}

}  // namespace

bool ConflictView::isOf(const std::vector<Literal>& these) const {
  return std::is_permutation(fluents.begin(), fluents.end(), these.begin(), these.end());
}

const CandidateView* Snapshot::candidateOf(const Literal& fluent) const {
  for (const CandidateView& candidate : candidates) {
    if (candidate.fluent == fluent) return &candidate;
  }
  return nullptr;
}

const ConflictView* Snapshot::conflictOf(const std::vector<Literal>& these) const {
  for (const ConflictView& conflict : conflicts) {
    if (conflict.isOf(these)) return &conflict;
  }
  return nullptr;
}

Snapshot snapshotOf(const Stage& stage, const Dialogue& dialogue, const Analysis& analysis,
                    const std::optional<QuestionView>& question) {
  Snapshot snapshot;
  snapshot.state = stage.state;
  snapshot.progress = stage.progress;
  snapshot.questions_asked = dialogue.asked();
  if (!analysis.hasProblem()) return snapshot;
  snapshot.specified = analysis.problem().specified;
  snapshot.condition = analysis.problem().condition;
  snapshot.candidates = answersIn(dialogue, analysis);
  if (!analysis.hasRobot()) return snapshot;
  snapshot.robot_known = true;
  snapshot.planning = stage.is_deciding && !anyLive(dialogue, analysis);
  snapshot.conflicts_complete = analysis.robot().complete();
  addConflicts(dialogue, analysis, snapshot);
  settle(analysis, stage.state == State::Done, snapshot.candidates);
  if (!question) return snapshot;
  for (const std::size_t f : dialogue.openCandidates())
    snapshot.candidates[f].state = CandidateState::Asked;
  snapshot.max_remaining = question->max_remaining;
  return snapshot;
}

}  // namespace goal_alignment::session
