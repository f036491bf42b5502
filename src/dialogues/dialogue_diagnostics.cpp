// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/dialogues/dialogue_diagnostics.h"

#include <fmt/format.h>

namespace goal_alignment::dialogues {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

DialogueDiagnostics::DialogueDiagnostics(ros::NodeHandle node, ros::NodeHandle private_node)
    : updater_(node, private_node) {
  updater_.setHardwareID("none");
  updater_.add("dialogue", this, &DialogueDiagnostics::report);
  // Forced, since the updater's own period is one of ROS time, which may stand still.
  timer_ = node.createWallTimer(ros::WallDuration(updater_.getPeriod()),
                                [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void DialogueDiagnostics::report(DiagnosticStatusWrapper& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  status.summary(DiagnosticStatus::OK, open_.empty() ? "no question" : "waiting for a reply");
  if (open_.empty()) {
    status.add("question", "none");
  } else {
    const Open& oldest = open_.begin()->second;
    const std::chrono::duration<double> age = Clock::now() - oldest.since;
    status.add("question", oldest.text);
    status.add("asked for (s)", fmt::format("{:.0f}", age.count()));
  }
  status.add("questions asked", put_);
  status.add("answered", answered_);
  status.add("left unanswered", unanswered_);
  status.add("last answered by", last_answered_by_);
}

DialogueDiagnostics::Turn::Turn(DialogueDiagnostics& diagnostics, const AskHuman::Request& request,
                                const AskHuman::Response& response)
    : diagnostics_(diagnostics), response_(response) {
  const std::lock_guard<std::mutex> lock(diagnostics_.mutex_);
  number_ = ++diagnostics_.put_;
  diagnostics_.open_[number_] = {request.question.text, Clock::now()};
}

DialogueDiagnostics::Turn::~Turn() {
  const std::lock_guard<std::mutex> lock(diagnostics_.mutex_);
  diagnostics_.open_.erase(number_);
  if (response_.answer == AskHuman::Response::NONE) {
    ++diagnostics_.unanswered_;
    return;
  }
  ++diagnostics_.answered_;
  diagnostics_.last_answered_by_ =
      response_.answered_by.empty() ? "(unnamed)" : response_.answered_by;
}

}  // namespace goal_alignment::dialogues
