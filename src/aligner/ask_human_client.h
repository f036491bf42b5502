// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <memory>
#include <string>

#include "goal_alignment/Answer.h"
#include "goal_alignment/Question.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::aligner {

/// Puts the open question to whoever offers `ask_human`. roscpp's service calls have no time-out
/// and a person may never answer, so the calls run on a thread of their own, one at a time. A call
/// for a question that is over is abandoned: its answer will be refused as stale, and until it
/// returns newer questions go out on ~question only. An answer to an earlier put of a question that
/// is open still counts. Waits for a dialogue node that is not there,
/// and asks again when one died or left the question unanswered, as long as the question is open.
class AskHumanClient {
 public:
  /// Takes an answer; called on the client's thread.
  using Deliver = std::function<session::SubmitResult(const Answer::Request&)>;
  /// Is told of what went wrong; called on the client's thread.
  using ErrorCallback = std::function<void(const std::string&)>;

  AskHumanClient(ros::NodeHandle node, Deliver deliver, ErrorCallback complain);
  /// After ros::shutdown(), which ends a call under way.
  ~AskHumanClient();
  AskHumanClient(const AskHumanClient&) = delete;
  AskHumanClient& operator=(const AskHumanClient&) = delete;

  /// Asks as soon as no call is outstanding. Never blocks.
  void ask(const Question& question);
  /// The question is over.
  void withdraw();

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;  // outlives this object while a call does
};

}  // namespace goal_alignment::aligner
