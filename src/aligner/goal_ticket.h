// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/action_server.h>

#include <atomic>
#include <mutex>
#include <string>

#include "goal_alignment/AlignAction.h"

namespace goal_alignment::aligner {

/// Equal for goals that ask for the same on behalf of the same person, whenever they do; empty
/// where a session is to go on.
std::string identityOf(const AlignGoal& goal);

/// One goal on its way through the node. It ends once: whoever claims it first, the solver thread
/// with an outcome or a callback with a cancel, says how. A ticket that nobody holds any more and
/// whose result was not sent ends as INTERNAL, so that no client waits for ever. Thread-safe.
class GoalTicket {
 public:
  using Handle = actionlib::ServerGoalHandle<AlignAction>;

  explicit GoalTicket(Handle handle);
  ~GoalTicket();
  GoalTicket(const GoalTicket&) = delete;
  GoalTicket& operator=(const GoalTicket&) = delete;

  /// As it was sent, but for names that no log or screen could show.
  const AlignGoal& goal() const { return *goal_; }
  const std::string& identity() const { return identity_; }
  bool continuesSession() const { return !goal_->continue_session.empty(); }
  std::string id() const { return handle_.getGoalID().id; }
  bool isFor(const Handle& handle) const { return handle_ == handle; }

  /// A cancel for it came before we could remember it.
  bool cancelOvertookIt() const;

  /// It is being worked on; from now on it can't be rejected, only aborted.
  void accept();
  void publishFeedback(const AlignFeedback& feedback);
  /// What a cancel should report, apart from the outcome.
  void setInterim(const AlignResult& interim);
  AlignResult interim() const;

  /// A newer goal is to take its place.
  void displace() { displaced_ = true; }
  bool isDisplaced() const { return displaced_; }

  bool ended() const { return claimed_; }
  /// True for one caller, who must sendResult().
  bool claim() { return !claimed_.exchange(true); }
  /// Sends the result, with the goal status that its outcome asks for. Only the first one goes out.
  void sendResult(AlignResult result);

 private:
  Handle handle_;
  boost::shared_ptr<const AlignGoal> goal_;
  std::string identity_;
  std::atomic<bool> displaced_{false};
  std::atomic<bool> claimed_{false};
  mutable std::mutex mutex_;  // guards the three below
  bool accepted_ = false;
  bool result_sent_ = false;
  AlignResult interim_;
};

}  // namespace goal_alignment::aligner
