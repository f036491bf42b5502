// SPDX-License-Identifier: BSD-3-Clause
// How the runner keeps up with what is so in the robot's world.

#include <algorithm>
#include <vector>

#include "alignment_runner.h"

namespace goal_alignment::aligner {
namespace {

using session::OutcomeCode;

// What would be another outcome in another world.
bool restsOnFacts(OutcomeCode code) {
  return code == OutcomeCode::Success || code == OutcomeCode::GoalUnsolvable ||
         code == OutcomeCode::ExpectationUnachievable;
}

}  // namespace

// A task whose models come from parameters begins where the ones before have led.
void AlignmentRunner::inheritFacts(const NodeOptions& options, session::Input& input) {
  const std::string news = facts_.follow(FactScope::of(input, options.world), options.facts_expiry);
  if (!news.empty()) announcer_.tell(news);
  input.human_facts = facts_.believed(options.human_state_follows);
}

// Rules that the robot's model can't follow refuse the task, as a model would that is broken.
void AlignmentRunner::checkRules() {
  const auto rules = tf_.rules();
  if (!rules) return;
  try {
    rules->check(*kept_.session->robotModel());
  } catch (const spatial_facts::RulesError& error) {
    kept_.session->abort(OutcomeCode::InvalidModel, error.what());
  }
}

void AlignmentRunner::takeUpFacts() {
  if (!kept_.models_known) return;
  const bool is_done = kept_.session->state() == State::Done;
  if (is_done && !restsOnFacts(kept_.session->outcome().code)) return;
  const spatial_facts::Observation seen = tf_.look();
  if (!seen.unknown().empty()) return missFacts(seen);
  kept_.unknown_since.reset();
  const bool is_first = !kept_.facts_known;
  kept_.facts_known = true;
  // A world that never stands still must not keep the outcome from the person for ever.
  const double thought = kept_.session->statistics().total - kept_.thinking_before;
  if (is_done && !is_first && thought > kept_.options.session.time_limit) return;
  applyFacts(seen, is_first);
}

// A drop-out may be short. What was found out before stays until it has lasted.
void AlignmentRunner::missFacts(const spatial_facts::Observation& seen) {
  if (!patienceLasts()) kept_.session->abort(OutcomeCode::StateUnknown, seen.unknownFactsMessage());
}

// With what is unknown, which it is from now on, or still.
bool AlignmentRunner::patienceLasts() {
  const auto now = Clock::now();
  if (!kept_.unknown_since) kept_.unknown_since = now;
  const std::chrono::duration<double> missed = now - *kept_.unknown_since;
  return missed.count() < kept_.options.tf_patience;
}

// What the first look changes nobody was told otherwise.
void AlignmentRunner::applyFacts(const spatial_facts::Observation& seen, bool is_first) {
  const unsigned version = facts_.version();
  if (kept_.facts_seen == version && seen.tellsTheSame(kept_.seen)) return;
  kept_.facts_seen = version;
  kept_.seen = seen;
  std::vector<GroundName> left_out;
  const std::vector<GroundName> now = facts_.state(seen, left_out);
  for (const GroundName& fact : left_out) {
    if (!kept_.told_left_out.insert(fact).second) continue;
    announcer_.tell(kept_.phrases.say("event_fact_left_out", {kept_.phrases.clause({fact})}));
  }
  std::vector<GroundName> before = kept_.session->robotState();
  std::sort(before.begin(), before.end());
  if (now == before) return;
  kept_.session->setRobotState(now);
  if (!is_first) announcer_.tell(kept_.phrases.say("event_new_facts"));
}

// Nobody plans before the facts are known, and no plan counts while they are not.
bool AlignmentRunner::factsAreAwaited() const {
  if (!kept_.unknown_since) return false;
  if (kept_.session->state() != State::Done) return !kept_.facts_known;
  return restsOnFacts(kept_.session->outcome().code);
}

void AlignmentRunner::awaitFacts(GoalTicket& ticket) {
  report(ticket, kept_.session->snapshot(), "waiting for tf: " + tf_.look().unknownFactsMessage());
  while (bridge_.wait(nextLook()) == QuestionBridge::Wake::TimedOut) {
    if (tf_.look().unknown().empty() || !patienceLasts()) return;
  }
}

// For who waits with a question open.
bool AlignmentRunner::factsHaveChanged() {
  const spatial_facts::Observation seen = tf_.look();
  if (!seen.unknown().empty()) return !patienceLasts();
  kept_.unknown_since.reset();
  return !seen.tellsTheSame(kept_.seen);
}

QuestionBridge::Clock::time_point AlignmentRunner::nextLook() const {
  if (!tf_.rules()) return Clock::time_point::max();
  const std::chrono::duration<double> period(kept_.options.tf_period);
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(period);
}

}  // namespace goal_alignment::aligner
