// SPDX-License-Identifier: BSD-3-Clause
#include "alignment_runner.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <algorithm>
#include <boost/uuid/random_generator.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <exception>
#include <utility>
#include <vector>

#include "align_goal_reader.h"
#include "goal_alignment/aligner/phrases_file.h"
#include "goal_alignment/ros_common/stamp.h"
#include "outcome_text.h"

namespace goal_alignment::aligner {
namespace {

using session::AnswerKind;
using session::OutcomeCode;

// Two fields of a goal that can't both be meant.
class ContradictionError : public GoalError {
 public:
  using GoalError::GoalError;
};

// The dialogue has come to its end, so there is nothing to take up again, also after a crash.
bool isDecided(OutcomeCode code) {
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
    case OutcomeCode::Internal:
      return false;
    default:
      return true;
  }
}

session::Outcome invalidInput(const std::exception& error) {
  session::Outcome outcome;
  outcome.code = OutcomeCode::InvalidModel;
  outcome.message = error.what();
  return outcome;
}

}  // namespace

AlignmentRunner::AlignmentRunner(ros::NodeHandle private_node, const Parts& parts)
    : private_node_(std::move(private_node)),
      announcer_(parts.announcer),
      bridge_(parts.bridge),
      ask_human_(parts.ask_human),
      journal_(parts.journal),
      facts_(parts.facts),
      under_way_(parts.under_way),
      tf_(parts.tf),
      explainer_(parts.explainer),
      plan_watch_(parts.plan_watch) {}

bool AlignmentRunner::stop(GoalTicket& ticket) {
  {
    const std::lock_guard<std::mutex> lock(running_mutex_);
    if (!ticket.claim()) return false;
    if (running_ == &ticket) kept_.session->cancel();
  }
  bridge_.interrupt();
  return true;
}

void AlignmentRunner::run(GoalTicket& ticket) {
  try {
    prepare(ticket.goal());
  } catch (const ContradictionError& error) {
    session::Outcome outcome = invalidInput(error);
    outcome.code = OutcomeCode::Contradiction;
    return refuse(ticket, outcome);
  } catch (const GoalError& error) {
    return refuse(ticket, invalidInput(error));
  } catch (const ros_common::ParameterError& error) {
    return refuse(ticket, invalidInput(error));
  } catch (const spatial_facts::RulesError& error) {
    return refuse(ticket, invalidInput(error));
  } catch (const std::exception& error) {
    return refuse(ticket, session::outcomeOf(error));
  }
  {
    const std::lock_guard<std::mutex> lock(running_mutex_);
    running_ = &ticket;
  }
  try {
    ticket.accept();
    if (kept_.options.journal_expiry > 0) under_way_.begin({kept_.id, kept_.task_id, kept_.person});
    announcer_.tell(storyOf(ticket.goal()));
    loop(ticket);
    conclude(ticket);
  } catch (const std::exception& error) {
    abort(ticket, error);
  }
  under_way_.end();
  const std::lock_guard<std::mutex> lock(running_mutex_);
  running_ = nullptr;
}

// The session makes outcomes of all its errors, so this one is ours.
void AlignmentRunner::abort(GoalTicket& ticket, const std::exception& error) {
  ROS_ERROR("the alignment broke off: %s", error.what());
  closeQuestion();
  bridge_.endSession();
  refuse(ticket, session::outcomeOf(error));
}

void AlignmentRunner::prepare(const AlignGoal& goal) {
  const NodeOptions options = NodeOptions::read(private_node_);
  warnAboutUnknown(options);
  const auto rules = rulesOf(options.tf_facts);
  if (goal.continue_session.empty()) {
    begin(goal, options);
  } else {
    if (rules && kept_.models_known) rules->check(*kept_.session->robotModel());
    continueSession(goal, options);
  }
  kept_.options = options;
  tf_.follow(rules);
  kept_.facts_known = false;
  kept_.unknown_since.reset();
}

void AlignmentRunner::begin(const AlignGoal& goal, const NodeOptions& options) {
  if (!goal.revised_wanted.empty() || !goal.revised_not_wanted.empty()) {
    throw GoalError("revised_wanted and revised_not_wanted need continue_session");
  }
  auto session = std::make_shared<session::Session>(optionsOf(goal, options));
  session::Input input = inputOf(goal, options);
  const std::string key = journalKey(input, goal.task.person, private_node_.getNamespace());
  if (goal.source == AlignGoal::PARAMS) inheritFacts(options, input);
  Kept kept;
  kept.human_plan = input.human_plan;
  session->begin(std::move(input));
  kept.id = boost::uuids::to_string(boost::uuids::random_generator()());
  kept.person = goal.task.person;
  kept.task_id = goal.task.task_id;
  kept.identity = identityOf(goal);
  try {
    kept.phrases = phrasesOf(options.phrases);
    if (!kept.phrases.warning().empty()) ROS_WARN("%s", kept.phrases.warning().c_str());
  } catch (const std::exception& error) {
    // Wording is no reason to refuse a task.
    announcer_.warn(fmt::format("no phrases: {}", error.what()));
  }
  kept.session = std::move(session);
  kept.journaled = journal_.open(key, kept.id, options.journal_expiry);
  kept_ = std::move(kept);
  facts_.beginSession(kept_.id, goal.source == AlignGoal::PARAMS);
  bridge_.beginSession(kept_.id);
}

void AlignmentRunner::continueSession(const AlignGoal& goal, const NodeOptions& options) {
  const session::Options session_options = optionsOf(goal, options);
  if (!kept_.session || goal.continue_session != kept_.id) {
    throw GoalError(fmt::format("continue_session: there is no session '{:.60}' to go on with",
                                goal.continue_session));
  }
  const auto wanted = candidatesOf(goal.revised_wanted, "revised_wanted");
  const auto not_wanted = candidatesOf(goal.revised_not_wanted, "revised_not_wanted");
  for (const Literal& fluent : wanted) {
    if (std::find(not_wanted.begin(), not_wanted.end(), fluent) == not_wanted.end()) continue;
    throw ContradictionError(fluent.text() + " is in revised_wanted and in revised_not_wanted");
  }
  const auto& statistics = kept_.session->statistics();
  kept_.thinking_before = statistics.total;
  kept_.calls_before = statistics.planner_calls;
  kept_.questions_before = kept_.session->snapshot().questions_asked;
  kept_.waiting_time = 0;
  kept_.session->resume(session_options);
  bridge_.beginSession(kept_.id);
  bridge_.update(kept_.session->snapshot());
  if (!wanted.empty())
    apply({wanted, AnswerKind::Yes, goal.task.person, 0, ros_common::stampNow()});
  if (!not_wanted.empty())
    apply({not_wanted, AnswerKind::No, goal.task.person, 0, ros_common::stampNow()});
}

void AlignmentRunner::warnAboutUnknown(const NodeOptions& options) {
  for (const std::string& key : options.unknown) {
    if (!warned_about_.insert(key).second) continue;
    ROS_WARN("nobody reads the parameter %s", private_node_.resolveName(key).c_str());
  }
}

void AlignmentRunner::loop(GoalTicket& ticket) {
  report(ticket, kept_.session->snapshot(), "");
  while (!ticket.ended()) {
    applyAnswers();
    takeUpFacts();
    if (factsAreAwaited()) {
      awaitFacts(ticket);
      continue;
    }
    if (kept_.session->state() == State::Done && hasEnded()) break;
    // Where the session was taken up again since the cancel, it has forgotten that one.
    if (ticket.ended()) break;
    const session::Snapshot now = step();
    if (now.state == State::Done) continue;  // what was said or seen meanwhile still counts
    if (now.state == State::AwaitingAnswer) {
      waitForAnswer(ticket, now);
      // One at a time: an answer or a cancel may have come meanwhile.
      if (kept_.session->state() == State::AwaitingAnswer) answerSupposition();
      if (isAskedToSuppose()) bridge_.wakeUp();
    } else {
      report(ticket, now, "");
    }
  }
  closeQuestion();
  bridge_.endSession();
  // Who gave them was told that they count: the journal and the session's next goal have them.
  if (ticket.ended()) applyAnswers();
}

session::Snapshot AlignmentRunner::step() {
  const auto began = Clock::now();
  const State state = kept_.session->step();
  const std::chrono::duration<double> took = Clock::now() - began;
  ROS_DEBUG("a step of %.3f s led to phase %d", took.count(), int{ros_common::phaseOf(state)});
  if (!kept_.models_known && kept_.session->robotModel() != nullptr) onModelsLoaded();
  session::Snapshot now = kept_.session->snapshot();
  bridge_.update(now);
  showToExplainer(now);
  return now;
}

// Once, as soon as the models are read.
void AlignmentRunner::onModelsLoaded() {
  kept_.models_known = true;
  facts_.setModel(*kept_.session->robotModel());
  checkRules();
  takeUpJournal();
  const session::Snapshot now = kept_.session->snapshot();
  for (const auto* hidden :
       {&kept_.options.session.hidden_wanted, &kept_.options.session.hidden_not_wanted}) {
    for (const std::string& name : *hidden)
      warnIfNobodyIs(name, now);
  }
}

// Its name may be a slip.
void AlignmentRunner::warnIfNobodyIs(const std::string& hidden, const session::Snapshot& now) {
  const bool known = std::any_of(
      now.candidates.begin(), now.candidates.end(),
      [&](const session::CandidateView& view) { return view.fluent.atom.name == hidden; });
  if (known) return;
  announcer_.warn(kept_.phrases.say("event_hidden_unknown", {hidden}));
}

// An answer that came in while the last step ran was accepted, so it has to count.
bool AlignmentRunner::hasEnded() {
  const OutcomeCode code = kept_.session->outcome().code;
  if (code == OutcomeCode::Canceled || code == OutcomeCode::Declined) return true;
  return bridge_.endSessionIfIdle();
}

// False: a cancel was faster; the session then has ended as well and can be continued.
bool AlignmentRunner::claimOutcome(GoalTicket& ticket) {
  const std::lock_guard<std::mutex> lock(running_mutex_);
  running_ = nullptr;
  if (ticket.claim()) return true;
  if (kept_.session->state() != State::Done) {
    kept_.session->cancel();
    kept_.session->step();
  }
  return false;
}

void AlignmentRunner::conclude(GoalTicket& ticket) {
  const bool ours = claimOutcome(ticket);
  session::Outcome outcome;
  if (ours) {
    outcome = kept_.session->outcome();
  } else {
    outcome.code = OutcomeCode::Canceled;
    outcome.message = "canceled";
  }
  try {
    const AlignResult result = announceOutcome(
        outcome, ticket.isDisplaced() ? kept_.phrases.say("outcome_displaced") : "");
    if (ours) ticket.conclude(result);
  } catch (const std::exception& error) {
    // Who claims a goal owes its client a result, also where the words for it fail.
    ROS_ERROR("the outcome %d can't be told: %s", int{static_cast<std::uint16_t>(outcome.code)},
              error.what());
    if (ours) endWith(ticket, session::outcomeOf(error));
  }
}

// On all topics; the client's result comes last. `instead`: of what the session would say.
AlignResult AlignmentRunner::announceOutcome(const session::Outcome& outcome,
                                             const std::string& instead) {
  const session::Session& session = *kept_.session;
  const session::Snapshot last = session.snapshot();
  AlignResult result = figures(last);
  const AlignResult said = ros_common::toMessage(outcome, kept_.phrases);
  result.outcome = said.outcome;
  result.message =
      instead.empty() ? spokenOutcome(outcome, last, kept_.phrases, kept_.human_plan) : instead;
  result.conflict = said.conflict;
  result.conflict_proven = said.conflict_proven;
  result.conflict_minimal = said.conflict_minimal;
  result.alternatives = said.alternatives;
  result.failing_step = said.failing_step;
  if (outcome.code == OutcomeCode::Success) {
    result.plan = ros_common::toMessage(session, ++plans_, kept_.phrases);
    result.plan.session_id = kept_.id;
    result.plan.header.stamp = ros_common::stampNow();
    plan_watch_.giveOut({result.plan.plan_id, kept_.task_id, kept_.person, kept_.identity});
    announcer_.publish(result.plan);
  }
  if (isDecided(outcome.code)) journal_.drop();
  if (outcome.code == OutcomeCode::UnsureBlocks) forgetUnsureAnswers();
  showToExplainer(last);
  AlignmentState state = stateMessage(last, result.message);
  state.phase = AlignmentState::DONE;
  state.outcome = result.outcome;
  state.conflict = result.conflict;
  state.conflict_proven = result.conflict_proven;
  state.conflict_minimal = result.conflict_minimal;
  state.alternatives = result.alternatives;
  announcer_.publish(state);
  bridge_.markShown();
  announcer_.tell(kept_.phrases.say(
      "event_outcome",
      {std::to_string(result.outcome), session::outcomeWord(outcome.code), result.message}));
  return result;
}

void AlignmentRunner::refuse(GoalTicket& ticket, const session::Outcome& outcome) {
  std::vector<std::string> why = {std::to_string(static_cast<int>(outcome.code)), outcome.message};
  const std::string& task = ticket.goal().task.task_id;
  if (!task.empty()) why.push_back(task);
  announcer_.tell(kept_.phrases.say(task.empty() ? "event_refused" : "event_refused_named", why));
  if (ticket.claim()) endWith(ticket, outcome);
}

// Of a goal that was claimed for it.
void AlignmentRunner::endWith(GoalTicket& ticket, const session::Outcome& outcome) {
  AlignResult result = ticket.interim();
  result.outcome = static_cast<std::uint16_t>(outcome.code);
  result.message = outcome.message;
  // Who sent the task by topic sees no result. A session that could not go on stays as it was.
  if (ticket.goal().continue_session.empty()) {
    AlignmentState state;
    state.phase = AlignmentState::DONE;
    state.session_id = result.session_id;
    state.task_id = ticket.goal().task.task_id;
    state.person = ticket.goal().task.person;
    state.outcome = result.outcome;
    state.message = result.message;
    announcer_.publish(state);
  }
  ticket.conclude(result);
}

}  // namespace goal_alignment::aligner
