// SPDX-License-Identifier: BSD-3-Clause
#include "state_machine.h"

#include <exception>
#include <utility>

#include "alternatives.h"
#include "conclusion.h"
#include "final_plan.h"
#include "fluents.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/common/stopwatch.h"
#include "open_question.h"
#include "option_ranges.h"
#include "views.h"

namespace goal_alignment::session {

using questions::Knowledge;

namespace {

/// Progress is by phase: nobody knows beforehand how long a search takes.
constexpr float kPhases = 6;

Options inRange(Options options) {
  requireInRange(options);
  if (!options.unsure_policy) options.unsure_policy = UnsurePolicy::AsYes;
  return options;
}

Dialogue dialogueAbout(const alignment::Problem& problem, const Options& options) {
  Dialogue dialogue(problem);
  for (const std::string& predicate : options.assumed_wanted_predicates)
    dialogue.assume(predicate, Knowledge::Unsure);
  for (const std::string& predicate : options.assumed_unwanted_predicates)
    dialogue.assume(predicate, Knowledge::NotWanted);
  return dialogue;
}

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace

Session::StateMachine::StateMachine(Options options)
    : options_(inRange(std::move(options))),
      budget_(options_.time_limit, options_.memory_limit),
      analysis_(std::make_unique<Analysis>(options_, budget_)) {}

void Session::StateMachine::begin(Input input) {
  input_ = std::move(input);
  budget_.reset();
  analysis_ = std::make_unique<Analysis>(options_, budget_);
  dialogue_ = {};
  question_.reset();
  outcome_ = {};
  asked_before_ = 0;
  ends_unsure_ = false;
  phase_ = Phase::Read;
  state_ = State::Analysing;
}

State Session::StateMachine::step() {
  const bool is_cancelled = budget_.cancel().cancelled();
  if (state_ != State::Analysing && !(state_ == State::AwaitingAnswer && is_cancelled))
    return state_;
  budget_.start();
  const Phase phase = phase_;
  try {
    if (budget_.cancel().cancelled()) throw LimitReached(LimitReason::Cancelled, "the alignment");
    if (budget_.isUsedUp()) throw LimitReached(LimitReason::Time, "thinking");
    run(phase);
  } catch (const std::exception& exception) {
    finish(outcomeOf(exception));
  }
  budget_.stop(timeOf(phase), analysis_->plannerCalls());
  return state_;
}

void Session::StateMachine::run(Phase phase) {
  switch (phase) {
    case Phase::Read:
      read();
      phase_ = Phase::Ground;
      return;
    case Phase::Ground:
      analysis_->analyseRobot();
      phase_ = Phase::Check;
      return;
    case Phase::Check:
      if (const auto decision = decideWithoutAnswers(*analysis_, options_)) return apply(*decision);
      phase_ = Phase::Believe;
      return;
    case Phase::Believe: {
      analysis_->believe();
      const bool full = options_.conflicts == ConflictMode::Full;
      const bool finds_all = analysis_->policy().usesConflicts() && full;
      phase_ = finds_all ? Phase::FindConflicts : Phase::Decide;
      return;
    }
    case Phase::FindConflicts:
      phase_ = Phase::Decide;  // also where this is cut short
      return analysis_->findConflicts(~dialogue_.with(Knowledge::NotWanted));
    case Phase::Decide:
      return decide();
  }
}

double Statistics::*Session::StateMachine::timeOf(Phase phase) {
  switch (phase) {
    case Phase::Read:
      return &Statistics::parse;
    case Phase::Ground:
      return &Statistics::ground;
    case Phase::Believe:
      return &Statistics::belief;
    case Phase::Check:
    case Phase::FindConflicts:
      return &Statistics::conflicts;
    case Phase::Decide:
      break;
  }
  return &Statistics::questions;
}

void Session::StateMachine::read() {
  analysis_->read(input_);
  input_ = {};
  dialogue_ = dialogueAbout(analysis_->problem(), options_);
}

void Session::StateMachine::decide() {
  Decision decision = session::decide(dialogue_, *analysis_, options_, ends_unsure_);
  while (const auto* reopen = std::get_if<Reopen>(&decision)) {
    dialogue_.reopen(reopen->candidates);
    decision = reopen->then_ask ? nextQuestion(dialogue_, *analysis_, options_)
                                : session::decide(dialogue_, *analysis_, options_, ends_unsure_);
  }
  apply(decision);
}

void Session::StateMachine::apply(const Decision& decision) {
  const auto finish_with = [this](const auto& ending) {
    finish(outcomeOf(ending, analysis_->problem()));
  };
  std::visit(Overloaded{
                 [this](const Ask& question) { ask(question); },
                 [this](const PlanFor& found) { conclude(found); },
                 [this](const NoPlan& proof) { conclude(proof); },
                 [&](const GoalUnsolvable& proof) { finish_with(proof); },
                 [&](const Blocked& blocked) { finish_with(blocked); },
                 [&](const Exhausted& exhausted) { finish_with(exhausted); },
                 [](const Reopen&) {},  // decide() has done that
             },
             decision);
}

void Session::StateMachine::ask(const Ask& question) {
  std::vector<std::size_t> candidates;
  for (const Dialogue::AskedCandidate& posed : question.posed)
    candidates.push_back(posed.candidate);
  const std::size_t asked = dialogue_.askedWith(candidates);
  if (options_.max_questions >= 0 &&
      asked > asked_before_ + static_cast<std::size_t>(options_.max_questions)) {
    return finish(OutcomeCode::QuestionLimit,
                  "the limit of questions is reached, and the outcome still depends on " +
                      listed(analysis_->problem(), {dialogue_.fluents()[candidates.front()]}));
  }
  dialogue_.ask(question.posed);
  question_ = openQuestion(dialogue_, *analysis_, options_);
  state_ = State::AwaitingAnswer;
}

void Session::StateMachine::conclude(const PlanFor& decision) {
  const Stopwatch watch;
  FinalPlan plan =
      makeFinalPlan(decision.achieved, decision.plan, dialogue_, *analysis_, options_.plan);
  finish(outcomeOf(std::move(plan), analysis_->problem()));
  budget_.addPlanTime(watch.seconds());
}

void Session::StateMachine::conclude(const NoPlan& decision) {
  // The way to the alternatives may bring to light that less than the conflict is one.
  auto alternatives =
      alternativesAfter(OutcomeCode::ExpectationUnachievable, dialogue_, *analysis_, options_);
  const achievability::Conflict* conflict =
      analysis_->robot().smallConflictWithin(decision.conflict, budget_.limits());
  finish(expectationUnachievable(*conflict, std::move(alternatives), analysis_->problem()));
}

SubmitResult Session::StateMachine::answer(const std::vector<Literal>& fluents, AnswerKind kind,
                                           const std::string& answered_by, bool revising) {
  if (!analysis_->hasProblem()) return {false, "the models are not read yet; there is no question"};
  budget_.start();  // what there could be instead may have to be thought about
  if (kind == AnswerKind::Decline) {
    if (state_ == State::Done) return {false, "the dialogue is over; there is nothing to decline"};
    dialogue_.decline();
    finish(OutcomeCode::Declined, answered_by + " declined to answer");
    return {true, ""};
  }
  SubmitResult result = dialogue_.answer(fluents, kind, answered_by, revising);
  if (!result.accepted) return result;
  if (kind == AnswerKind::Unsure && options_.unsure_policy == UnsurePolicy::Abort) {
    ends_unsure_ = true;
    if (analysis_->hasRobot() && !analysis_->beliefs().empty()) {
      finish(outcomeOf(blockedAtOnce(dialogue_, *analysis_), analysis_->problem()));
      return result;
    }
  }
  // Another fluent was volunteered, or only a part of a group was answered.
  const bool is_waiting = state_ == State::AwaitingAnswer && dialogue_.isOpen();
  if (is_waiting && !revising && stillMatters(*question_, dialogue_, *analysis_)) {
    question_ = openQuestion(dialogue_, *analysis_, options_);
    return result;
  }
  dialogue_.withdraw();
  question_.reset();
  if (state_ != State::Analysing) resumeAt(nextPhase());
  return result;
}

void Session::StateMachine::setRobotState(const std::vector<GroundName>& atoms) {
  analysis_->setRobotState(atoms);
  dialogue_.withdraw();
  question_.reset();
  resumeAt(Phase::Ground);
}

void Session::StateMachine::resume(const Options& options) {
  requireInRange(options);
  options_.time_limit = options.time_limit;
  options_.memory_limit = options.memory_limit;
  options_.max_questions = options.max_questions;
  if (options.unsure_policy) options_.unsure_policy = options.unsure_policy;
  options_.max_group_size = options.max_group_size;
  budget_.setLimits(options.time_limit, options.memory_limit);
  asked_before_ = dialogue_.asked();
  dialogue_.countAnew();
  if (state_ == State::Done && outcomeTraits(outcome_.code).resumable) resumeAt(nextPhase());
}

/// What is still to be done after an interruption or a new answer.
Session::StateMachine::Phase Session::StateMachine::nextPhase() const {
  if (!analysis_->hasProblem()) return Phase::Read;
  if (!analysis_->hasRobot()) return Phase::Ground;
  if (analysis_->beliefs().empty()) return phase_ == Phase::Believe ? Phase::Believe : Phase::Check;
  return phase_ == Phase::FindConflicts ? Phase::FindConflicts : Phase::Decide;
}

/// After an outcome with a new allowance of time.
void Session::StateMachine::resumeAt(Phase phase) {
  if (state_ == State::Done) budget_.renew();
  outcome_ = {};
  phase_ = phase;
  state_ = State::Analysing;
}

void Session::StateMachine::finish(OutcomeCode code, std::string message) {
  Outcome outcome;
  outcome.code = code;
  outcome.message = std::move(message);
  finish(std::move(outcome));
}

void Session::StateMachine::finish(Outcome outcome) {
  // A cancel is used up by the outcome it brings about: the session can be resumed after it.
  if (outcome.code == OutcomeCode::Canceled) budget_.cancel().reset();
  if (outcome.code == OutcomeCode::BudgetLimit) outcome.message += "; more time would not help";
  if (outcome.alternatives.empty())
    outcome.alternatives = alternativesAfter(outcome.code, dialogue_, *analysis_, options_);
  outcome_ = std::move(outcome);
  if (const std::string& why = analysis_->conflictsEnded(); !why.empty()) {
    if (!outcome_.message.empty() && outcome_.message.back() == '.') outcome_.message.pop_back();
    outcome_.message += "; " + why;
  }
  ends_unsure_ = false;
  dialogue_.withdraw();
  question_.reset();
  state_ = State::Done;
}

Snapshot Session::StateMachine::snapshot() const {
  Stage stage;
  stage.state = state_;
  stage.progress = state_ == State::Done ? 1 : static_cast<float>(phase_) / kPhases;
  stage.is_deciding = state_ == State::Analysing && phase_ == Phase::Decide;
  return snapshotOf(stage, dialogue_, *analysis_, question_);
}

}  // namespace goal_alignment::session
