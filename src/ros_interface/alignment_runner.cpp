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

// Two fields of a goal that can't both be meant.
class ContradictionError : public GoalError {
 public:
  using GoalError::GoalError;
};

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

// The dialogue has come to its end, so there is nothing to take up again after a crash.
bool isDecided(OutcomeCode code) {
  switch (code) {
    case OutcomeCode::Canceled:
    case OutcomeCode::TimeLimit:
    case OutcomeCode::MemoryLimit:
    case OutcomeCode::NoAnswer:
    case OutcomeCode::QuestionLimit:
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
      explainer_(parts.explainer) {}

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
  session::Input input = inputOf(goal, options);
  const std::string key = journalKey(input, goal.task.person);
  session->begin(std::move(input));
  Kept kept;
  kept.id = boost::uuids::to_string(boost::uuids::random_generator()());
  kept.person = goal.task.person;
  kept.task_id = goal.task.task_id;
  kept.ends_when_unsure = goal.unsure_policy == AlignGoal::ABORT;
  try {
    kept.phrases = phrasesOf(options);
  } catch (const std::exception& error) {
    // Wording is no reason to refuse a task.
    announcer_.tell(fmt::format("no phrases: {}", error.what()));
  }
  kept.session = std::move(session);
  kept.journaled = journal_.open(key, options.journal_expiry);
  kept_ = std::move(kept);
  facts_.beginSession(goal.source == AlignGoal::PARAMS);
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
  kept_.session->goOn(session_options);
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
    takeUpFacts();
    const State state = step();
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

session::State AlignmentRunner::step() {
  const auto began = Clock::now();
  const State state = kept_.session->step();
  const std::chrono::duration<double> took = Clock::now() - began;
  ROS_DEBUG("a step of %.3f s led to phase %d", took.count(), int{phaseOf(state)});
  if (!kept_.models_known && kept_.session->robotModel() != nullptr) takeUpModels();
  bridge_.update(kept_.session->snapshot());
  showToExplainer();
  return kept_.session->state();
}

// Once, as soon as the models are read.
void AlignmentRunner::takeUpModels() {
  kept_.models_known = true;
  facts_.setModel(*kept_.session->robotModel());
  takeUpJournal();
}

// What was answered before the dialogue was broken off, perhaps by a crash, is not asked again.
void AlignmentRunner::takeUpJournal() {
  std::vector<Literal> known;
  for (const JournalAnswer& answer : std::exchange(kept_.journaled, {})) {
    // Under this policy "don't know" would end the dialogue before it begins.
    const bool useless = answer.kind == AnswerKind::Unsure && kept_.ends_when_unsure;
    if (useless || isAnswered(answer.fluent)) continue;
    const auto receipt = kept_.session->answer({answer.fluent}, answer.kind, answer.answered_by);
    if (!receipt.accepted) {
      ROS_WARN("an answer of the journal is left out: %s", receipt.message.c_str());
      continue;
    }
    kept_.times[answer.fluent] = answer.at;
    known.push_back(answer.fluent);
  }
  if (known.empty()) return;
  announcer_.tell(fmt::format("answered before this dialogue was broken off: {}", spoken(known)));
}

void AlignmentRunner::takeUpFacts() {
  if (!kept_.models_known || kept_.facts_seen == facts_.version()) return;
  kept_.facts_seen = facts_.version();
  std::vector<GroundName> left_out;
  std::vector<GroundName> before = kept_.session->robotState();
  std::sort(before.begin(), before.end());
  std::vector<GroundName> now = facts_.overlaid(before, left_out);
  for (const GroundName& fact : left_out) {
    if (!kept_.told_left_out.insert(fact).second) continue;
    announcer_.tell(
        fmt::format("the fact {} is left out: this robot's model does not know it", fact.text()));
  }
  if (now == before) return;
  kept_.session->setRobotState(now);
  announcer_.tell("the robot's state has changed: I think again");
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
  kept_.silences = 0;
  writeJournal();
  announcer_.tell(fmt::format(
      "answer{}: {}{}", answer.answered_by.empty() ? "" : " from " + answer.answered_by,
      wordFor(answer.kind), answer.fluents.empty() ? "" : ": " + spoken(answer.fluents)));
  return receipt;
}

void AlignmentRunner::writeJournal() const {
  std::vector<JournalAnswer> answers;
  for (const auto& candidate : kept_.session->snapshot().candidates) {
    const auto time = kept_.times.find(candidate.fluent);
    JournalAnswer answer{candidate.fluent, AnswerKind::No, candidate.answered_by,
                         time == kept_.times.end() ? ros::Time() : time->second};
    if (candidate.state == CandidateState::Wanted) {
      answer.kind = AnswerKind::Yes;
    } else if (candidate.state == CandidateState::Unsure) {
      answer.kind = AnswerKind::Unsure;
    } else if (candidate.state != CandidateState::NotWanted) {
      continue;
    }
    answers.push_back(std::move(answer));
  }
  if (!answers.empty()) journal_.write(answers);
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
  const session::QuestionView& view = *kept_.session->question();
  // A new world may give an old question a new reason.
  const bool same = open_.question_id != 0 && bridge_.openId() == open_.question_id &&
                    open_fluents_ == std::set<Literal>(view.fluents.begin(), view.fluents.end()) &&
                    open_.why == kept_.phrases.reason(view.conflict, view.conflict_proven);
  const auto began = Clock::now();
  if (!same) openQuestion(ticket);
  const QuestionBridge::Wake wake = bridge_.wait(open_until_);
  const std::chrono::duration<double> waited = Clock::now() - began;
  kept_.waiting_time += waited.count();
  if (wake == QuestionBridge::Wake::TimedOut) treatSilence();
  // Dialogue nodes leave the question at once, not only when the next one is known.
  if (bridge_.openId() != open_.question_id) closeQuestion();
}

// A question put again has a new id, so that a dialogue node leaves the old call.
void AlignmentRunner::treatSilence() {
  const auto tries = static_cast<unsigned>(kept_.options.ask_retries) + 1;
  if (++kept_.silences < tries) {
    announcer_.tell(fmt::format("no answer to question {}; it is put again", open_.question_id));
    closeQuestion();
    return;
  }
  const double timeout = kept_.options.ask_timeout;
  kept_.session->giveUpWaiting(
      tries == 1 ? fmt::format("nobody answered within {} s", timeout)
                 : fmt::format("nobody answered {} times within {} s", tries, timeout));
}

void AlignmentRunner::openQuestion(GoalTicket& ticket) {
  const session::QuestionView& view = *kept_.session->question();
  open_ = toMessage(view, kept_.phrases);
  open_fluents_ = {view.fluents.begin(), view.fluents.end()};
  open_.session_id = kept_.id;
  open_.person = kept_.person;
  open_.question_id = bridge_.open(view.fluents);
  open_until_ = Clock::time_point::max();
  if (kept_.options.ask_timeout > 0) {
    const std::chrono::duration<double> timeout(kept_.options.ask_timeout);
    open_until_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(timeout);
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
  if (isDecided(outcome.code)) journal_.drop();
  showToExplainer();
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
  // Who sent the task by topic sees no result. A session that could not go on stays as it was.
  if (ticket.goal().continue_session.empty()) {
    AlignmentState state;
    state.phase = AlignmentState::DONE;
    state.session_id = result.session_id;
    state.outcome = result.outcome;
    state.message = result.message;
    announcer_.publish(state);
  }
  ticket.conclude(result);
}

}  // namespace goal_alignment::ros_interface
