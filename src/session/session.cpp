// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/session/session.h"

#include <utility>

#include "implementation.h"

namespace goal_alignment::session {

Session::Session(Options options)
    : implementation_(std::make_unique<Implementation>(std::move(options))) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

void Session::begin(Input input) {
  implementation_->begin(std::move(input));
}

State Session::step() {
  return implementation_->step();
}

State Session::state() const {
  return implementation_->state();
}

UnsurePolicy Session::unsurePolicy() const {
  return implementation_->unsurePolicy();
}

const std::optional<QuestionView>& Session::question() const {
  return implementation_->question();
}

const Outcome& Session::outcome() const {
  return implementation_->outcome();
}

SubmitResult Session::answer(const std::vector<Literal>& fluents, AnswerKind kind,
                             const std::string& answered_by) {
  return implementation_->answer(fluents, kind, answered_by, false);
}

SubmitResult Session::revise(const std::vector<Literal>& fluents, AnswerKind kind,
                             const std::string& answered_by) {
  return implementation_->answer(fluents, kind, answered_by, true);
}

void Session::setRobotState(const std::vector<GroundName>& atoms) {
  implementation_->setRobotState(atoms);
}

std::vector<GroundName> Session::robotState() const {
  return implementation_->robotState();
}

const pddl::Model* Session::robotModel() const {
  return implementation_->robotModel();
}

Consequence Session::whatIf(const std::vector<Literal>& wanted,
                            const std::vector<Literal>& not_wanted, double seconds) {
  return implementation_->whatIf(wanted, not_wanted, seconds);
}

void Session::resume(const Options& options) {
  implementation_->resume(options);
}

void Session::abort(OutcomeCode code, const std::string& reason) {
  if (state() != State::Idle) implementation_->finish(code, reason);
}

void Session::answerTimedOut(const std::string& reason) {
  if (state() == State::AwaitingAnswer) implementation_->finish(OutcomeCode::NoAnswer, reason);
}

void Session::cancel() noexcept {
  implementation_->cancelToken().cancel();
}

Snapshot Session::snapshot() const {
  return implementation_->snapshot();
}

const std::vector<QuestionRecord>& Session::questions() const {
  return implementation_->dialogue().records();
}

const Statistics& Session::statistics() const {
  return implementation_->statistics();
}

std::string Session::humanPlanInRobotModel() const {
  const auto& violation = humanPlanViolation();
  return violation ? violation->message : std::string();
}

const std::optional<validation::Violation>& Session::humanPlanViolation() const {
  return implementation_->humanPlanViolation();
}

std::string Session::spelling(const Literal& fluent) const {
  const std::string atom = implementation_->spelling(fluent.atom);
  return fluent.negated ? "(not " + atom + ")" : atom;
}

std::string Session::spelling(const GroundName& action) const {
  return implementation_->spelling(action);
}

std::vector<std::string> Session::parameterNames(const std::string& action) const {
  return implementation_->parameterNames(action);
}

}  // namespace goal_alignment::session
