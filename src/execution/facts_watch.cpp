// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/facts_watch.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <algorithm>
#include <utility>

#include "goal_alignment/execution/tf_frames.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_common/message_conversion.h"
#include "goal_alignment/ros_common/package_files.h"

namespace goal_alignment::execution {
namespace {

using Verdict = PreconditionMonitor::Verdict;

constexpr std::chrono::milliseconds kLookPause{100};  // between two looks at the facts

GroundName groundOf(const ActionDispatch& step) {
  GroundName ground{toLower(step.name), {}};
  for (const auto& parameter : step.parameters)
    ground.arguments.push_back(toLower(parameter.value));
  return ground;
}

bool isUnknown(const WorldState& world, const GroundName& atom) {
  return std::find(world.unknown.begin(), world.unknown.end(), atom) != world.unknown.end();
}

}  // namespace

std::string textOf(const ActionDispatch& step) {
  std::string text = "(" + step.name;
  for (const auto& parameter : step.parameters)
    text += " " + parameter.value;
  return text + ")";
}

void FactsWatch::begin(const Plan& plan) {
  session_ = plan.session_id;
  unwatched_ = "its preconditions are not watched";
  if (!options_.watch) return;
  if (session_.empty()) return giveUp("the plan names no session of an aligner");
  const auto file = [this](const std::string& given, const char* key) {
    return ros_common::resolveFile(given.empty() ? aligner_.parameter(key) : given);
  };
  ledger_.beginRun();
  const auto facts = aligner_.facts();
  try {
    watch_.emplace(pddl::readModel(pddl::readFile(file(options_.robot_domain, "robot_domain")),
                                   pddl::readFile(file(options_.robot_problem, "robot_problem"))));
  } catch (const std::exception& error) {
    return giveUp(facts.known ? error.what() : facts.message);
  }
  if (!facts.known) goBlind(facts.message);
}

void FactsWatch::giveUp(const std::string& why) {
  watch_.reset();
  if (wait_.interrupted()) return;  // nobody is interested any more
  unwatched_ = "what is so is not known: " + why;
  ROS_WARN("the plan runs without a look at its preconditions: %s", why.c_str());
}

// For the time being: the aligner may be started anew, or read the models of another task.
void FactsWatch::goBlind(const std::string& why) {
  if (wait_.interrupted()) return;
  if (blind_ != why)
    ROS_WARN("the plan runs without a look at what is so, until that is known again: %s",
             why.c_str());
  blind_ = why;
}

std::optional<WorldState> FactsWatch::world() {
  ledger_.tell();
  auto facts = aligner_.facts();
  if (!facts.known) {
    goBlind(facts.message);
    return std::nullopt;
  }
  session_is_lost_ = facts.session_id != session_;
  if (session_is_lost_ && facts.session_id != other_session_) {
    other_session_ = facts.session_id;
    ROS_WARN("%s: the plan goes on, but can't be replaced", whyLost().c_str());
    ledger_.tellAgain();
    return world();
  }
  blind_.clear();
  ledger_.compare(facts.world);
  return std::move(facts.world);
}

FactsWatch::Look FactsWatch::beforeStep(const Plan& plan, std::size_t index) {
  session_ = plan.session_id;
  std::vector<GroundName> steps;
  for (std::size_t i = index; i < plan.steps.size(); ++i)
    steps.push_back(groundOf(plan.steps[i]));
  const std::vector<Literal> wanted = ros_common::toLiterals(plan.guaranteed, "guaranteed");
  const auto judge = [&](const WorldState& world) {
    const PreconditionMonitor::Finding finding = watch_->precondition(steps.front(), world);
    return finding.verdict == Verdict::Holds ? judgeRest(steps, wanted, world) : finding;
  };
  return await(judge, index, steps.size());
}

FactsWatch::Look FactsWatch::atTheEnd(const Plan& plan) {
  const std::vector<Literal> wanted = ros_common::toLiterals(plan.guaranteed, "guaranteed");
  const auto judge = [&](const WorldState& world) { return watch_->literals(wanted, world); };
  const Look look = await(judge, plan.steps.size(), 0);
  if (look.kind != Look::Kind::Fine || blind_.empty() || !watch_ || !now_) return look;
  // Nobody else can tell whether it is as it has to be.
  const PreconditionMonitor::Finding finding = judge(*now_);
  return finding.verdict == Verdict::False
             ? Look{Look::Kind::End, plan.steps.size(), finding.reason}
             : look;
}

// Only where something is not as it was expected: what was fine stays so.
PreconditionMonitor::Finding FactsWatch::judgeRest(const std::vector<GroundName>& steps,
                                                   const std::vector<Literal>& wanted,
                                                   const WorldState& world) {
  if (rest_is_fine_ && now_ && *now_ == world) return {};
  const PreconditionMonitor::Finding finding = watch_->rest(steps, wanted, world);
  rest_is_fine_ = finding.verdict == Verdict::Holds;
  return finding;
}

FactsWatch::Look FactsWatch::await(const Judge& judge, std::size_t first_step, std::size_t steps) {
  const auto patience = any_message::deadlineIn(options_.facts_timeout);
  std::optional<WorldState> judged;
  PreconditionMonitor::Finding finding;
  while (watch_) {
    if (wait_.interrupted()) return {Look::Kind::Interrupted, first_step, ""};
    auto seen = world();
    if (!seen) break;
    if (!judged || !(*judged == *seen)) finding = judge(*seen);
    judged = std::move(seen);
    if (finding.verdict == Verdict::NoModel) {
      if (session_is_lost_) {
        goBlind(finding.reason);
      } else {
        giveUp(finding.reason);
      }
      break;
    }
    const bool is_settled = claimsAreSettled(*judged);
    if (finding.verdict == Verdict::Holds && (is_settled || steps > 0)) {
      now_ = std::move(judged);
      return {};
    }
    if (any_message::Clock::now() >= patience && finding.verdict != Verdict::Holds) {
      const auto kind = finding.step < steps ? Look::Kind::Step : Look::Kind::End;
      return {kind, first_step + finding.step, finding.reason};
    }
    wait_.pauseUntil(any_message::Clock::now() + kLookPause);
  }
  const bool is_over = steps == 0 && !watch_;  // everything is done, and nobody looks
  if (!is_over && wait_.interrupted()) return {Look::Kind::Interrupted, first_step, ""};
  return {};
}

void FactsWatch::succeeded(const ActionDispatch& step) {
  if (!watch_) return;
  const GroundName action = groundOf(step);
  auto changes = now_ ? watch_->effects(action, *now_) : watch_->certainEffects(action);
  // Where it could not begin, as far as is known here, some of what is known is wrong.
  if (changes.empty()) changes = watch_->certainEffects(action);
  if (now_) now_->apply(changes);
  for (const Literal& change : changes)
    claims_[change.atom] = {!change.negated, textOf(step), any_message::Clock::now()};
  ledger_.enter(changes);
}

void FactsWatch::failed(const ActionDispatch& step, const std::vector<Literal>& facts) {
  if (!watch_) return;
  for (const Literal& fact : facts) {
    std::string why_not;
    if (!watch_->model().resolve(fact.atom, &why_not))
      ROS_WARN("%s: of the failure_facts %s is no fact: %s", textOf(step).c_str(),
               fact.text().c_str(), why_not.c_str());
  }
  if (now_) now_->apply(facts);
  ledger_.enter(facts);
}

// What tf tells lags behind a step, and stops to be news when others are told about it.
bool FactsWatch::claimsAreSettled(const WorldState& world) {
  const std::chrono::duration<double> patience(options_.facts_timeout);
  for (auto entry = claims_.begin(); entry != claims_.end();) {
    const auto& [atom, claim] = *entry;
    const bool holds = std::binary_search(world.facts.begin(), world.facts.end(), atom);
    const bool is_denied = holds != claim.holds && !isUnknown(world, atom);
    const bool is_late = any_message::Clock::now() >= claim.since + patience;
    if (is_denied && is_late) contradict(atom, claim);
    entry = is_denied && !is_late ? std::next(entry) : claims_.erase(entry);
  }
  return claims_.empty();
}

void FactsWatch::contradict(const GroundName& atom, const Claim& claim) const {
  const std::string by = framesOf(atom, aligner_.parameter("tf_facts"));
  if (by.empty()) return;  // somebody has said so since
  ROS_WARN(
      "tf contradicts a step that succeeded: after %s it should be %s, but tf says %s, by the %s;"
      " what tf says counts",
      claim.step.c_str(), Literal{atom, !claim.holds}.text().c_str(),
      Literal{atom, claim.holds}.text().c_str(), by.c_str());
}

std::string FactsWatch::whyLost() const {
  return other_session_.empty() ? "the aligner was started anew and has forgotten the task"
                                : "the aligner is at another task by now";
}

std::string FactsWatch::whyNoNewPlan() {
  // Without the facts a new plan would begin where this one did.
  if (!watch_) return unwatched_;
  world();
  if (!blind_.empty()) return "what is so is not known: " + blind_;
  if (session_is_lost_) return whyLost();
  rest_is_fine_ = false;
  return "";
}

}  // namespace goal_alignment::execution
