// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/alignment_runner.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <algorithm>
#include <boost/uuid/random_generator.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <exception>
#include <utility>
#include <vector>

#include "goal_alignment/ros_interface/model_source.h"
#include "goal_alignment/ros_interface/stamp.h"

namespace goal_alignment::ros_interface {
namespace {

using session::AnswerKind;
using session::CandidateState;
using session::OutcomeCode;
using session::State;

const char* wordFor(AnswerKind kind) {
  switch (kind) {
    case AnswerKind::No:
      return "no";
    case AnswerKind::Yes:
      return "yes";
    case AnswerKind::Unsure:
      return "don't know";
    case AnswerKind::Decline:
      return "no more questions, please";
  }
  return "";
}

session::Outcome invalidInput(const std::exception& error) {
  session::Outcome outcome;
  outcome.code = OutcomeCode::InvalidModel;
  outcome.message = error.what();
  return outcome;
}

}  // namespace

AlignmentRunner::AlignmentRunner(ros::NodeHandle private_node, Announcer& announcer,
                                 QuestionBridge& bridge, AskHumanClient& ask_human)
    : private_node_(std::move(private_node)),
      announcer_(announcer),
      bridge_(bridge),
      ask_human_(ask_human) {}

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
  } catch (const GoalError& error) {
    return refuse(ticket, invalidInput(error));
  } catch (const ParameterError& error) {
    return refuse(ticket, invalidInput(error));
  } catch (const std::exception& error) {
    return refuse(ticket, session::outcomeOf(error));
  }
  {
    const std::lock_guard<std::mutex> lock(running_mutex_);
    running_ = &ticket;
  }
  ticket.accept();
  announcer_.tell(storyOf(ticket.goal()));
  try {
    loop(ticket);
    conclude(ticket);
  } catch (const std::exception& error) {
    // The session makes outcomes of all its errors, so this one is ours.
    ROS_ERROR("the alignment broke off: %s", error.what());
    closeQuestion();
    bridge_.endSession();
    refuse(ticket, session::outcomeOf(error));
  }
  const std::lock_guard<std::mutex> lock(running_mutex_);
  running_ = nullptr;
}

void AlignmentRunner::prepare(const AlignGoal& goal) {
  const NodeOptions options = NodeOptions::read(private_node_);
  warnAboutUnknown(options);
  if (goal.continue_session.empty()) {
    begin(goal, options);
  } else {
    continueSession(goal, options);
  }
  kept_.options = options;
}

void AlignmentRunner::begin(const AlignGoal& goal, const NodeOptions& options) {
  if (!goal.revised_wanted.empty() || !goal.revised_not_wanted.empty()) {
    throw GoalError("revised_wanted and revised_not_wanted need continue_session");
  }
  auto session = std::make_shared<session::Session>(optionsOf(goal, options));
  session->begin(inputOf(goal, options));
  Kept kept;
  kept.id = boost::uuids::to_string(boost::uuids::random_generator()());
  kept.person = goal.task.person;
  kept.task_id = goal.task.task_id;
  try {
    kept.phrases = phrasesOf(options);
  } catch (const std::exception& error) {
    // Wording is no reason to refuse a task.
    announcer_.tell(fmt::format("no phrases: {}", error.what()));
  }
  kept.session = std::move(session);
  kept_ = std::move(kept);
  bridge_.beginSession(kept_.id);
}

void AlignmentRunner::continueSession(const AlignGoal& goal, const NodeOptions& options) {
  (void)optionsOf(goal, options);  // refuses what a new session would refuse
  if (!kept_.session || goal.continue_session != kept_.id) {
    throw GoalError(fmt::format("continue_session: there is no session '{:.60}' to go on with",
                                goal.continue_session));
  }
  const auto wanted = candidatesOf(goal.revised_wanted, "revised_wanted");
  const auto not_wanted = candidatesOf(goal.revised_not_wanted, "revised_not_wanted");
  const auto& statistics = kept_.session->statistics();
  kept_.thinking_before = statistics.total;
  kept_.calls_before = statistics.planner_calls;
  kept_.questions_before = kept_.session->snapshot().questions_asked;
  kept_.waiting_time = 0;
  bridge_.beginSession(kept_.id);
  bridge_.update(kept_.session->snapshot());
  if (!wanted.empty()) apply({wanted, AnswerKind::Yes, goal.task.person, 0});
  if (!not_wanted.empty()) apply({not_wanted, AnswerKind::No, goal.task.person, 0});
}

std::vector<Literal> AlignmentRunner::candidatesOf(const std::vector<Fluent>& fluents,
                                                   const std::string& field) const {
  std::vector<Literal> literals;
  try {
    literals = toLiterals(fluents, field);
  } catch (const std::invalid_argument& error) {
    throw GoalError(error.what());
  }
  const session::Snapshot snapshot = kept_.session->snapshot();
  for (const Literal& literal : literals) {
    const bool known =
        std::any_of(snapshot.candidates.begin(), snapshot.candidates.end(),
                    [&](const auto& candidate) { return candidate.fluent == literal; });
    if (!known) {
      throw GoalError(fmt::format("{}: {} is no candidate of this session", field, literal.text()));
    }
  }
  return literals;
}

void AlignmentRunner::warnAboutUnknown(const NodeOptions& options) {
  for (const std::string& key : options.unknown) {
    if (!warned_about_.insert(key).second) continue;
    ROS_WARN("nobody reads the parameter %s", private_node_.resolveName(key).c_str());
  }
}

void AlignmentRunner::loop(GoalTicket& ticket) {
  report(ticket, "");
  while (!ticket.ended()) {
    applyAnswers();
    const State state = kept_.session->step();
    bridge_.update(kept_.session->snapshot());
    if (state == State::Done && hasEnded()) break;
    if (state == State::AwaitingAnswer) {
      waitForAnswer(ticket);
    } else {
      report(ticket, "");
    }
  }
  closeQuestion();
  bridge_.endSession();
}

// An answer that came in while the last step ran was accepted, so it has to count.
bool AlignmentRunner::hasEnded() {
  const OutcomeCode code = kept_.session->outcome().code;
  if (code == OutcomeCode::Canceled || code == OutcomeCode::Declined) return true;
  return bridge_.endSessionIfIdle();
}

void AlignmentRunner::applyAnswers() {
  for (const AcceptedAnswer& answer : bridge_.take()) {
    const session::Receipt receipt = apply(answer);
    if (!receipt.accepted) {
      // The bridge knows all of the session's reasons, so this is a fault of ours.
      ROS_ERROR("an accepted answer was refused by the session: %s", receipt.message.c_str());
    }
    // A dialogue that was declined is over; what came after must not begin it anew.
    if (kept_.session->state() == State::Done) return;
  }
}

session::Receipt AlignmentRunner::apply(const AcceptedAnswer& answer) {
  std::vector<Literal> first;
  std::vector<Literal> again;
  for (const Literal& fluent : answer.fluents) {
    (isAnswered(fluent) ? again : first).push_back(fluent);
  }
  session::Session& session = *kept_.session;
  const bool declined = answer.kind == AnswerKind::Decline;
  session::Receipt receipt{true, ""};
  if (!first.empty() || declined) receipt = session.answer(first, answer.kind, answer.answered_by);
  if (receipt.accepted && !again.empty()) {
    receipt = session.revise(again, answer.kind, answer.answered_by);
  }
  if (!receipt.accepted) return receipt;
  for (const Literal& fluent : answer.fluents)
    kept_.times[fluent] = stampNow();
  announcer_.tell(fmt::format(
      "answer{}: {}{}", answer.answered_by.empty() ? "" : " from " + answer.answered_by,
      wordFor(answer.kind), answer.fluents.empty() ? "" : ": " + spoken(answer.fluents)));
  return receipt;
}

bool AlignmentRunner::isAnswered(const Literal& fluent) const {
  const session::Snapshot snapshot = kept_.session->snapshot();
  return std::any_of(
      snapshot.candidates.begin(), snapshot.candidates.end(), [&](const auto& candidate) {
        return candidate.fluent == fluent && (candidate.state == CandidateState::Wanted ||
                                              candidate.state == CandidateState::NotWanted ||
                                              candidate.state == CandidateState::Unsure);
      });
}

void AlignmentRunner::waitForAnswer(GoalTicket& ticket) {
  const auto& fluents = kept_.session->question()->fluents;
  const bool same = open_.question_id != 0 && bridge_.openId() == open_.question_id &&
                    open_fluents_ == std::set<Literal>(fluents.begin(), fluents.end());
  if (!same) openQuestion(ticket);
  const double timeout = kept_.options.ask_timeout;
  const auto began = Clock::now();
  const auto deadline = timeout <= 0 ? Clock::time_point::max()
                                     : began + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(timeout));
  const QuestionBridge::Wake wake = bridge_.wait(deadline);
  const std::chrono::duration<double> waited = Clock::now() - began;
  kept_.waiting_time += waited.count();
  if (wake == QuestionBridge::Wake::TimedOut) {
    kept_.session->giveUpWaiting(fmt::format("nobody answered within {} s", timeout));
  }
  // Dialogue nodes leave the question at once, not only when the next one is known.
  if (bridge_.openId() != open_.question_id) closeQuestion();
}

void AlignmentRunner::openQuestion(GoalTicket& ticket) {
  const session::QuestionView& view = *kept_.session->question();
  open_ = toMessage(view, kept_.phrases);
  open_fluents_ = {view.fluents.begin(), view.fluents.end()};
  open_.session_id = kept_.id;
  open_.person = kept_.person;
  open_.question_id = bridge_.open(view.fluents);
  if (kept_.options.ask_timeout > 0) {
    open_.expires = stampNow() + ros::Duration(kept_.options.ask_timeout);
  }
  // First of all the result that a cancel would take: it may come as soon as the question is seen.
  report(ticket, open_.text);
  open_ = announcer_.publish(open_);
  announcer_.tell(fmt::format("question {}: {}{}{}", open_.question_id, open_.text,
                              open_.why.empty() ? "" : " ", open_.why));
  report(ticket, open_.text);
  ask_human_.ask(open_);
}

void AlignmentRunner::closeQuestion() {
  bridge_.close();
  if (open_.question_id == 0) return;
  open_ = Question{};
  open_fluents_.clear();
  ask_human_.withdraw();
  announcer_.publishNoQuestion();
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
  session::Session& session = *kept_.session;
  session::Outcome outcome;
  if (ours) {
    outcome = session.outcome();
  } else {
    outcome.code = OutcomeCode::Canceled;
    outcome.message = "canceled";
  }
  AlignResult result = figures();
  const AlignResult said = toMessage(outcome, kept_.phrases);
  result.outcome = said.outcome;
  result.message = said.message;
  result.conflict = said.conflict;
  result.alternatives = said.alternatives;
  result.failing_step = said.failing_step;
  if (outcome.code == OutcomeCode::Success) {
    result.plan = toMessage(session, ++plans_, kept_.phrases);
    result.plan.session_id = kept_.id;
    result.plan.header.stamp = stampNow();
    announcer_.publish(result.plan);
  }
  AlignmentState state = stateMessage(outcome.message);
  state.phase = AlignmentState::DONE;
  state.outcome = result.outcome;
  announcer_.publish(state);
  announcer_.tell(fmt::format("outcome {} ({}): {}", result.outcome,
                              session::outcomeWord(outcome.code), result.message));
  if (ours) ticket.conclude(result);
}

void AlignmentRunner::refuse(GoalTicket& ticket, const session::Outcome& outcome) {
  announcer_.tell(
      fmt::format("task {}refused ({}): {}",
                  ticket.goal().task.task_id.empty() ? "" : ticket.goal().task.task_id + " ",
                  static_cast<int>(outcome.code), outcome.message));
  if (!ticket.claim()) return;
  AlignResult result = ticket.interim();
  result.outcome = static_cast<std::uint16_t>(outcome.code);
  result.message = outcome.message;
  ticket.conclude(result);
}

}  // namespace goal_alignment::ros_interface
