// SPDX-License-Identifier: BSD-3-Clause
#include "what_if_query.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "goal_alignment/common/quote.h"
#include "goal_alignment/phrasing/outcomes.h"
#include "goal_alignment/ros_common/message_conversion.h"

namespace goal_alignment::aligner {
namespace {

using session::ConflictView;
using session::Consequence;
using session::Snapshot;

bool contains(const std::vector<Literal>& fluents, const Literal& fluent) {
  return std::find(fluents.begin(), fluents.end(), fluent) != fluents.end();
}

// Why not; empty: it can be supposed.
std::string suppose(const Literal& fluent, const Snapshot& snapshot,
                    const phrasing::Phrases& phrases, WhatIfQuery& supposed) {
  const Literal opposite{fluent.atom, !fluent.negated};
  if (snapshot.candidateOf(fluent) != nullptr) {
    supposed.wanted.push_back(fluent);
  } else if (fluent.negated && snapshot.candidateOf(opposite) != nullptr) {
    supposed.not_wanted.push_back(opposite);
  } else if (contains(snapshot.specified, opposite)) {
    return phrases.say("suppose_asked_for", {phrases.clause(opposite)});
  } else if (!contains(snapshot.specified, fluent)) {
    return phrases.say("suppose_unexpected", {shortened(phrases.clause(fluent))});
  }
  return {};
}

std::string planOf(const std::vector<GroundName>& steps, const phrasing::Phrases& phrases) {
  return steps.empty() ? phrases.say("then_done") : phrases.counted("then_plan", steps.size());
}

std::string questionsOf(const Consequence& consequence, const phrasing::Phrases& phrases) {
  if (consequence.max_remaining == 0) return phrases.say("then_open");
  // A bound that may still change is none.
  if (consequence.bound_is_provisional) return phrases.say("then_some_questions");
  return phrases.counted("then_questions", consequence.max_remaining);
}

std::string followsFrom(const Consequence& consequence, const phrasing::Phrases& phrases) {
  switch (consequence.kind) {
    case Consequence::Kind::Plan:
      return planOf(consequence.plan, phrases);
    case Consequence::Kind::NoPlan:
      return phrases.say("then_impossible");
    default:
      return questionsOf(consequence, phrases);
  }
}

ConflictView conflictOf(const std::vector<Literal>& fluents, bool proven, const Snapshot& then) {
  const ConflictView* known = then.conflictOf(fluents);
  return known != nullptr ? *known : ConflictView{fluents, proven, false, true, false};
}

}  // namespace

WhatIfQuery supposition(const std::vector<Literal>& fluents, const Snapshot& snapshot,
                        const phrasing::Phrases& phrases) {
  WhatIfQuery supposed;
  for (const Literal& fluent : fluents) {
    supposed.refusal = suppose(fluent, snapshot, phrases, supposed);
    if (!supposed.refusal.empty()) return supposed;
  }
  for (const Literal& fluent : supposed.not_wanted) {
    if (!contains(supposed.wanted, fluent)) continue;
    supposed.refusal = phrases.say("suppose_twice", {phrases.clause(fluent)});
  }
  return supposed;
}

Explain::Response explainConsequence(const WhatIfQuery& supposed, const Consequence& consequence,
                                     const Snapshot& then, const phrasing::Phrases& phrases) {
  Explain::Response response;
  response.known = 1;
  response.text =
      phrases.say("suppose", {phrasing::supposition(phrases, supposed.wanted, supposed.not_wanted),
                              followsFrom(consequence, phrases)});
  if (consequence.conflict.empty() || consequence.kind == Consequence::Kind::Plan) return response;
  const ConflictView conflict =
      conflictOf(consequence.conflict, consequence.kind == Consequence::Kind::NoPlan, then);
  response.conflicts.push_back(ros_common::toMessage(conflict, phrases));
  response.text += " " + phrases.reason(consequence.conflict, conflict.proven, conflict.alone);
  return response;
}

Explain::Response notKnownYet(const phrasing::Phrases& phrases) {
  Explain::Response response;
  response.text = phrases.say("explain_unknown");
  return response;
}

SuppositionQueue::SuppositionQueue(std::function<void()> wakeUp) : nudge_(std::move(wakeUp)) {}

// A supposition that the planner fails at is told so; the thread has a session to look after.
std::optional<Explain::Response> SuppositionQueue::attempt(const Solve& solve,
                                                           const std::vector<Literal>& fluents) {
  try {
    return solve(fluents);
  } catch (const std::exception& error) {
    Explain::Response response;
    response.text = fmt::format("I can't tell: {}", error.what());
    return response;
  }
}

std::optional<Explain::Response> SuppositionQueue::ask(const std::vector<Literal>& fluents,
                                                       Clock::time_point deadline) {
  const auto job = std::make_shared<Job>();
  job->fluents = fluents;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    jobs_.push_back(job);
  }
  if (nudge_) nudge_();
  std::unique_lock<std::mutex> lock(mutex_);
  answered_.wait_until(lock, deadline, [&] { return job->response.has_value(); });
  job->given_up = true;
  jobs_.remove(job);
  return job->response;
}

bool SuppositionQueue::empty() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return jobs_.empty();
}

void SuppositionQueue::answerOne(const Solve& solve) {
  std::shared_ptr<Job> job;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (jobs_.empty()) return;
    job = jobs_.front();
    jobs_.pop_front();
  }
  auto response = attempt(solve, job->fluents);  // meanwhile nobody else may have to wait
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!response && !job->given_up) jobs_.push_back(job);
    job->response = std::move(response);
  }
  answered_.notify_all();
}

}  // namespace goal_alignment::aligner
