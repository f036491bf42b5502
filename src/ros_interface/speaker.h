// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/ros_interface/explanation.h"
#include "goal_alignment/ros_interface/message_conversion.h"

namespace goal_alignment::ros_interface {

/// Speaks of one task, sentence after sentence, and notes the conflicts that they rest on.
class Speaker {
 public:
  const Explain::Response& response() const { return response_; }

 protected:
  explicit Speaker(const Explained& explained) : explained_(explained) { response_.known = true; }

  const session::Snapshot& snapshot() const { return explained_.snapshot; }
  bool hasEnded() const { return snapshot().state == session::State::Done; }

  static bool contains(const std::vector<Literal>& fluents, const Literal& fluent) {
    return std::find(fluents.begin(), fluents.end(), fluent) != fluents.end();
  }

  bool modelsAreRead() const {
    return !snapshot().candidates.empty() || !snapshot().specified.empty() ||
           !snapshot().condition.empty();
  }

  std::string clause(const Literal& fluent) const { return explained_.phrases.clause(fluent); }

  void say(const std::string& sentence) {
    response_.text += (response_.text.empty() ? "" : " ") + sentence;
  }

  void admitIgnorance() {
    response_.known = false;
    say("Not known yet.");
  }

  /// Each conflict is told once.
  void restOn(const session::ConflictView& conflict) {
    if (!said_.insert(&conflict).second) return;
    say(explained_.phrases.reason(conflict.fluents, conflict.proven));
    note(conflict);
  }

  void note(const session::ConflictView& conflict) {
    response_.conflicts.push_back(toMessage(conflict, explained_.phrases));
  }

  /// What was said of it, or is assumed; false: nothing.
  bool speakOfAnswer(const session::CandidateView& candidate) {
    using State = session::CandidateState;
    const std::string who = candidate.answered_by.empty() ? "" : " by " + candidate.answered_by;
    const std::string what = clause(candidate.fluent);
    if (candidate.assumed) {
      say("Nobody is asked whether it matters that " + what + ": it is assumed " +
          (candidate.state == State::NotWanted ? "not to." : "to."));
    } else if (candidate.state == State::Wanted) {
      say("It matters that " + what + ": answered yes" + who + ".");
    } else if (candidate.state == State::NotWanted) {
      say("It does not matter that " + what + ": answered no" + who + ".");
    } else if (candidate.state == State::Unsure) {
      say("Whether it matters that " + what + " was answered with \"don't know\"" + who + ".");
    } else {
      return false;
    }
    return true;
  }

  const Explained& explained_;

 private:
  Explain::Response response_;
  std::set<const session::ConflictView*> said_;
};

}  // namespace goal_alignment::ros_interface
