// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/supposition.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "goal_alignment/common/quote.h"
#include "goal_alignment/phrasing/outcomes.h"
#include "goal_alignment/ros_interface/message_conversion.h"

namespace goal_alignment::ros_interface {
namespace {

using session::ConflictView;
using session::Consequence;
using session::Snapshot;

bool contains(const std::vector<Literal>& fluents, const Literal& fluent) {
  return std::find(fluents.begin(), fluents.end(), fluent) != fluents.end();
}

// Why not; empty: it can be supposed.
std::string suppose(const Literal& fluent, const Snapshot& snapshot, Supposition& supposed) {
  const Literal opposite{fluent.atom, !fluent.negated};
  if (snapshot.candidateOf(fluent) != nullptr) {
    supposed.wanted.push_back(fluent);
  } else if (fluent.negated && snapshot.candidateOf(opposite) != nullptr) {
    supposed.not_wanted.push_back(opposite);
  } else if (contains(snapshot.specified, opposite)) {
    return fmt::format("{} is part of the specified goal", opposite.text());
  } else if (!contains(snapshot.specified, fluent)) {
    return shortened(fluent.text()) + " is outside the state that the person expects";
  }
  return {};
}

std::string counted(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string planOf(const std::vector<GroundName>& steps) {
  if (steps.empty()) return "all would be so already, without a step.";
  return fmt::format("I'd have a plan, of {}.", counted(steps.size(), "step"));
}

Conflict conflictOf(const std::vector<Literal>& fluents, bool proven, const Snapshot& then,
                    const phrasing::Phrases& phrases) {
  if (const ConflictView* known = then.conflictOf(fluents)) return toMessage(*known, phrases);
  return toMessage(ConflictView{fluents, proven, false, true}, phrases);
}

}  // namespace

Supposition supposition(const std::vector<Literal>& fluents, const Snapshot& snapshot) {
  Supposition supposed;
  for (const Literal& fluent : fluents) {
    supposed.refusal = suppose(fluent, snapshot, supposed);
    if (!supposed.refusal.empty()) return supposed;
  }
  for (const Literal& fluent : supposed.not_wanted) {
    if (!contains(supposed.wanted, fluent)) continue;
    supposed.refusal = fluent.text() + " can't be both wanted and not wanted";
  }
  return supposed;
}

Explain::Response explainConsequence(const Supposition& supposed, const Consequence& consequence,
                                     const Snapshot& then, const phrasing::Phrases& phrases) {
  using Kind = Consequence::Kind;
  Explain::Response response;
  response.known = 1;
  const bool anything = !supposed.wanted.empty() || !supposed.not_wanted.empty();
  response.text = anything
                      ? phrasing::supposition(phrases, supposed.wanted, supposed.not_wanted) + ": "
                      : "As things stand: ";
  bool proven = true;
  if (!consequence.conflict.empty()) {
    response.conflicts.push_back(
        conflictOf(consequence.conflict, consequence.kind == Kind::NoPlan, then, phrases));
    proven = response.conflicts.front().proven != 0;
  }
  const std::string reason = phrases.reason(consequence.conflict, proven);
  if (consequence.kind == Kind::Plan) {
    response.text += planOf(consequence.plan);
  } else if (consequence.kind == Kind::NoPlan) {
    response.text += "I could not do it." + (reason.empty() ? "" : " " + reason);
  } else if (consequence.max_remaining == 0) {
    response.text += "it would stay undecided." + (reason.empty() ? "" : " " + reason);
  } else {
    response.text += fmt::format("I'd have to ask at most {}.{}",
                                 counted(consequence.max_remaining, "more question"),
                                 reason.empty() ? "" : " " + reason);
  }
  return response;
}

Explain::Response notKnownYet() {
  Explain::Response response;
  response.text = "Not known yet.";
  return response;
}

SuppositionQueue::SuppositionQueue(std::function<void()> nudge) : nudge_(std::move(nudge)) {}

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

}  // namespace goal_alignment::ros_interface
