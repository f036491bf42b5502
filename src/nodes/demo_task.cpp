// SPDX-License-Identifier: BSD-3-Clause
// Sends a task from a YAML file, tells what happens to it, takes up the likeliest alternative where
// there is no plan, and has the plan executed. Exit status 0: a plan was found and carried out.
#include <actionlib/client/simple_action_client.h>
#include <ros/ros.h>

#include <atomic>
#include <csignal>
#include <exception>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <string>

#include "goal_alignment/AlignAction.h"
#include "goal_alignment/ExecutePlanAction.h"
#include "goal_alignment/execution/names.h"
#include "goal_alignment/ros_interface/model_source.h"
#include "goal_alignment/ros_interface/node_constants.h"
#include "goal_alignment/ros_interface/task_file.h"
#include "goal_alignment/ros_interface/task_story.h"
#include "goal_alignment/ros_interface/utf8_log.h"

namespace {

using namespace goal_alignment;  // NOLINT(google-build-using-namespace): a main of one file
using ros_interface::TaskStory;

constexpr double kServerPatience = 60;  // seconds until the other nodes must be there
constexpr double kPollPeriod = 0.02;    // seconds

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int /*signal*/) {
  interrupted = 1;
}

bool goesOn() {
  return ros::ok() && interrupted == 0;
}

template <typename IsThere>
void waitFor(const std::string& name, const IsThere& is_there) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kServerPatience);
  while (!is_there()) {
    if (!goesOn()) throw std::runtime_error("interrupted");
    if (ros::WallTime::now() > end) throw std::runtime_error("nobody offers " + name);
    ros::WallDuration(kPollPeriod).sleep();
  }
}

template <typename Client>
void waitForServer(const Client& client, const std::string& name) {
  waitFor(name, [&client] { return client.isServerConnected(); });
}

// actionlib's clients wait for a simulated clock to begin, deaf to interrupts.
void waitForClock() {
  while (!ros::Time::isValid()) {
    if (!goesOn()) throw std::runtime_error("interrupted");
    ros::WallDuration(kPollPeriod).sleep();
  }
}

// Not waitForResult(), which would not notice an interrupt.
template <typename Client>
void waitForResult(Client& client) {
  while (!client.getState().isDone()) {
    if (!goesOn()) {
      client.cancelGoal();
      ros::WallDuration(kPollPeriod).sleep();  // lets the cancel out
      throw std::runtime_error("interrupted");
    }
    ros::WallDuration(kPollPeriod).sleep();
  }
}

using AlignClient = actionlib::SimpleActionClient<AlignAction>;

AlignResult resultOf(AlignClient& client, TaskStory& story, const AlignGoal& goal) {
  client.sendGoal(goal, {}, {},
                  [&story](const AlignFeedback::ConstPtr& feedback) { story.hear(*feedback); });
  waitForResult(client);
  const auto result = client.getResult();
  if (!result) throw std::runtime_error("the alignment gave no result");
  story.hear(*result);
  return *result;
}

/// Hears how the goals of others end, such as one by which a panel takes up an alternative.
class Plans {
 public:
  explicit Plans(ros::NodeHandle& node)
      : results_(node.subscribe(std::string(ros_interface::kAlignerAlignAction) + "/result", 10,
                                &Plans::hear, this)) {}

  /// Waits until a goal of the session has ended with a plan.
  AlignResult await(const std::string& session_id) const {
    while (goesOn()) {
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (newest_.session_id == session_id) return newest_;
      }
      ros::WallDuration(kPollPeriod).sleep();
    }
    throw std::runtime_error("interrupted");
  }

 private:
  void hear(const AlignActionResult::ConstPtr& end) {
    if (end->result.outcome != AlignResult::SUCCESS) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    newest_ = end->result;
  }

  mutable std::mutex mutex_;
  AlignResult newest_;
  ros::Subscriber results_;
};

// Where not all that is wanted can be had, the likeliest alternative is taken up: the same session,
// nothing is asked again. Unless it `settles` for that, somebody else has to choose.
Plan align(ros::NodeHandle& node, TaskStory& story, const HumanTask& task, bool settles) {
  const Plans plans(node);
  std::atomic<bool> hears{false};
  const boost::function<void(const AlignmentState::ConstPtr&)> hear_state =
      [&](const AlignmentState::ConstPtr& state) {
        story.hear(*state);
        hears = true;
      };
  const ros::Subscriber states =
      node.subscribe<AlignmentState>(ros_interface::kAlignerStateTopic, 100, hear_state);
  AlignClient client(node, ros_interface::kAlignerAlignAction, false);
  waitForServer(client, ros_interface::kAlignerAlignAction);
  // The last one is latched; without the topic a short task would end before any state is heard.
  waitFor(ros_interface::kAlignerStateTopic, [&hears] { return hears.load(); });
  AlignGoal goal;
  goal.task = task;
  goal.source = AlignGoal::PARAMS;
  goal.max_questions = -1;
  AlignResult result = resultOf(client, story, goal);
  while (result.outcome == AlignResult::EXPECTATION_UNACHIEVABLE && !result.alternatives.empty()) {
    if (!settles) {
      story.awaitChoice();
      result = plans.await(result.session_id);
      story.hear(result);
      break;
    }
    const AlternativeGoal& alternative = result.alternatives.front();
    story.takeUp(alternative);
    goal.continue_session = result.session_id;
    goal.revised_not_wanted = alternative.given_up;
    result = resultOf(client, story, goal);
  }
  if (result.outcome != AlignResult::SUCCESS)
    throw std::runtime_error("the task ended without a plan");
  return result.plan;
}

void execute(ros::NodeHandle& node, TaskStory& story, const Plan& plan) {
  using Client = actionlib::SimpleActionClient<ExecutePlanAction>;
  Client client(node, execution::kExecutePlanAction, false);
  waitForServer(client, execution::kExecutePlanAction);
  ExecutePlanGoal goal;
  goal.plan = plan;
  Plan running = plan;
  client.sendGoal(goal, {}, {}, [&](const ExecutePlanFeedback::ConstPtr& feedback) {
    if (!feedback->message.empty()) story.hearTrouble(feedback->message);
    if (feedback->new_plan.plan_id > 0) {
      running = feedback->new_plan;
      story.hearNewPlan(running);
    } else if (feedback->step >= 0) {
      story.hearStep(running, static_cast<std::size_t>(feedback->step));
    }
  });
  waitForResult(client);
  const auto result = client.getResult();
  if (!result) throw std::runtime_error("the executor gave no result");
  story.hearEnd(result->plan.plan_id > 0 ? result->plan : plan, *result);
  if (result->outcome != ExecutePlanResult::SUCCESS) {
    throw std::runtime_error("the plan was not carried out");
  }
}

void run() {
  ros::NodeHandle node;
  const ros::NodeHandle private_node("~");
  std::string file;
  if (!private_node.getParam("task", file))
    throw std::invalid_argument(private_node.resolveName("task") + " is not set");
  const HumanTask task = ros_interface::taskOfFile(file);
  TaskStory story(std::cout,
                  ros_interface::phrasesOf(private_node.param<std::string>("phrases", "")),
                  !private_node.param("interactive", false));
  ros::AsyncSpinner spinner(1);
  spinner.start();
  story.begin(task);
  waitForClock();
  execute(node, story, align(node, story, task, private_node.param("settles", true)));
  spinner.stop();
}

}  // namespace

int main(int argc, char** argv) {
  goal_alignment::ros_interface::logInUtf8();
  ros::init(argc, argv, "demo_task", ros::init_options::NoSigintHandler);
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  try {
    run();
  } catch (const std::exception& error) {
    std::cerr << "demo_task: " << error.what() << std::endl;
    return 1;
  }
}
