// SPDX-License-Identifier: BSD-3-Clause
#include "explanation_feed.h"

#include <chrono>
#include <utility>

#include "explanation.h"
#include "goal_alignment/ros_common/message_conversion.h"
#include "goal_alignment/ros_common/names.h"
#include "what_if_query.h"

namespace goal_alignment::aligner {

ExplanationFeed::ExplanationFeed(const SessionRecord& current, Explainer& explainer)
    : current_(current), explainer_(explainer) {}

void ExplanationFeed::show(const session::Snapshot& now) {
  const session::Session& session = *current_.session;
  ExplanationContext context;
  context.snapshot = now;
  if (const auto& question = session.question()) {
    context.open_question = question->fluents;
    context.open_why = ros_common::toMessage(*question, current_.phrases).why;
    for (const session::Reason& reason : question->reasons)
      context.open_conflicts.push_back(reason.conflict);
  }
  if (now.state == session::State::Done) {
    const session::Outcome& outcome = session.outcome();
    context.outcome = outcome.code;
    context.outcome_conflict = outcome.conflict;
    context.plan = outcome.plan.steps;
  }
  context.human_plan = current_.human_plan;
  context.human_plan_break = current_.planBreak();
  context.phrases = current_.phrases;
  explainer_.show(std::move(context));
}

void ExplanationFeed::answerQuery() {
  explainer_.suppositions().answerOne(
      [this](const std::vector<Literal>& fluents) { return whatIf(fluents); });
}

std::optional<Explain::Response> ExplanationFeed::whatIf(const std::vector<Literal>& fluents) {
  using Clock = std::chrono::steady_clock;
  session::Session& session = *current_.session;
  const WhatIfQuery query = supposition(fluents, session.snapshot(), current_.phrases);
  if (!query.refusal.empty()) {
    Explain::Response response;
    response.text = query.refusal;
    return response;
  }
  const auto began = Clock::now();
  const session::Consequence consequence =
      session.whatIf(query.wanted, query.not_wanted, ros_common::kSupposeSeconds);
  if (consequence.kind == session::Consequence::Kind::Unknown) {
    // If it gave up before its time was out, trying again would not help.
    const std::chrono::duration<double> took = Clock::now() - began;
    return took.count() < ros_common::kSupposeSeconds
               ? std::make_optional(notKnownYet(current_.phrases))
               : std::nullopt;
  }
  return explainConsequence(query, consequence, session.snapshot(), current_.phrases);
}

}  // namespace goal_alignment::aligner
