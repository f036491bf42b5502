// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/session/session.h"

#include <utility>

#include "fluents.h"
#include "state_machine.h"
#include "what_if.h"

namespace goal_alignment::session {

Session::Session(Options options) : machine_(std::make_unique<StateMachine>(std::move(options))) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

void Session::begin(Input input) {
  machine_->begin(std::move(input));
}

State Session::step() {
  return machine_->step();
}

State Session::state() const {
  return machine_->state();
}

UnsurePolicy Session::unsurePolicy() const {
  return *machine_->options().unsure_policy;
}

const std::optional<QuestionView>& Session::question() const {
  return machine_->question();
}

const Outcome& Session::outcome() const {
  return machine_->outcome();
}

SubmitResult Session::answer(const std::vector<Literal>& fluents, AnswerKind kind,
                             const std::string& answered_by) {
  return machine_->answer(fluents, kind, answered_by, false);
}

SubmitResult Session::revise(const std::vector<Literal>& fluents, AnswerKind kind,
                             const std::string& answered_by) {
  return machine_->answer(fluents, kind, answered_by, true);
}

void Session::setRobotState(const std::vector<GroundName>& atoms) {
  machine_->setRobotState(atoms);
}

std::vector<GroundName> Session::robotState() const {
  return machine_->analysis().robotState();
}

const pddl::Model* Session::robotModel() const {
  const Analysis& analysis = machine_->analysis();
  return analysis.hasProblem() ? &analysis.problem().robot : nullptr;
}

Consequence Session::whatIf(const std::vector<Literal>& wanted,
                            const std::vector<Literal>& not_wanted, double seconds) {
  const auto then = suppose(machine_->dialogue(), wanted, not_wanted);
  if (!machine_->analysis().hasRobot()) return {};
  if (state() == State::Done) machine_->budget().cancel().reset();  // it came after the outcome
  return consequenceOf(then, machine_->analysis(), machine_->options(), seconds);
}

void Session::resume(const Options& options) {
  machine_->resume(options);
}

void Session::abort(OutcomeCode code, const std::string& reason) {
  if (state() != State::Idle) machine_->finish(code, reason);
}

void Session::answerTimedOut(const std::string& reason) {
  if (state() == State::AwaitingAnswer) machine_->finish(OutcomeCode::NoAnswer, reason);
}

void Session::cancel() noexcept {
  machine_->budget().cancel().cancel();
}

Snapshot Session::snapshot() const {
  return machine_->snapshot();
}

const std::vector<QuestionRecord>& Session::questions() const {
  return machine_->dialogue().records();
}

const Statistics& Session::statistics() const {
  return machine_->budget().statistics();
}

std::string Session::humanPlanInRobotModel() const {
  const auto& violation = humanPlanViolation();
  return violation ? violation->message : std::string();
}

const std::optional<validation::Violation>& Session::humanPlanViolation() const {
  return machine_->analysis().robotAnalysis().human_plan_violation;
}

std::string Session::spelling(const Literal& fluent) const {
  const std::string atom = spelling(fluent.atom);
  return fluent.negated ? "(not " + atom + ")" : atom;
}

std::string Session::spelling(const GroundName& action) const {
  const Analysis& analysis = machine_->analysis();
  return analysis.hasProblem() ? session::spelling(analysis.problem(), action) : action.text();
}

std::vector<std::string> Session::parameterNames(const std::string& action) const {
  const Analysis& analysis = machine_->analysis();
  if (!analysis.hasProblem()) return {};
  return session::parameterNames(analysis.problem(), action);
}

}  // namespace goal_alignment::session
