// SPDX-License-Identifier: BSD-3-Clause
#include <ros/console.h>

#include <stdexcept>
#include <utility>

#include "goal_alignment/execution/steps.h"
#include "goal_alignment/ros_common/stamp.h"

namespace goal_alignment::execution {
namespace {

/// Of its way a step that fails does so much.
constexpr double kDoneWhenItFails = 0.5;

constexpr double kIdlePeriod = 0.1;  // seconds between broadcasts until options are read

GroundName groundOf(const ActionDispatch& step) {
  GroundName ground{toLower(step.name), {}};
  for (const auto& parameter : step.parameters)
    ground.arguments.push_back(toLower(parameter.value));
  return ground;
}

}  // namespace

SimulatedSteps::SimulatedSteps(const ros::NodeHandle& node, any_message::WaitPoint& wait)
    : wait_(wait),
      timer_(node.createWallTimer(ros::WallDuration(kIdlePeriod),
                                  [this](const ros::WallTimerEvent&) { broadcast(); })) {}

void SimulatedSteps::begin(const StepMapping& mapping, const ExecutorOptions& options) {
  random_ = RandomSource(static_cast<std::uint64_t>(options.seed));
  failures_ = mapping.failures;
  for (const InitialFrame& frame : mapping.frames)
    stage_.add(frame.name, frame.parent, poseOf(frame.pose, mapping.source));
  timer_.setPeriod(ros::WallDuration(1 / options.frame_rate));
}

void SimulatedSteps::broadcast() {
  const ros::Time now = ros_common::stampNow();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (now == last_stamp_) return;  // a clock that stands still: tf2 complains of such repetitions
  last_stamp_ = now;
  const auto transforms = stage_.transforms(now);
  if (!transforms.empty()) broadcaster_.sendTransform(transforms);
}

bool SimulatedSteps::fails(const StepTry& attempt) {
  // Drawn in any case, so that what else fails does not change the luck of later steps.
  const double luck = random_.unit();
  const auto told = failures_.find(groundOf(attempt.step));
  if (told != failures_.end() && told->second != 0) {
    if (told->second != StepRule::kAlways) --told->second;
    return true;
  }
  return attempt.is_to_fail ||
         luck < attempt.rule.failure_probability.value_or(attempt.options.failure_probability);
}

std::vector<SimulatedFrames::Motion> SimulatedSteps::motionsOf(const StepTry& attempt) const {
  std::vector<SimulatedFrames::Motion> motions;
  for (const FrameMove& move : attempt.rule.moves) {
    SimulatedFrames::Motion motion;
    motion.frame = attempt.arguments.fill(move.frame);
    if (!move.parent.IsNull()) motion.parent = attempt.arguments.fill(move.parent);
    if (!move.to.IsNull())
      motion.to = poseOf(attempt.arguments.resolve(move.to), attempt.arguments.source());
    motions.push_back(motion);
  }
  return motions;
}

StepEnd SimulatedSteps::run(const StepTry& attempt) {
  const bool fails = this->fails(attempt);
  try {
    stage_.begin(motionsOf(attempt));
  } catch (const std::invalid_argument& error) {
    return {StepEnd::Kind::Failed, error.what()};
  }
  attempt.dispatch();
  any_message::Timer timer(attempt.options.clock);
  const double seconds = attempt.rule.duration.value_or(attempt.options.step_duration);
  const double end = fails ? seconds * kDoneWhenItFails : seconds;
  const double tick = 1 / attempt.options.frame_rate;
  for (double passed = 0; passed < end; passed = timer.seconds()) {
    if (wait_.pauseUntil(attempt.end.capped(any_message::deadlineIn(std::min(tick, end - passed)))))
      return {StepEnd::Kind::Interrupted, ""};
    if (seconds > 0) stage_.glide(std::min(timer.seconds(), end) / seconds);
    if (attempt.end.isOver() && timer.seconds() < end) return {StepEnd::Kind::TimedOut, ""};
  }
  if (wait_.interrupted()) return {StepEnd::Kind::Interrupted, ""};
  if (fails) return {StepEnd::Kind::Failed, "simulated"};
  stage_.finish();
  return {};
}

}  // namespace goal_alignment::execution
