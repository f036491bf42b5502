// SPDX-License-Identifier: BSD-3-Clause
#include "session_starter.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <algorithm>
#include <boost/uuid/random_generator.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

#include "align_goal_reader.h"
#include "fact_file.h"
#include "goal_alignment/aligner/phrases_file.h"
#include "goal_alignment/ros_common/stamp.h"
#include "goal_alignment/spatial_facts/rules.h"
#include "goal_ticket.h"

namespace goal_alignment::aligner {
namespace {

using session::AnswerKind;
using session::OutcomeCode;

// Two fields of a goal that can't both be meant.
class ContradictionError : public GoalError {
 public:
  using GoalError::GoalError;
};

session::Outcome refusal(OutcomeCode code, const std::exception& error) {
  session::Outcome outcome;
  outcome.code = code;
  outcome.message = error.what();
  return outcome;
}

}  // namespace

SessionStarter::SessionStarter(ros::NodeHandle private_node, const Targets& targets,
                               SessionRecord& current, SessionAnswers& answers)
    : private_node_(std::move(private_node)),
      targets_(targets),
      current_(current),
      answers_(answers) {}

std::optional<session::Outcome> SessionStarter::start(const AlignGoal& goal) {
  try {
    prepare(goal);
    return std::nullopt;
  } catch (const ContradictionError& error) {
    return refusal(OutcomeCode::Contradiction, error);
  } catch (const GoalError& error) {
    return refusal(OutcomeCode::InvalidModel, error);
  } catch (const ros_common::ParameterError& error) {
    return refusal(OutcomeCode::InvalidModel, error);
  } catch (const spatial_facts::RulesError& error) {
    return refusal(OutcomeCode::InvalidModel, error);
  } catch (const std::exception& error) {
    return session::outcomeOf(error);
  }
}

void SessionStarter::prepare(const AlignGoal& goal) {
  const NodeOptions options = NodeOptions::read(private_node_);
  warnAboutParameters(options);
  const auto rules = rulesOf(options.tf_facts);
  if (goal.continue_session.empty()) {
    begin(goal, options);
  } else {
    if (rules && current_.models_loaded) rules->check(*current_.session->robotModel());
    continueSession(goal, options);
  }
  current_.options = options;
  targets_.tf.follow(rules);
}

void SessionStarter::begin(const AlignGoal& goal, const NodeOptions& options) {
  if (!goal.revised_wanted.empty() || !goal.revised_not_wanted.empty()) {
    throw GoalError("revised_wanted and revised_not_wanted need continue_session");
  }
  const bool from_parameters = goal.source == AlignGoal::PARAMS;
  auto session = std::make_shared<session::Session>(optionsOf(goal, options));
  session::Input input = inputOf(goal, options);
  const std::string key = journalKey(input, goal.task.person, private_node_.getNamespace());
  if (from_parameters) inheritFacts(options, input);
  SessionRecord record;
  record.human_plan = input.human_plan;
  session->begin(std::move(input));
  record.labels = {boost::uuids::to_string(boost::uuids::random_generator()()), goal.task.person,
                   goal.task.task_id, identityOf(goal)};
  record.phrases = readPhrases(options);
  record.session = std::move(session);
  record.journaled = targets_.journal.open(key, record.labels.id, options.journal_expiry);
  current_ = std::move(record);
  targets_.facts.beginSession(current_.labels.id, from_parameters);
  targets_.bridge.beginSession(current_.labels.id);
}

// A faulty file of phrases is no reason to refuse a task.
phrasing::Phrases SessionStarter::readPhrases(const NodeOptions& options) {
  try {
    phrasing::Phrases phrases = phrasesOf(options.phrases);
    if (!phrases.warning().empty()) ROS_WARN("%s", phrases.warning().c_str());
    return phrases;
  } catch (const std::exception& error) {
    targets_.announcer.warn(fmt::format("no phrases: {}", error.what()));
    return {};
  }
}

// A task whose models come from parameters begins in the state that earlier tasks have led to.
void SessionStarter::inheritFacts(const NodeOptions& options, session::Input& input) {
  const std::string news =
      targets_.facts.follow(FactScope::of(input, options.world), options.facts_expiry);
  if (!news.empty()) targets_.announcer.tell(news);
  input.human_facts = targets_.facts.believed(options.human_state_follows);
}

void SessionStarter::continueSession(const AlignGoal& goal, const NodeOptions& options) {
  const session::Options session_options = optionsOf(goal, options);
  if (!current_.session || goal.continue_session != current_.labels.id) {
    throw GoalError(fmt::format("continue_session: there is no session '{:.60}' to continue",
                                goal.continue_session));
  }
  const auto wanted = answers_.candidatesOf(goal.revised_wanted, "revised_wanted");
  const auto not_wanted = answers_.candidatesOf(goal.revised_not_wanted, "revised_not_wanted");
  for (const Literal& fluent : wanted) {
    if (std::find(not_wanted.begin(), not_wanted.end(), fluent) == not_wanted.end()) continue;
    throw ContradictionError(fluent.text() + " is in revised_wanted and in revised_not_wanted");
  }
  current_.beginNextGoal();
  current_.session->resume(session_options);
  targets_.bridge.beginSession(current_.labels.id);
  targets_.bridge.update(current_.session->snapshot());
  const std::string& person = goal.task.person;
  if (!wanted.empty()) answers_.apply({wanted, AnswerKind::Yes, person, 0, ros_common::stampNow()});
  if (!not_wanted.empty())
    answers_.apply({not_wanted, AnswerKind::No, person, 0, ros_common::stampNow()});
}

void SessionStarter::warnAboutParameters(const NodeOptions& options) {
  for (const std::string& warning : options.warnings) {
    if (reported_parameters_.insert(warning).second) ROS_WARN("%s", warning.c_str());
  }
}

}  // namespace goal_alignment::aligner
