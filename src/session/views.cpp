// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "implementation.h"

/// What onlookers see of a session.
namespace goal_alignment::session {

using achievability::Conflict;
using questions::Knowledge;

namespace {

/// Progress is by phase: nobody knows beforehand how long a search takes.
constexpr float kPhases = 6;

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

Snapshot Session::Implementation::snapshot() const {
  Snapshot view;
  view.state = state_;
  view.progress = state_ == State::Done ? 1 : static_cast<float>(phase_) / kPhases;
  view.questions_asked = dialogue_.asked();
  if (!problem_) return view;
  view.specified = problem_->specified;
  view.condition = problem_->condition;
  const achievability::CandidateSet assumed = dialogue_.assumed();
  for (std::size_t f = 0; f < problem_->candidates.size(); ++f) {
    CandidateView candidate;
    candidate.fluent = problem_->candidates[f].fluent;
    candidate.is_static = problem_->candidates[f].is_static;
    candidate.answered_by = dialogue_.answeredBy(f);
    candidate.assumed = assumed.test(f);
    if (!beliefs_.empty()) candidate.probability = beliefs_[f];
    const Knowledge knowledge = dialogue_.knowledge()[f];
    candidate.state = knowledge == Knowledge::Wanted      ? CandidateState::Wanted
                      : knowledge == Knowledge::NotWanted ? CandidateState::NotWanted
                      : knowledge == Knowledge::Unsure    ? CandidateState::Unsure
                                                          : CandidateState::Open;
    view.candidates.push_back(std::move(candidate));
  }
  if (!robot_analysis_.achievability) return view;
  view.robot_known = true;

  const questions::Situation now = situation();
  view.planning = state_ == State::Analysing && phase_ == Phase::Decide && !anyLive();
  view.conflicts_complete = robot().complete();
  for (const Conflict& conflict : now.conflicts) {
    ConflictView shown = {fluents(conflict.members), conflict.proven, conflict.minimal,
                          now.isLive(conflict), cantBeHadAlone(conflict)};
    for (const std::size_t f : achievability::members(conflict.members)) {
      if (shown.live) view.candidates[f].conflicts.push_back(view.conflicts.size());
      if (conflict.proven && conflict.members.count() == 1) view.candidates[f].achievable = false;
    }
    view.conflicts.push_back(std::move(shown));
  }
  for (std::size_t f = 0; f < view.candidates.size(); ++f) {
    CandidateView& candidate = view.candidates[f];
    const bool free = candidate.conflicts.empty() &&
                      (robot().complete() || robot().alwaysTrue().test(f) || state_ == State::Done);
    if (candidate.state == CandidateState::Open && free) candidate.state = CandidateState::Settled;
  }
  if (question_) {
    for (const std::size_t f : dialogue_.openCandidates()) {
      view.candidates[f].state = CandidateState::Asked;
    }
    view.max_remaining = question_->max_remaining;
  }
  return view;
}

std::string Session::Implementation::spelling(const GroundName& ground) const {
  if (!problem_) return ground.text();
  const bool robot_knows =
      problem_->robot.findPredicate(ground.name) || problem_->robot.findSchema(ground.name);
  return (robot_knows ? problem_->robot : problem_->human).spelling(ground);
}

std::vector<std::string> Session::Implementation::parameterNames(const std::string& action) const {
  std::vector<std::string> names;
  if (!problem_) return names;
  const auto schema = problem_->robot.findSchema(action);
  if (!schema) return names;
  for (const pddl::Parameter& parameter :
       problem_->robot.schemas[static_cast<std::size_t>(*schema)].parameters) {
    names.push_back(parameter.name);
  }
  return names;
}

}  // namespace goal_alignment::session
