// SPDX-License-Identifier: BSD-3-Clause
#include "answer_services.h"

#include "goal_alignment/ros_common/names.h"

namespace goal_alignment::aligner {

AnswerServices::AnswerServices(const ros::NodeHandle& private_node, const Dependencies& parts)
    : parts_(parts), services_(private_node) {
  using std_srvs::Trigger;
  services_.add<Answer>(ros_common::kAnswerService,
                        [this](const Answer::Request& request, Answer::Response& response) {
                          answer(request, response);
                        });
  services_.add<Answer>(ros_common::kReviseAnswerService,
                        [this](const Answer::Request& request, Answer::Response& response) {
                          reviseAnswer(request, response);
                        });
  services_.add<GetState>(
      ros_common::kGetStateService,
      [this](const GetState::Request&, GetState::Response& response) { getState(response); });
  services_.add<Trigger>(
      ros_common::kForgetService,
      [this](const Trigger::Request&, Trigger::Response& response) { forget(response); });
}

void AnswerServices::answer(const Answer::Request& request, Answer::Response& response) {
  const session::SubmitResult receipt = submitAnswer(request, parts_.bridge, parts_.diagnostics);
  response.accepted = receipt.accepted;
  response.message = receipt.message;
}

void AnswerServices::reviseAnswer(const Answer::Request& request, Answer::Response& response) {
  const QuestionBridge::Revision revision = parts_.bridge.revise(request);
  response.accepted = revision.receipt.accepted;
  response.message = revision.receipt.message;
  if (!revision.receipt.accepted) return;
  parts_.diagnostics.countAnswer(request.answered_by);
  if (revision.continue_session.empty()) return;
  // After an outcome it takes a goal of its own to continue the session, which applies the answer.
  AlignGoal goal;
  goal.continue_session = revision.continue_session;
  goal.max_questions = -1;
  goal.unsure_policy = AlignGoal::KEEP;
  parts_.align.submit(goal, ros_common::kReviseAnswerService);
}

void AnswerServices::getState(GetState::Response& response) const {
  // In this order, so that no answer can be missed in between.
  const QuestionBridge::Unshown unshown = parts_.bridge.unshown();
  response.state = parts_.announcer.state();
  unshown.addTo(response.state);
}

void AnswerServices::forget(std_srvs::Trigger::Response& response) {
  response.success = parts_.journal.forget();
  response.message = response.success ? "the answers of the current task are not kept on disk"
                                      : "there is no task to forget";
}

session::SubmitResult submitAnswer(const Answer::Request& request, QuestionBridge& bridge,
                                   Diagnostics& diagnostics) {
  const session::SubmitResult receipt = bridge.submit(request);
  if (receipt.accepted) diagnostics.countAnswer(request.answered_by);
  return receipt;
}

}  // namespace goal_alignment::aligner
