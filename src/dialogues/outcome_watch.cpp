// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/dialogues/outcome_watch.h"

#include <fmt/format.h>
#include <ros/names.h>
#include <ros/this_node.h>

#include <utility>

#include "goal_alignment/AlignActionGoal.h"
#include "goal_alignment/AlignResult.h"
#include "goal_alignment/ros_common/names.h"
#include "goal_alignment/ros_common/stamp.h"

namespace goal_alignment::dialogues {
namespace {

constexpr std::uint32_t kQueueSize = 100;

bool isEnd(const AlignmentState& state) {
  return state.phase == AlignmentState::DONE && state.outcome != AlignResult::NONE;
}

}  // namespace

OutcomeWatch::OutcomeWatch(ros::NodeHandle node, std::function<void()> changed)
    : changed_(std::move(changed)), began_(ros_common::stampNow()), listener_(1, &callbacks_) {
  node.setCallbackQueue(&callbacks_);
  goals_ = node.advertise<AlignActionGoal>(
      ros::names::append(ros_common::kAlignerAlignAction, "goal"), kQueueSize);
  states_ =
      node.subscribe(ros_common::kAlignerStateTopic, kQueueSize, &OutcomeWatch::hearState, this);
  plans_ = node.subscribe(ros::names::append(ros_common::kDefaultNodeName, ros_common::kPlanTopic),
                          kQueueSize, &OutcomeWatch::hearPlan, this);
  listener_.start();
}

void OutcomeWatch::hearState(const AlignmentState::ConstPtr& state) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    // What is latched may be old, and comes again with each new connection.
    const bool is_new = newest_ ? newest_->header.stamp != state->header.stamp ||
                                      newest_->header.seq != state->header.seq
                                : state->header.stamp >= began_;
    newest_ = *state;
    if (!is_new) return;
    end_.reset();
    if (isEnd(*state) && state->outcome != AlignResult::CANCELED) end_ = *state;
  }
  if (changed_) changed_();
}

void OutcomeWatch::hearPlan(const Plan::ConstPtr& plan) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    plan_ = *plan;
  }
  if (changed_) changed_();
}

std::optional<AlignmentState> OutcomeWatch::takeEnd() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(end_, std::nullopt);
}

bool OutcomeWatch::isGone(const AlignmentState& end) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return newest_ && (newest_->phase != AlignmentState::DONE ||
                     newest_->session_id != end.session_id || newest_->outcome != end.outcome);
}

std::optional<Plan> OutcomeWatch::takePlan(const AlignmentState& end) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!plan_ || plan_->session_id != end.session_id) return std::nullopt;
  return std::exchange(plan_, std::nullopt);
}

bool OutcomeWatch::takeUp(const AlignmentState& end, const AlternativeGoal& alternative,
                          const std::string& person) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (goals_.getNumSubscribers() == 0) return false;
  AlignActionGoal message;
  message.header.stamp = message.goal_id.stamp = ros_common::stampNow();
  message.goal_id.id = fmt::format("{}-{}-{}", ros::this_node::getName(),
                                   ros::WallTime::now().toNSec(), ++taken_up_);
  message.goal.task.person = person;
  message.goal.max_questions = -1;
  message.goal.unsure_policy = AlignGoal::KEEP;
  message.goal.continue_session = end.session_id;
  message.goal.revised_not_wanted = alternative.given_up;
  goals_.publish(message);
  return true;
}

std::string leftOutBy(const AlternativeGoal& alternative) {
  std::string text;
  for (const Fluent& fluent : alternative.given_up) {
    text += text.empty() ? "" : "; ";
    text += fluent.text.empty() ? fmt::format("{} {}", fluent.name, fmt::join(fluent.args, " "))
                                : fluent.text;
  }
  return text;
}

}  // namespace goal_alignment::dialogues
