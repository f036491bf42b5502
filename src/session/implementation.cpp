// SPDX-License-Identifier: BSD-3-Clause
#include "implementation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "goal_alignment/common/exceptions.h"
#include "human_state.h"

namespace goal_alignment::session {

using achievability::Check;
using achievability::Conflict;
using achievability::Verdict;

namespace {

/// How many states one search for a belief may generate. A belief only orders questions, so where
/// it is not cheap its bound from π^H will do; Algorithm 1 asks for the optimal cost.
constexpr std::uint64_t kBeliefStates = 2'000;
constexpr std::uint64_t kPaperBeliefStates = 100'000;

/// Searches for beliefs, which have bounds to fall back on, take at most this share of the time
/// limit.
constexpr double kShareOfBeliefs = 0.1;

/// This share of the time limit is not spent on finding all conflicts.
constexpr double kShareOfDialogue = 0.75;

/// A dialogue that does not wait for all conflicts does not wait long for proofs, either.
constexpr std::uint64_t kLazySteps = 5'000'000;

void requireRange(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument(what);
}

void validate(const Options& options) {
  requireRange(options.belief.beta >= 0 && std::isfinite(options.belief.beta),
               "beta must be a number and not negative");
  requireRange(options.belief.kappa > 0 && std::isfinite(options.belief.kappa),
               "kappa must be a positive number");
  requireRange(options.belief.flat >= 0 && options.belief.flat <= 1,
               "a flat belief must lie between 0 and 1");
  requireRange(options.time_limit > 0, "the time limit must be positive");
  requireRange(options.memory_limit > 0, "the memory limit must be positive");
  requireRange(options.threads >= 1, "the number of threads must be 1 or more");
  requireRange(options.max_questions >= -1, "the question limit must be -1 (none) or more");
  requireRange(options.max_group_size >= 1, "a question must offer 1 fluent or more");
  requireRange(options.max_extra_cost >= 0, "the extra cost let pass must not be negative");
  questions::makePolicy(options.policy, {});  // throws for an unknown name
}

/// Outcomes after which the same dialogue can go on. Models that are invalid may have been made so
/// from outside; those that are not fail once more.
bool leavesOpen(OutcomeCode code) {
  switch (code) {
    case OutcomeCode::Canceled:
    case OutcomeCode::TimeLimit:
    case OutcomeCode::MemoryLimit:
    case OutcomeCode::BudgetLimit:
    case OutcomeCode::NoAnswer:
    case OutcomeCode::Declined:
    case OutcomeCode::QuestionLimit:
    case OutcomeCode::UnsureBlocks:
    case OutcomeCode::InvalidModel:
    case OutcomeCode::StateUnknown:
      return true;
    default:
      return false;
  }
}

}  // namespace

Session::Implementation::Implementation(Options options) : options_(std::move(options)) {
  validate(options_);
  if (!options_.unsure_policy) options_.unsure_policy = UnsurePolicy::AsYes;
}

void Session::Implementation::begin(Input input) {
  input_ = std::move(input);
  robot_analysis_ = {};
  policy_.reset();
  problem_.reset();
  beliefs_.clear();
  dialogue_ = {};
  question_.reset();
  outcome_ = {};
  statistics_ = {};
  earlier_robot_calls_ = 0;
  belief_calls_ = 0;
  budget_from_ = 0;
  asked_before_ = 0;
  conflicts_ended_.clear();
  ends_unsure_ = false;
  phase_ = Phase::Read;
  state_ = State::Analysing;
}

/// What is left of the limits but for so many seconds, which are kept for what comes later.
Limits Session::Implementation::limits(double seconds_kept) const {
  Limits result;
  result.bytes = accountable(options_.memory_limit);
  result.cancel = &cancel_;
  if (options_.time_limit < std::numeric_limits<double>::infinity()) {
    const std::chrono::duration<double> running = Limits::Clock::now() - step_began_;
    result = result.withSeconds(options_.time_limit - seconds_kept -
                                (statistics_.total - budget_from_) - running.count());
  }
  return result;
}

/// For the check of a plan once it is found: it must not be lost where the search for a better one
/// has used up the time.
Limits Session::Implementation::cancelOnly() const {
  Limits result;
  result.cancel = &cancel_;
  return result;
}

double& Session::Implementation::stopwatch(Phase phase) {
  switch (phase) {
    case Phase::Read:
      return statistics_.parse;
    case Phase::Ground:
      return statistics_.ground;
    case Phase::Believe:
      return statistics_.belief;
    case Phase::Check:
    case Phase::FindConflicts:
      return statistics_.conflicts;
    case Phase::Decide:
      return statistics_.questions;
  }
  return statistics_.questions;
}

State Session::Implementation::step() {
  if (state_ != State::Analysing && !(state_ == State::AwaitingAnswer && cancel_.cancelled())) {
    return state_;
  }
  step_began_ = Limits::Clock::now();
  const Phase phase = phase_;
  const double planning_before = statistics_.plan;
  try {
    if (cancel_.cancelled()) throw LimitReached(LimitReason::Cancelled, "the alignment");
    if (statistics_.total - budget_from_ >= options_.time_limit)
      throw LimitReached(LimitReason::Time, "thinking");
    run(phase);
  } catch (const std::exception& exception) {
    finish(outcomeOf(exception));
  }
  const std::chrono::duration<double> took = Limits::Clock::now() - step_began_;
  stopwatch(phase) += took.count() - (statistics_.plan - planning_before);
  statistics_.total += took.count();
  statistics_.planner_calls = belief_calls_ + earlier_robot_calls_ +
                              (robot_analysis_.achievability ? robot().plannerCalls() : 0);
  return state_;
}

void Session::Implementation::run(Phase phase) {
  switch (phase) {
    case Phase::Read:
      return read();
    case Phase::Ground:
      return ground();
    case Phase::Check:
      return checkWhole();
    case Phase::Believe:
      return believe();
    case Phase::FindConflicts:
      return findConflicts();
    case Phase::Decide:
      return decide();
  }
}

void Session::Implementation::read() {
  pddl::Model robot = pddl::readModel(input_.robot_domain, input_.robot_problem, limits());
  pddl::Model human = pddl::readModel(input_.human_domain, input_.human_problem, limits());
  takeUp(input_.human_facts, input_.human_plan, robot, human, limits());
  unit_costs_ = !(options_.costs && robot.has_costs && human.has_costs);
  problem_ = std::make_unique<alignment::Problem>(alignment::makeProblem(
      std::move(robot), std::move(human), input_.goal, input_.human_plan, limits()));
  input_ = {};
  if (options_.negative_candidates) alignment::addNegativeCandidates(*problem_, limits());
  beginDialogue();
  phase_ = Phase::Ground;
}

void Session::Implementation::beginDialogue() {
  dialogue_ = Dialogue(*problem_);
  for (const std::string& predicate : options_.hidden_wanted)
    dialogue_.assume(predicate, questions::Knowledge::Unsure);
  for (const std::string& predicate : options_.hidden_not_wanted)
    dialogue_.assume(predicate, questions::Knowledge::NotWanted);
}

void Session::Implementation::ground() {
  achievability::SearchBudget budget;
  budget.threads = options_.threads;
  if (options_.conflicts == ConflictMode::Lazy) budget.symbolic = kLazySteps;
  robot_analysis_ = alignment::analyseRobot(*problem_, unit_costs_, budget, limits());
  policy_ = questions::makePolicy(options_.policy, policyContext());
  conflicts_ended_.clear();
  phase_ = Phase::Check;
}

void Session::Implementation::checkWhole() {
  const achievability::CandidateSet none(robot().candidateCount());
  const Check whole = robot().check(~none, limits());
  if (whole.verdict == Verdict::Achievable) {
    // It may cost more than the person would let pass for what nobody asked for.
    if (costsMatter())
      phase_ = Phase::Believe;
    else
      conclude(~none, whole.plan);
    return;
  }
  if (whole.limit == LimitReason::Time || whole.limit == LimitReason::Cancelled)
    throw LimitReached(whole.limit, "the search for a plan");
  const Check specified = robot().check(none, limits());
  if (specified.verdict == Verdict::Unachievable) {
    Outcome outcome;
    outcome.code = OutcomeCode::GoalUnsolvable;
    outcome.message = "no plan can achieve what was asked for: " + askedFor();
    blame(outcome, *robot().provenConflictWithin(none));
    finish(std::move(outcome));
  } else if (specified.verdict == Verdict::Unknown) {
    finish(outcomeOf(specified.limit),
           "the limits did not suffice to find out whether the specified goal can be achieved");
  } else {
    if (whole.verdict == Verdict::Unknown) robot().suspect(~none);
    phase_ = Phase::Believe;
  }
}

void Session::Implementation::believe() {
  if (beliefs_.empty()) {
    std::vector<double> differences(robot().candidateCount(), 0);
    if (options_.belief.mode != alignment::BeliefMode::Flat) {
      alignment::CostOptions cheap{true, kBeliefStates, true};
      cheap.search_seconds = kShareOfBeliefs * options_.time_limit;
      differences = costDifferences(cheap);
    }
    beliefs_ = alignment::beliefs(*problem_, differences, options_.belief);
  }
  const bool full = options_.conflicts == ConflictMode::Full;
  phase_ = policy_->usesConflicts() && full ? Phase::FindConflicts : Phase::Decide;
}

std::vector<double> Session::Implementation::costDifferences(alignment::CostOptions options) {
  options.unit_costs = unit_costs_;
  options.threads = options_.threads;
  alignment::CostDifferences differences = alignment::costDifferences(*problem_, options, limits());
  belief_calls_ += differences.planner_calls;
  return std::move(differences.values);
}

/// Where a limit ends this, the dialogue goes on inside the conflicts known.
void Session::Implementation::findConflicts() {
  phase_ = Phase::Decide;
  // What was given up since they were sought first may have made them needless.
  if (knownPlanFor(~dialogue_.with(questions::Knowledge::NotWanted)) != nullptr) return;
  const Limits own = limits(kShareOfDialogue * options_.time_limit);
  if (robot().findAllConflicts(own) || own.interruption() == LimitReason::Cancelled) return;
  const auto& known = robot().conflicts();
  const auto proven = std::count_if(known.begin(), known.end(),
                                    [](const Conflict& conflict) { return conflict.proven; });
  const auto suspected = static_cast<std::ptrdiff_t>(known.size()) - proven;
  conflicts_ended_ = std::string("finding all conflicts stopped: ") +
                     toString(robot().lastLimit()) + " (" + std::to_string(proven) + " proven, " +
                     std::to_string(suspected) + " suspected)";
}

questions::PolicyContext Session::Implementation::policyContext() {
  questions::PolicyContext setting;
  for (const alignment::Candidate& candidate : problem_->candidates) {
    setting.is_static.push_back(candidate.is_static);
  }
  setting.ask_static = options_.static_candidates;
  setting.seed = options_.seed;
  setting.paper_beliefs = [this] {
    return alignment::paperBeliefs(costDifferences({true, kPaperBeliefStates}),
                                   options_.belief.beta);
  };
  setting.unachievable_alone = [this] { return unachievableAlone(); };
  // The deadline is looked at after each decision, so that a seed replays.
  setting.poll = [this] {
    if (cancel_.cancelled()) throw LimitReached(LimitReason::Cancelled, "choosing a question");
  };
  return setting;
}

std::vector<bool> Session::Implementation::unachievableAlone() {
  std::vector<bool> result;
  for (const Verdict verdict : robot().reachableAlone(limits())) {
    if (verdict == Verdict::Unknown)
      throw LimitReached(robot().lastLimit(), "a check of Algorithm 1");
    result.push_back(verdict == Verdict::Unachievable);
  }
  return result;
}

SubmitResult Session::Implementation::answer(const std::vector<Literal>& fluents, AnswerKind kind,
                                             const std::string& answered_by, bool revising) {
  if (!problem_) return {false, "the models are not read yet; there is no question"};
  step_began_ = Limits::Clock::now();  // what there could be instead may have to be thought about
  if (kind == AnswerKind::Decline) {
    if (state_ == State::Done) return {false, "the dialogue is over; there is nothing to decline"};
    dialogue_.decline();
    finish(OutcomeCode::Declined, answered_by + " declined to answer");
    return {true, ""};
  }
  SubmitResult receipt = dialogue_.answer(fluents, kind, answered_by, revising);
  if (!receipt.accepted) return receipt;
  if (kind == AnswerKind::Unsure && options_.unsure_policy == UnsurePolicy::Abort) {
    ends_unsure_ = true;
    if (!beliefs_.empty()) {
      concludeUnsure();
      return receipt;
    }
  }
  // Another fluent was volunteered, or only a part of a group was answered.
  const bool unanswered = state_ == State::AwaitingAnswer && dialogue_.isOpen();
  if (unanswered && !revising && openQuestionMatters()) {
    question_ = openQuestion();
    return receipt;
  }
  dialogue_.withdraw();
  question_.reset();
  if (state_ != State::Analysing) resume(nextPhase());
  return receipt;
}

void Session::Implementation::setRobotState(const std::vector<GroundName>& atoms) {
  if (!problem_) throw std::logic_error("there is no task yet whose robot could have a state");
  std::vector<pddl::Atom> init;
  for (const GroundName& name : atoms) {
    std::string why_not;
    auto atom = problem_->robot.resolve(name, &why_not);
    if (!atom) {
      throw pddl::SemanticError(problem_->robot.problem_source, {},
                                "the robot's model can't have " + name.text() + ": " + why_not);
    }
    init.push_back(std::move(*atom));
  }
  problem_->robot.init = std::move(init);
  if (robot_analysis_.achievability) earlier_robot_calls_ += robot().plannerCalls();
  robot_analysis_ = {};
  dialogue_.withdraw();
  question_.reset();
  resume(Phase::Ground);
}

std::vector<GroundName> Session::Implementation::robotState() const {
  std::vector<GroundName> atoms;
  if (!problem_) return atoms;
  atoms.reserve(problem_->robot.init.size());
  for (const pddl::Atom& atom : problem_->robot.init)
    atoms.push_back(problem_->robot.name(atom));
  return atoms;
}

void Session::Implementation::resume(const Options& options) {
  validate(options);
  options_.time_limit = options.time_limit;
  options_.memory_limit = options.memory_limit;
  options_.max_questions = options.max_questions;
  if (options.unsure_policy) options_.unsure_policy = options.unsure_policy;
  options_.max_group_size = options.max_group_size;
  asked_before_ = dialogue_.asked();
  dialogue_.countAnew();
  if (state_ != State::Done || !leavesOpen(outcome_.code)) return;
  resume(nextPhase());
}

/// What is still to be done after an interruption or a new answer.
Session::Implementation::Phase Session::Implementation::nextPhase() const {
  if (!problem_) return Phase::Read;
  if (!robot_analysis_.achievability) return Phase::Ground;
  if (beliefs_.empty()) return phase_ == Phase::Believe ? Phase::Believe : Phase::Check;
  return phase_ == Phase::FindConflicts ? Phase::FindConflicts : Phase::Decide;
}

/// Goes on thinking; after an outcome with a new allowance of time.
void Session::Implementation::resume(Phase phase) {
  if (state_ == State::Done) {
    budget_from_ = statistics_.total;
    cancel_.reset();  // one that came after the outcome had nothing left to end
  }
  outcome_ = {};
  phase_ = phase;
  state_ = State::Analysing;
}

void Session::Implementation::finish(OutcomeCode code, std::string message) {
  Outcome outcome;
  outcome.code = code;
  outcome.message = std::move(message);
  finish(std::move(outcome));
}

void Session::Implementation::finish(Outcome outcome) {
  // A cancel is used up by the outcome it brings about: the session can go on after it.
  if (outcome.code == OutcomeCode::Canceled) cancel_.reset();
  if (outcome.code == OutcomeCode::BudgetLimit) outcome.message += "; more time would not help";
  if (outcome.alternatives.empty()) outcome.alternatives = alternativesAfter(outcome.code);
  outcome_ = std::move(outcome);
  if (!conflicts_ended_.empty()) {
    if (!outcome_.message.empty() && outcome_.message.back() == '.') outcome_.message.pop_back();
    outcome_.message += "; " + conflicts_ended_;
  }
  ends_unsure_ = false;
  dialogue_.withdraw();
  question_.reset();
  state_ = State::Done;
}

}  // namespace goal_alignment::session
