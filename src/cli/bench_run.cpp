// SPDX-License-Identifier: BSD-3-Clause
#include "bench_run.h"

#include <algorithm>
#include <utility>

#include "goal_alignment/common/stopwatch.h"
#include "goal_alignment/questions/clairvoyant.h"

namespace goal_alignment::cli {

using achievability::CandidateSet;
using achievability::Conflict;
using session::AnswerKind;
using session::CandidateState;
using session::CandidateView;
using session::OutcomeCode;
using session::OutcomeKind;
using session::Session;
using session::Snapshot;
using session::State;

namespace {

/// A decided outcome leaves candidates in live conflicts open: more answers could not change it.
bool isSettled(const CandidateView& candidate, OutcomeCode outcome) {
  const OutcomeKind kind = session::outcomeTraits(outcome).kind;
  const bool decided = kind == OutcomeKind::PlanFound || kind == OutcomeKind::NoPlan;
  return candidate.state == CandidateState::Settled ||
         (decided && candidate.state == CandidateState::Open);
}

template <typename Condition>
std::size_t countOf(const std::vector<CandidateView>& candidates, Condition condition) {
  return static_cast<std::size_t>(std::count_if(candidates.begin(), candidates.end(), condition));
}

CandidateSet setOf(const std::vector<Literal>& fluents, const std::vector<Literal>& candidates) {
  CandidateSet set(candidates.size());
  for (const Literal& fluent : fluents) {
    const auto place = std::find(candidates.begin(), candidates.end(), fluent);
    set.set(static_cast<std::size_t>(place - candidates.begin()));
  }
  return set;
}

/// The conflicts that answers decide about. One that an assumption hits is none; of the others
/// only what nobody assumed is asked about, and where that is nothing no answer helps.
std::vector<Conflict> askable(const Snapshot& view, const std::vector<Literal>& candidates) {
  std::vector<Literal> assumed;
  for (const CandidateView& candidate : view.candidates)
    if (candidate.assumed) assumed.push_back(candidate.fluent);
  const CandidateSet unasked = setOf(assumed, candidates);
  std::vector<Conflict> conflicts;
  for (const session::ConflictView& shown : view.conflicts) {
    if (!shown.live) continue;
    const CandidateSet left = setOf(shown.fluents, candidates) - unasked;
    if (left.any() || shown.fluents.empty())
      conflicts.push_back({left, shown.proven, shown.minimal});
  }
  return conflicts;
}

}  // namespace

RunningSessions::Entry::Entry(RunningSessions& sessions, Session& session)
    : sessions_(sessions), session_(session) {
  const std::lock_guard<std::mutex> lock(sessions_.mutex_);
  sessions_.running_.insert(&session_);
  if (sessions_.cancelled()) session_.cancel();
}

RunningSessions::Entry::~Entry() {
  const std::lock_guard<std::mutex> lock(sessions_.mutex_);
  sessions_.running_.erase(&session_);
}

void RunningSessions::cancelAll() {
  const std::lock_guard<std::mutex> lock(mutex_);
  cancelled_.cancel();
  for (Session* session : running_)
    session->cancel();
}

RunFigures alignOnce(session::Input input, const session::Options& options, const Wants& wants,
                     RunningSessions& sessions) {
  RunFigures figures;
  Session session(options);
  session.begin(std::move(input));
  const RunningSessions::Entry entry(sessions, session);
  Stopwatch watch;
  const auto thought = [&] {
    const double seconds = watch.lap();
    if (figures.rounds == 0)
      figures.first_question = seconds;
    else
      figures.per_answer.push_back(seconds);
  };
  while (session.step() != State::Done) {
    if (session.state() != State::AwaitingAnswer) continue;
    thought();
    const std::vector<Literal> fluents = session.question()->fluents;
    // All of a group was looked at, also what the first answers of it make needless.
    figures.questions += fluents.size();
    ++figures.rounds;
    for (const Literal& fluent : fluents)
      session.answer({fluent}, wants(fluent) ? AnswerKind::Yes : AnswerKind::No, "truth");
  }
  thought();
  const Snapshot view = session.snapshot();
  figures.outcome = session.outcome().code;
  figures.candidates = view.candidates.size();
  figures.candidates_static = countOf(view.candidates, [](const auto& c) { return c.is_static; });
  figures.settled =
      countOf(view.candidates, [&](const auto& c) { return isSettled(c, figures.outcome); });
  figures.spent = session.statistics();
  return figures;
}

std::size_t Analysis::minimum(const Wants& wants) const {
  CandidateSet wanted(candidates.size());
  for (std::size_t f = 0; f < candidates.size(); ++f)
    wanted[f] = wants(candidates[f]);
  return questions::clairvoyantMinimum(conflicts, wanted);
}

Analysis analyse(session::Input input, session::Options options, RunningSessions& sessions) {
  options.policy = "auto";
  options.conflicts = session::ConflictMode::Full;
  Session session(options);
  session.begin(std::move(input));
  const RunningSessions::Entry entry(sessions, session);
  while (session.step() == State::Analysing) {
  }
  Analysis analysis;
  analysis.outcome = session.outcome();
  const Snapshot view = session.snapshot();
  for (const CandidateView& candidate : view.candidates)
    analysis.candidates.push_back(candidate.fluent);
  // A plan for everything, or none for what was asked for: there are no other conflicts to find.
  const OutcomeCode code = analysis.outcome.code;
  analysis.conflicts_known = view.conflicts_complete || code == OutcomeCode::Success ||
                             code == OutcomeCode::GoalUnsolvable;
  if (code != OutcomeCode::GoalUnsolvable) analysis.conflicts = askable(view, analysis.candidates);
  return analysis;
}

}  // namespace goal_alignment::cli
