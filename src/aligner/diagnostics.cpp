// SPDX-License-Identifier: BSD-3-Clause
#include "diagnostics.h"

#include <fmt/format.h>

#include <utility>

#include "goal_alignment/session/outcome.h"

namespace goal_alignment::aligner {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

constexpr double kLongOpen = 300;  // seconds after which somebody should look for the person
constexpr std::size_t kNamedAnswerers = 20;  // a flood of names must not fill the memory
constexpr std::size_t kLongestName = 60;

const char* wordFor(std::uint8_t phase) {
  switch (phase) {
    case AlignmentState::IDLE:
      return "idle";
    case AlignmentState::ANALYSING:
      return "analysing";
    case AlignmentState::AWAITING_ANSWER:
      return "awaiting an answer";
    case AlignmentState::PLANNING:
      return "planning";
    default:
      return "done";
  }
}

}  // namespace

Diagnostics::Diagnostics(ros::NodeHandle node, ros::NodeHandle private_node,
                         const Announcer& announcer, const Journal& journal)
    : announcer_(announcer), journal_(journal), updater_(node, private_node) {
  updater_.setHardwareID("none");
  updater_.add("alignment", this, &Diagnostics::report);
  // Forced, since the updater's own period is one of ROS time, which may stand still.
  timer_ = node.createWallTimer(ros::WallDuration(updater_.getPeriod()),
                                [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void Diagnostics::countAnswer(const std::string& answered_by) {
  const std::string name = answered_by.empty() ? "(unnamed)" : answered_by.substr(0, kLongestName);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (answerers_.size() < kNamedAnswerers || answerers_.count(name) > 0) {
    ++answerers_[name];
  } else {
    ++other_answers_;
  }
}

void Diagnostics::report(DiagnosticStatusWrapper& status) {
  const AlignmentState state = announcer_.state();
  status.summary(DiagnosticStatus::OK, wordFor(state.phase));
  status.add("phase", wordFor(state.phase));
  status.add("session", state.session_id);
  status.add("questions asked", state.questions_asked);
  if (state.phase == AlignmentState::DONE) {
    const auto code = static_cast<session::OutcomeCode>(state.outcome);
    last_outcome_ =
        fmt::format("{} ({}): {}", state.outcome, session::outcomeWord(code), state.message);
    if (code == session::OutcomeCode::Internal) {
      status.mergeSummary(DiagnosticStatus::ERROR, "the last alignment was aborted");
    }
  }
  status.add("last outcome", last_outcome_);
  addQuestion(status);
  addAnswerers(status);
  const std::string last_error = journal_.lastError();
  status.add("journal", last_error.empty() ? "in order" : last_error);
  if (!last_error.empty()) status.mergeSummary(DiagnosticStatus::WARN, "the journal has an error");
}

void Diagnostics::addQuestion(DiagnosticStatusWrapper& status) {
  const Question question = announcer_.question();
  // Put again after silence it has a new id, but it is still the same question to wait for.
  const bool same = question.question_id != 0 && open_.question_id != 0 &&
                    question.session_id == open_.session_id && question.text == open_.text;
  if (!same) open_since_ = Clock::now();
  open_ = question;
  if (question.question_id == 0) {
    status.add("open question", "none");
    return;
  }
  const std::chrono::duration<double> age = Clock::now() - open_since_;
  status.add("open question", fmt::format("{}: {}", question.question_id, question.text));
  status.add("open for (s)", fmt::format("{:.0f}", age.count()));
  if (age.count() > kLongOpen) {
    status.mergeSummary(DiagnosticStatus::WARN, "the open question is not answered");
  }
}

void Diagnostics::addAnswerers(DiagnosticStatusWrapper& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::string text;
  for (const auto& [name, count] : answerers_)
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", name, count);
  if (other_answers_ > 0) text += fmt::format(", others ({})", other_answers_);
  status.add("answerers seen", text.empty() ? "none" : text);
}

}  // namespace goal_alignment::aligner
