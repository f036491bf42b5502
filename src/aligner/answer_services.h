// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include "align_server.h"
#include "announcer.h"
#include "diagnostics.h"
#include "goal_alignment/Answer.h"
#include "goal_alignment/GetState.h"
#include "goal_alignment/session/session.h"
#include "journal.h"
#include "question_bridge.h"
#include "service_group.h"

namespace goal_alignment::aligner {

/// ~answer, ~revise_answer, ~get_state and ~forget. None of them takes long.
class AnswerServices {
 public:
  /// They outlive the services.
  struct Dependencies {
    Announcer& announcer;
    Journal& journal;
    Diagnostics& diagnostics;
    QuestionBridge& bridge;
    AlignServer& align;
  };

  AnswerServices(const ros::NodeHandle& private_node, const Dependencies& parts);

 private:
  void answer(const Answer::Request& request, Answer::Response& response);
  void reviseAnswer(const Answer::Request& request, Answer::Response& response);
  void getState(GetState::Response& response) const;
  void forget(std_srvs::Trigger::Response& response);

  const Dependencies parts_;
  ServiceGroup services_;
};

/// Submits an answer, however it came, and counts it for the diagnostics if it is accepted.
session::SubmitResult submitAnswer(const Answer::Request& request, QuestionBridge& bridge,
                                   Diagnostics& diagnostics);

}  // namespace goal_alignment::aligner
