// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/aligner_node.h"

#include <ros/advertise_service_options.h>
#include <ros/console.h>

#include "goal_alignment/pddl/model.h"
#include "goal_alignment/ros_interface/node_constants.h"
#include "goal_alignment/ros_interface/node_options.h"
#include "goal_alignment/ros_interface/package_files.h"

namespace goal_alignment::ros_interface {
namespace {

constexpr std::uint32_t kTaskQueueSize = 10;

QuestionIds questionIds() {
  QuestionIds ids(rosHome() + "/" + kStateFolder + "/question_id");
  if (!ids.trouble().empty()) {
    ROS_WARN("question ids may repeat after a restart: %s", ids.trouble().c_str());
  }
  return ids;
}

ros::ServiceServer advertiseValidate(ros::NodeHandle& node, ros::CallbackQueue& queue,
                                     AlignerNode* object,
                                     bool (AlignerNode::*method)(Validate::Request&,
                                                                 Validate::Response&)) {
  ros::AdvertiseServiceOptions options;
  options.init<Validate::Request, Validate::Response>(
      kValidateService, [object, method](Validate::Request& request, Validate::Response& response) {
        return (object->*method)(request, response);
      });
  options.callback_queue = &queue;
  return node.advertiseService(options);
}

}  // namespace

AlignerNode::AlignerNode(ros::NodeHandle node, ros::NodeHandle private_node)
    : private_node_(private_node),
      announcer_(private_node),
      bridge_(questionIds()),
      ask_human_(
          node, [this](const Answer::Request& request) { return bridge_.submit(request); },
          [this](const std::string& complaint) { announcer_.tell(complaint); }),
      runner_(private_node, announcer_, bridge_, ask_human_),
      align_(private_node, runner_),
      tasks_(node.subscribe(kHumanTaskTopic, kTaskQueueSize, &AlignerNode::takeTask, this)),
      answer_service_(private_node.advertiseService(kAnswerService, &AlignerNode::answer, this)),
      revise_service_(
          private_node.advertiseService(kReviseAnswerService, &AlignerNode::reviseAnswer, this)),
      state_service_(private_node.advertiseService(kGetStateService, &AlignerNode::getState, this)),
      validate_service_(
          advertiseValidate(private_node, slow_callbacks_, this, &AlignerNode::validate)),
      slow_spinner_(1, &slow_callbacks_) {
  checkParameters();
  slow_spinner_.start();
}

// A faulty parameter is told at the start, though only the next goal would be refused for it.
void AlignerNode::checkParameters() const {
  try {
    NodeOptions::read(private_node_);
  } catch (const ParameterError& error) {
    ROS_ERROR("%s", error.what());
  }
}

void AlignerNode::takeTask(const HumanTask::ConstPtr& task) {
  AlignGoal goal;
  goal.task = *task;
  goal.source = AlignGoal::PARAMS;
  goal.max_questions = -1;
  try {
    const NodeOptions options = NodeOptions::read(private_node_);
    goal.unsure_policy = static_cast<std::uint8_t>(options.session.unsure_policy);
  } catch (const ParameterError&) {
    // The goal is refused for it, and then says so.
  }
  align_.submit(goal, kHumanTaskTopic);
}

bool AlignerNode::answer(Answer::Request& request, Answer::Response& response) {
  const session::Receipt receipt = bridge_.submit(request);
  response.accepted = receipt.accepted;
  response.message = receipt.message;
  return true;
}

bool AlignerNode::reviseAnswer(Answer::Request& request, Answer::Response& response) {
  const QuestionBridge::Revision revision = bridge_.revise(request);
  response.accepted = revision.receipt.accepted;
  response.message = revision.receipt.message;
  // After an outcome the session goes on with a goal of its own, which takes the answer up.
  if (revision.receipt.accepted && !revision.continue_session.empty()) {
    AlignGoal goal;
    goal.continue_session = revision.continue_session;
    goal.max_questions = -1;
    align_.submit(goal, kReviseAnswerService);
  }
  return true;
}

bool AlignerNode::getState(GetState::Request& /*request*/, GetState::Response& response) {
  response.state = announcer_.state();
  return true;
}

bool AlignerNode::validate(Validate::Request& request, Validate::Response& response) {
  response.errors = pddl::faults({"domain", request.domain}, {"problem", request.problem});
  response.valid = response.errors.empty();
  return true;
}

}  // namespace goal_alignment::ros_interface
