// SPDX-License-Identifier: BSD-3-Clause
#include "explainer.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "goal_alignment/ros_common/message_conversion.h"

namespace goal_alignment::aligner {
namespace {

Explain::Response unknown(const std::string& text) {
  Explain::Response response;
  response.text = text;
  return response;
}

// Nor, therefore, a language.
Explain::Response noTask() {
  return unknown(phrasing::Phrases().say("explain_no_task"));
}

}  // namespace

Explainer::Explainer(std::function<void()> wakeUp) : suppositions_(std::move(wakeUp)) {}

void Explainer::show(ExplanationContext explained) {
  auto shown = std::make_shared<const ExplanationContext>(std::move(explained));
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    explained_ = std::move(shown);
  }
  news_.notify_all();
}

std::shared_ptr<const ExplanationContext> Explainer::shown() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return explained_;
}

Explain::Response Explainer::explain(const Explain::Request& request,
                                     std::chrono::duration<double> patience) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(patience);
  std::vector<Literal> fluents;
  try {
    fluents = ros_common::toLiterals(request.fluents);
  } catch (const std::invalid_argument& error) {
    return unknown(error.what());
  }
  switch (request.kind) {
    case Explain::Request::WHY:
      return await(explainWhy, fluents, deadline);
    case Explain::Request::WHY_NOT:
      return await(explainWhyNot, fluents, deadline);
    case Explain::Request::WHAT_IF:
      return suppose(fluents, deadline);
    default:
      return unknown(
          fmt::format("{} is not a kind of explanation: expected WHY=0, WHY_NOT=1 or WHAT_IF=2",
                      int{request.kind}));
  }
}

Explain::Response Explainer::await(Speak speak, const std::vector<Literal>& fluents,
                                   Clock::time_point deadline) const {
  while (true) {
    const std::shared_ptr<const ExplanationContext> explained = shown();
    if (!explained) return noTask();
    // Without the lock: the solver thread must not wait for our sentences.
    Explain::Response response = speak(*explained, fluents);
    if (response.known) return response;
    std::unique_lock<std::mutex> lock(mutex_);
    if (!news_.wait_until(lock, deadline, [&] { return explained_ != explained; })) return response;
  }
}

Explain::Response Explainer::suppose(const std::vector<Literal>& fluents,
                                     Clock::time_point deadline) {
  const std::shared_ptr<const ExplanationContext> explained = shown();
  if (!explained) return noTask();
  const phrasing::Phrases& phrases = explained->phrases;
  if (fluents.empty()) return unknown(phrases.say("suppose_needs_names"));
  // The solver may be busy; what makes no sense need not wait for it.
  const WhatIfQuery supposed = supposition(fluents, explained->snapshot, explained->phrases);
  if (!explained->snapshot.candidates.empty() && !supposed.refusal.empty())
    return unknown(supposed.refusal);
  return suppositions_.ask(fluents, deadline).value_or(unknown(phrases.say("explain_unknown")));
}

}  // namespace goal_alignment::aligner
