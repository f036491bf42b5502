// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include <memory>

#include "goal_alignment/Answer.h"
#include "goal_alignment/GetState.h"
#include "goal_alignment/HumanTask.h"
#include "goal_alignment/Validate.h"
#include "goal_alignment/ros_interface/align_server.h"
#include "goal_alignment/ros_interface/alignment_runner.h"
#include "goal_alignment/ros_interface/announcer.h"
#include "goal_alignment/ros_interface/ask_human_client.h"
#include "goal_alignment/ros_interface/question_bridge.h"

namespace goal_alignment::ros_interface {

/// goal_alignment_node: puts the parts together and offers the services. No callback runs a solver;
/// what takes longer than a look-up has a callback queue of its own, so that answers and cancels
/// never wait behind it.
class AlignerNode {
 public:
  AlignerNode(ros::NodeHandle node, ros::NodeHandle private_node);

 private:
  void takeTask(const HumanTask::ConstPtr& task);
  bool answer(Answer::Request& request, Answer::Response& response);
  bool reviseAnswer(Answer::Request& request, Answer::Response& response);
  bool getState(GetState::Request& request, GetState::Response& response);
  bool validate(Validate::Request& request, Validate::Response& response);
  void checkParameters() const;

  ros::NodeHandle private_node_;
  Announcer announcer_;
  QuestionBridge bridge_;
  AskHumanClient ask_human_;
  AlignmentRunner runner_;
  AlignServer align_;

  ros::Subscriber tasks_;
  ros::ServiceServer answer_service_;
  ros::ServiceServer revise_service_;
  ros::ServiceServer state_service_;

  ros::CallbackQueue slow_callbacks_;
  ros::ServiceServer validate_service_;
  ros::AsyncSpinner slow_spinner_;
};

}  // namespace goal_alignment::ros_interface
