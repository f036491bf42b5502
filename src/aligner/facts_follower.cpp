// SPDX-License-Identifier: BSD-3-Clause
#include "facts_follower.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "goal_alignment/spatial_facts/rules.h"

namespace goal_alignment::aligner {

using session::OutcomeCode;
using session::State;

FactsFollower::FactsFollower(const SessionRecord& current, RobotFacts& facts, TfStateBridge& tf,
                             Tell tell)
    : current_(current), facts_(facts), tf_(tf), tell_(std::move(tell)) {}

void FactsFollower::beginSession() {
  applied_version_ = 0;
  applied_ = {};
  reported_left_out_.clear();
}

void FactsFollower::beginGoal() {
  complete_ = false;
  incomplete_since_.reset();
}

void FactsFollower::onModelsLoaded() {
  const pddl::Model& model = *current_.session->robotModel();
  facts_.setModel(model);
  const auto rules = tf_.rules();
  if (!rules) return;
  try {
    rules->check(model);
  } catch (const spatial_facts::RulesError& error) {
    current_.session->abort(OutcomeCode::InvalidModel, error.what());
  }
}

void FactsFollower::update() {
  if (!current_.models_loaded) return;
  const bool is_done = current_.session->state() == State::Done;
  if (is_done && !session::outcomeTraits(current_.session->outcome().code).rests_on_robot_state)
    return;
  const spatial_facts::Observation seen = tf_.look();
  if (!seen.unknown().empty()) {
    // A short drop-out changes nothing; what was known before stays.
    if (!hasTimeLeft())
      current_.session->abort(OutcomeCode::StateUnknown, seen.unknownFactsMessage());
    return;
  }
  incomplete_since_.reset();
  const bool is_first = !std::exchange(complete_, true);
  // A world that never stands still must not keep the outcome from the person for ever.
  const bool out_of_time = current_.thinkingTime() > current_.options.session.time_limit;
  if (is_done && !is_first && out_of_time) return;
  apply(seen, is_first);
}

// To be asked while facts are missing: they are from now on, or still.
bool FactsFollower::hasTimeLeft() {
  const auto now = Clock::now();
  if (!incomplete_since_) incomplete_since_ = now;
  const std::chrono::duration<double> missing_for = now - *incomplete_since_;
  return missing_for.count() < current_.options.tf_timeout;
}

// The first look only completes the problem file, so nobody is told that facts have changed.
void FactsFollower::apply(const spatial_facts::Observation& seen, bool is_first) {
  const unsigned version = facts_.version();
  if (applied_version_ == version && seen.tellsTheSame(applied_)) return;
  applied_version_ = version;
  applied_ = seen;
  std::vector<GroundName> left_out;
  const std::vector<GroundName> now = facts_.state(seen, left_out);
  const phrasing::Phrases& phrases = current_.phrases;
  for (const GroundName& fact : left_out) {
    if (!reported_left_out_.insert(fact).second) continue;
    tell_(phrases.say("event_fact_left_out", {phrases.clause({fact})}));
  }
  std::vector<GroundName> before = current_.session->robotState();
  std::sort(before.begin(), before.end());
  if (now == before) return;
  current_.session->setRobotState(now);
  if (!is_first) tell_(phrases.say("event_new_facts"));
}

bool FactsFollower::mustWait() const {
  if (!incomplete_since_) return false;
  if (current_.session->state() != State::Done) return !complete_;
  return session::outcomeTraits(current_.session->outcome().code).rests_on_robot_state;
}

std::string FactsFollower::missingFacts() const {
  return tf_.look().unknownFactsMessage();
}

bool FactsFollower::isWithinTimeout() {
  return !tf_.look().unknown().empty() && hasTimeLeft();
}

bool FactsFollower::haveChanged() {
  const spatial_facts::Observation seen = tf_.look();
  if (!seen.unknown().empty()) return !hasTimeLeft();
  incomplete_since_.reset();
  return !seen.tellsTheSame(applied_);
}

FactsFollower::Clock::time_point FactsFollower::nextLook() const {
  if (!tf_.rules()) return Clock::time_point::max();
  const std::chrono::duration<double> period(current_.options.tf_period);
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(period);
}

}  // namespace goal_alignment::aligner
