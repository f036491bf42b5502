// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include "goal_alignment/GetFacts.h"
#include "goal_alignment/SetFacts.h"
#include "parameter_models.h"
#include "question_bridge.h"
#include "robot_facts.h"
#include "service_group.h"
#include "tf_state_bridge.h"

namespace goal_alignment::aligner {

/// ~set_facts, and on a thread of their own, as they may read models or files,
/// ~set_human_facts, ~forget_facts and ~get_facts.
class FactServices {
 public:
  /// They outlive the services.
  struct Dependencies {
    RobotFacts& facts;
    TfStateBridge& tf;
    ParameterModels& models;
    QuestionBridge& bridge;
  };

  FactServices(const ros::NodeHandle& private_node, const Dependencies& parts);

  void start() { slow_services_.start(); }

 private:
  void setFacts(const SetFacts::Request& request, SetFacts::Response& response);
  void setHumanFacts(const SetFacts::Request& request, SetFacts::Response& response);
  void forgetFacts(std_srvs::Trigger::Response& response);
  void getFacts(GetFacts::Response& response);

  const Dependencies parts_;
  ServiceGroup services_;
  ServiceGroup slow_services_;
};

}  // namespace goal_alignment::aligner
