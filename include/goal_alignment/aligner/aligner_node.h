// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <string>
#include <vector>

#include "goal_alignment/Answer.h"
#include "goal_alignment/Explain.h"
#include "goal_alignment/GetFacts.h"
#include "goal_alignment/GetState.h"
#include "goal_alignment/HumanTask.h"
#include "goal_alignment/SetFacts.h"
#include "goal_alignment/Validate.h"
#include "goal_alignment/aligner/align_server.h"
#include "goal_alignment/aligner/alignment_runner.h"
#include "goal_alignment/aligner/announcer.h"
#include "goal_alignment/aligner/ask_human_client.h"
#include "goal_alignment/aligner/diagnostics.h"
#include "goal_alignment/aligner/explainer.h"
#include "goal_alignment/aligner/journal.h"
#include "goal_alignment/aligner/marker_publisher.h"
#include "goal_alignment/aligner/parameter_models.h"
#include "goal_alignment/aligner/plan_watch.h"
#include "goal_alignment/aligner/question_bridge.h"
#include "goal_alignment/aligner/robot_facts.h"
#include "goal_alignment/aligner/task_intake.h"
#include "goal_alignment/aligner/tf_state_bridge.h"
#include "goal_alignment/aligner/under_way.h"

namespace goal_alignment::aligner {

/// goal_alignment_node: puts the parts together and offers the services. No callback runs a solver;
/// what takes longer than a look-up has callback queues of its own, so that answers and cancels
/// never wait behind it.
class AlignerNode {
 public:
  AlignerNode(ros::NodeHandle node, ros::NodeHandle private_node);

  /// The last words: every goal gets its result.
  void endGoals() { align_.endGoals(); }

 private:
  AlignGoal goalFor(const HumanTask& task) const;
  void hearExecutor(const actionlib_msgs::GoalStatusArray::ConstPtr& goals);
  bool refusesIfBusy() const;
  void noteWaiting(const std::vector<WaitingTask>& tasks);
  bool answer(Answer::Request& request, Answer::Response& response);
  bool reviseAnswer(Answer::Request& request, Answer::Response& response);
  bool getState(GetState::Request& request, GetState::Response& response);
  bool validate(Validate::Request& request, Validate::Response& response);
  bool explain(Explain::Request& request, Explain::Response& response);
  bool forget(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool setFacts(SetFacts::Request& request, SetFacts::Response& response);
  bool setHumanFacts(SetFacts::Request& request, SetFacts::Response& response);
  bool forgetFacts(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool getFacts(GetFacts::Request& request, GetFacts::Response& response);
  session::SubmitResult submit(const Answer::Request& request);
  void checkParameters();
  void takeUpKeptFacts(const NodeOptions& options);
  void tellOfLostTask();
  void tellNews();
  void wakeUpSolver();

  template <typename Service>
  ros::ServiceServer advertise(const char* name, ros::CallbackQueue& queue,
                               bool (AlignerNode::*method)(typename Service::Request&,
                                                           typename Service::Response&));

  ros::NodeHandle private_node_;
  Announcer announcer_;
  Journal journal_;
  Diagnostics diagnostics_;
  tf2_ros::Buffer frames_;
  tf2_ros::TransformListener frame_listener_;
  MarkerPublisher markers_;
  FactFile fact_file_;
  RobotFacts facts_;
  ParameterModels models_;
  UnderWay under_way_;
  TfStateBridge tf_;
  Explainer explainer_;
  QuestionBridge bridge_;
  AskHumanClient ask_human_;
  PlanWatch plan_watch_;
  AlignmentRunner runner_;
  AlignServer align_;
  TaskIntake tasks_;

  ros::Subscriber executor_;
  ros::ServiceServer answer_service_;
  ros::ServiceServer revise_service_;
  ros::ServiceServer state_service_;
  ros::ServiceServer forget_service_;
  ros::ServiceServer set_facts_service_;

  ros::CallbackQueue validate_callbacks_;
  ros::CallbackQueue explain_callbacks_;
  ros::CallbackQueue facts_callbacks_;
  ros::ServiceServer validate_service_;
  ros::ServiceServer explain_service_;
  ros::ServiceServer set_human_facts_service_;
  ros::ServiceServer forget_facts_service_;
  ros::ServiceServer get_facts_service_;
  ros::AsyncSpinner validate_spinner_;
  ros::AsyncSpinner explain_spinner_;
  ros::AsyncSpinner facts_spinner_;

  std::vector<std::string> news_;  // of the start, told once others have had time to listen
  int news_waited_ = 0;
  ros::WallTimer news_timer_;
};

}  // namespace goal_alignment::aligner
