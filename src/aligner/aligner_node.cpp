// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/aligner/aligner_node.h"

#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/console.h>
#include <ros/subscriber.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <string>
#include <utility>
#include <vector>

#include "align_server.h"
#include "alignment_runner.h"
#include "announcer.h"
#include "answer_services.h"
#include "ask_human_client.h"
#include "diagnostics.h"
#include "explainer.h"
#include "fact_file.h"
#include "fact_services.h"
#include "goal_alignment/HumanTask.h"
#include "goal_alignment/ros_common/names.h"
#include "goal_alignment/ros_common/package_files.h"
#include "journal.h"
#include "marker_publisher.h"
#include "node_options.h"
#include "parameter_models.h"
#include "plan_watch.h"
#include "query_services.h"
#include "question_bridge.h"
#include "robot_facts.h"
#include "startup_report.h"
#include "task_intake.h"
#include "task_notes.h"
#include "tf_state_bridge.h"

namespace goal_alignment::aligner {
namespace {

constexpr std::uint32_t kStatusQueueSize = 100;  // a goal may end within the message after it began

std::string stateFolder() {
  return ros_common::rosHome() + "/" + ros_common::kStateFolder;
}

QuestionIds questionIds() {
  QuestionIds ids(stateFolder() + "/question_id");
  if (!ids.lastError().empty()) {
    ROS_WARN("question ids may repeat after a restart: %s", ids.lastError().c_str());
  }
  return ids;
}

std::vector<JournalAnswer> toJournal(const std::vector<AcceptedAnswer>& answers) {
  std::vector<JournalAnswer> entries;
  for (const AcceptedAnswer& answer : answers) {
    if (answer.kind == session::AnswerKind::Decline) continue;
    for (const Literal& fluent : answer.fluents)
      entries.push_back({fluent, answer.kind, answer.answered_by, answer.at});
  }
  return entries;
}

void logWarning(const std::string& line) {
  ROS_WARN("%s", line.c_str());
}

AlignGoal goalFor(const HumanTask& task) {
  AlignGoal goal;
  goal.task = task;
  goal.source = AlignGoal::PARAMS;
  goal.max_questions = -1;
  goal.unsure_policy = AlignGoal::KEEP;
  return goal;
}

// What is kept on disk across restarts, and tf: all that tells what is true in the robot's world.
struct RobotWorld {
  RobotWorld(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
      : frame_listener(frames, node),
        fact_file(stateFolder() + "/facts", private_node.getNamespace(), logWarning),
        facts(&fact_file),
        models(private_node),
        tf(frames) {}

  tf2_ros::Buffer frames;
  tf2_ros::TransformListener frame_listener;
  FactFile fact_file;
  RobotFacts facts;
  ParameterModels models;
  TfStateBridge tf;
};

}  // namespace

class AlignerNode::Implementation {
 public:
  Implementation(ros::NodeHandle node, const ros::NodeHandle& private_node);

  void endGoals() { align_.endGoals(); }

 private:
  bool refusesIfBusy() const;
  void noteWaiting(const std::vector<WaitingTask>& tasks);
  void wakeUpSolver();
  void onExecutorStatus(const actionlib_msgs::GoalStatusArray::ConstPtr& goals);

  const ros::NodeHandle private_node_;
  Announcer announcer_;
  Journal journal_;
  TaskNotes task_notes_;
  Diagnostics diagnostics_;
  RobotWorld world_;
  MarkerPublisher markers_;
  Explainer explainer_;
  QuestionBridge bridge_;
  AskHumanClient ask_human_;
  PlanWatch plan_watch_;
  AlignmentRunner runner_;
  AlignServer align_;
  TaskIntake tasks_;
  ros::Subscriber executor_status_;
  AnswerServices answer_services_;
  FactServices fact_services_;
  QueryServices query_services_;
  StartupReport startup_;
};

AlignerNode::Implementation::Implementation(ros::NodeHandle node,
                                            const ros::NodeHandle& private_node)
    : private_node_(private_node),
      announcer_(private_node),
      journal_(stateFolder() + "/journal", logWarning),
      task_notes_(stateFolder() + "/under_way", private_node.getNamespace(), logWarning),
      diagnostics_(node, private_node, announcer_, journal_),
      world_(node, private_node),
      markers_(private_node, announcer_, world_.frames),
      explainer_([this] { wakeUpSolver(); }),
      bridge_(questionIds(),
              [this](const std::string& session_id, const std::vector<AcceptedAnswer>& answers) {
                journal_.add(session_id, toJournal(answers));
              }),
      ask_human_(
          node,
          [this](const Answer::Request& request) {
            return submitAnswer(request, bridge_, diagnostics_);
          },
          [this](const std::string& line) { announcer_.tell(line); }),
      runner_(private_node, {announcer_, bridge_, ask_human_, journal_, world_.facts, task_notes_,
                             world_.tf, explainer_, plan_watch_}),
      align_(
          private_node, runner_, announcer_, plan_watch_, [this] { return refusesIfBusy(); },
          [this](const std::vector<WaitingTask>& tasks) { noteWaiting(tasks); }),
      tasks_(node, stateFolder(), align_, announcer_, goalFor),
      executor_status_(node.subscribe(ros_common::kExecutorStatusTopic, kStatusQueueSize,
                                      &Implementation::onExecutorStatus, this)),
      answer_services_(private_node, {announcer_, journal_, diagnostics_, bridge_, align_}),
      fact_services_(private_node, {world_.facts, world_.tf, world_.models, bridge_}),
      query_services_(private_node, explainer_),
      startup_(private_node, {announcer_, world_.facts, world_.tf, task_notes_}) {
  query_services_.start();
  fact_services_.start();
}

// It waits for an answer, or for a goal, or works and will look later.
void AlignerNode::Implementation::wakeUpSolver() {
  bridge_.wakeUp();
  align_.wakeUp();
}

void AlignerNode::Implementation::onExecutorStatus(
    const actionlib_msgs::GoalStatusArray::ConstPtr& goals) {
  plan_watch_.onExecutorStatus(goals->status_list);
  align_.onExecutorStatus();
}

// With journal_expiry 0 nothing is kept on disk, as for the running task. Reads that one parameter,
// not all of NodeOptions, since the queue is locked meanwhile.
void AlignerNode::Implementation::noteWaiting(const std::vector<WaitingTask>& tasks) {
  double journal_expiry = NodeOptions().journal_expiry;
  private_node_.getParam("journal_expiry", journal_expiry);
  std::vector<TaskNotes::Task> waiting;
  if (journal_expiry > 0) {
    for (const WaitingTask& task : tasks)
      waiting.push_back({"", task.task_id, task.person});
  }
  task_notes_.setWaiting(std::move(waiting));
}

bool AlignerNode::Implementation::refusesIfBusy() const {
  try {
    return NodeOptions::read(private_node_).busy_policy == BusyPolicy::Refuse;
  } catch (const ros_common::ParameterError&) {
    return false;  // the goal is refused for it when its turn comes, and then says so
  }
}

AlignerNode::AlignerNode(ros::NodeHandle node, ros::NodeHandle private_node)
    : implementation_(std::make_unique<Implementation>(std::move(node), private_node)) {}

AlignerNode::~AlignerNode() = default;

void AlignerNode::endGoals() {
  implementation_->endGoals();
}

}  // namespace goal_alignment::aligner
