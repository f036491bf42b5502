// SPDX-License-Identifier: BSD-3-Clause
#include "startup_report.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <exception>

#include "align_goal_reader.h"
#include "fact_file.h"
#include "goal_alignment/AlignResult.h"
#include "goal_alignment/AlignmentState.h"

namespace goal_alignment::aligner {
namespace {

// Other nodes need some time to find one that was restarted.
constexpr double kPeriod = 1;  // seconds
constexpr int kMaxPeriods = 10;

std::string lostTask(const TaskNotes::Task& task, const char* what_it_did) {
  return fmt::format("the aligner was restarted while the task {}{}{}{}: send it again to continue",
                     task.task_id, task.task_id.empty() ? "" : " ",
                     task.person.empty() ? "" : "of " + task.person + " ", what_it_did);
}

}  // namespace

// The rules of tf and the facts that were kept count from now on, so that ~get_facts knows them.
StartupReport::StartupReport(const ros::NodeHandle& private_node, const Dependencies& parts)
    : parts_(parts) {
  try {
    const NodeOptions options = NodeOptions::read(private_node);
    restoreFacts(options);
    if (options.journal_expiry > 0) reportLostTasks();
    parts_.tf.follow(rulesOf(options.tf_facts));
  } catch (const ros_common::ParameterError& error) {
    ROS_ERROR("%s", error.what());
  } catch (const GoalError& error) {
    ROS_ERROR("%s", error.what());
  }
  if (lines_.empty()) return;
  timer_ = private_node.createWallTimer(ros::WallDuration(kPeriod),
                                        [this](const ros::WallTimerEvent&) { publishWhenHeard(); });
}

// If the models can't be read yet, the next task whose models come from parameters does it.
void StartupReport::restoreFacts(const NodeOptions& options) {
  try {
    const FactScope scope = FactScope::of(parameterModels(options), options.world);
    const std::string line = parts_.facts.follow(scope, options.facts_expiry);
    if (!line.empty()) lines_.push_back(line);
  } catch (const std::exception& error) {
    ROS_DEBUG("no facts are restored yet: %s", error.what());
  }
}

// Who sent it as an action's goal sees that it is lost, as the new server does not know it.
void StartupReport::reportLostTasks() {
  const TaskNotes::Tasks lost = parts_.task_notes.takeLost();
  if (lost.running) {
    AlignmentState state;
    state.phase = AlignmentState::DONE;
    state.session_id = lost.running->session_id;
    state.task_id = lost.running->task_id;
    state.person = lost.running->person;
    state.outcome = AlignResult::CANCELED;
    state.message = lostTask(*lost.running, "was under way");
    parts_.announcer.publish(state);
    lines_.push_back(state.message);
  }
  for (const TaskNotes::Task& task : lost.waiting)
    lines_.push_back(lostTask(task, "waited"));
}

void StartupReport::publishWhenHeard() {
  if (!parts_.announcer.isHeard() && ++periods_waited_ < kMaxPeriods) return;
  timer_.stop();
  for (const std::string& line : lines_)
    parts_.announcer.tell(line);
}

}  // namespace goal_alignment::aligner
