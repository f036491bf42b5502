// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/wall_timer.h>
#include <tf2_ros/transform_broadcaster.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "goal_alignment/ActionDispatch.h"
#include "goal_alignment/ActionFeedback.h"
#include "goal_alignment/any_message/action_client.h"
#include "goal_alignment/any_message/service_caller.h"
#include "goal_alignment/any_message/wait_point.h"
#include "goal_alignment/common/random_source.h"
#include "goal_alignment/execution/dispatch_listeners.h"
#include "goal_alignment/execution/executor_options.h"
#include "goal_alignment/execution/simulated_frames.h"
#include "goal_alignment/execution/step_mapping.h"

namespace goal_alignment::execution {

/// What became of one try of a step.
struct StepEnd {
  enum class Kind { Succeeded, Failed, TimedOut, Interrupted };
  Kind kind = Kind::Succeeded;
  std::string reason;   ///< for people, where it did not succeed
  bool is_over = true;  ///< false: whoever carries it out is still at it
};

/// One try of a step.
struct StepTry {
  const ActionDispatch& step;
  const StepRule& rule;
  const any_message::Arguments& arguments;
  any_message::MessageTypes& types;
  const ExecutorOptions& options;
  any_message::TimeLimit end;         ///< of the try's time
  bool is_to_fail = false;            ///< simulated: the parameter failing_step says so
  std::function<void()> dispatch;     ///< publishes the step
  std::function<void(int)> progress;  ///< tells who sent the plan a status of ActionFeedback
};

/// One way to carry out steps. Runs on the thread that runs plans; an interrupt reaches it through
/// the wait point. A fault of the mapping throws YamlError, one of a type TypeError.
class StepRunner {
 public:
  virtual ~StepRunner() = default;
  virtual StepEnd run(const StepTry& attempt) = 0;

  /// Begins to link up with who carries such a step out.
  virtual void approach(const StepRule& /*rule*/, const any_message::Arguments& /*arguments*/) {}
  /// Waits until who carries it out is there, after approach(); else, for people, who is missing.
  /// An interrupt ends the wait, whatever is said then.
  virtual std::string missing(const StepRule& /*rule*/, const any_message::Arguments& /*arguments*/,
                              any_message::Clock::time_point /*until*/) {
    return "";
  }
};

/// StepKind::Action.
class ActionSteps : public StepRunner {
 public:
  ActionSteps(ros::NodeHandle node, any_message::WaitPoint& wait)
      : node_(std::move(node)), wait_(wait) {}
  StepEnd run(const StepTry& attempt) override;
  void approach(const StepRule& rule, const any_message::Arguments& arguments) override;
  std::string missing(const StepRule& rule, const any_message::Arguments& arguments,
                      any_message::Clock::time_point until) override;

 private:
  any_message::ActionClient& clientOf(const std::string& name,
                                      const any_message::ActionDefinition& type);

  ros::NodeHandle node_;
  any_message::WaitPoint& wait_;
  // By resolved name; kept, since connecting takes time.
  std::map<std::string, std::unique_ptr<any_message::ActionClient>> clients_;
};

/// StepKind::Service.
class ServiceSteps : public StepRunner {
 public:
  explicit ServiceSteps(any_message::ServiceCaller& services) : services_(services) {}
  StepEnd run(const StepTry& attempt) override;
  std::string missing(const StepRule& rule, const any_message::Arguments& arguments,
                      any_message::Clock::time_point until) override;

 private:
  any_message::ServiceCaller& services_;
};

/// StepKind::Dispatch: others hear the dispatched step and answer on action_feedback.
class DispatchedSteps : public StepRunner {
 public:
  DispatchedSteps(ros::NodeHandle node, ros::Publisher dispatches, DispatchListeners& listeners,
                  any_message::WaitPoint& wait);
  StepEnd run(const StepTry& attempt) override;
  std::string missing(const StepRule& rule, const any_message::Arguments& arguments,
                      any_message::Clock::time_point until) override;

 private:
  void hear(const ros::MessageEvent<const ActionFeedback>& event);
  // Both need mutex_.
  bool isAbout(const ActionFeedback& feedback, const std::string& from);
  bool mayBeLate(const ActionFeedback& feedback) const;
  void expect(const ActionDispatch* step);
  StepEnd await(const StepTry& attempt, const any_message::TimeLimit& patience);
  StepEnd withdraw(const StepTry& attempt, StepEnd end);
  std::optional<ActionFeedback> heard() const;
  bool isOrphaned() const;
  StepEnd treat(const StepTry& attempt, const ActionFeedback& feedback) const;
  void cancel(const ActionDispatch& step);

  ros::Publisher dispatches_;
  DispatchListeners& listeners_;
  any_message::WaitPoint& wait_;
  mutable std::mutex mutex_;  // guards all below
  const ActionDispatch* expected_ = nullptr;
  std::optional<ActionFeedback> last_;  // about the expected one
  std::string performer_;               // the node that said so
  /// Steps, with their plans, of whose tries nobody said that they have ended: of the next try of
  /// such a step an end counts only when it was taken up.
  std::map<int, int> unfinished_;
  std::set<int> warned_about_;  // plans of which somebody told about others
  ros::Subscriber feedback_;
};

/// StepKind::Simulated: time passes and frames move. Broadcasts all frames, also between plans.
class SimulatedSteps : public StepRunner {
 public:
  SimulatedSteps(const ros::NodeHandle& node, any_message::WaitPoint& wait);
  StepEnd run(const StepTry& attempt) override;

  /// A run of plans begins: the same seed, the same failures.
  void begin(const StepMapping& mapping, const ExecutorOptions& options);

 private:
  bool fails(const StepTry& attempt);
  std::vector<SimulatedFrames::Motion> motionsOf(const StepTry& attempt) const;
  void broadcast();

  any_message::WaitPoint& wait_;
  RandomSource random_{0};
  std::map<GroundName, int> failures_;  // how many more tries fail
  SimulatedFrames stage_;
  std::mutex mutex_;  // guards the two below
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Time last_stamp_;
  ros::WallTimer timer_;
};

}  // namespace goal_alignment::execution
