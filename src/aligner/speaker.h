// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "explanation.h"
#include "goal_alignment/ros_common/message_conversion.h"

namespace goal_alignment::aligner {

/// Speaks of one task, sentence after sentence, and notes the conflicts that they rest on.
class Speaker {
 public:
  const Explain::Response& response() const { return response_; }

 protected:
  explicit Speaker(const ExplanationContext& explained) : explained_(explained) {
    response_.known = true;
  }

  const session::Snapshot& snapshot() const { return explained_.snapshot; }
  bool hasEnded() const { return snapshot().state == session::State::Done; }

  static bool contains(const std::vector<Literal>& fluents, const Literal& fluent) {
    return std::find(fluents.begin(), fluents.end(), fluent) != fluents.end();
  }

  bool modelsAreRead() const {
    return !snapshot().candidates.empty() || !snapshot().specified.empty() ||
           !snapshot().condition.empty();
  }

  const phrasing::Phrases& phrases() const { return explained_.phrases; }
  std::string that(const Literal& fluent) const { return phrases().that(fluent); }

  void add(const std::string& sentence) {
    response_.text += (response_.text.empty() ? "" : " ") + sentence;
  }
  /// What the phrases call so.
  void say(const std::string& name, const std::vector<std::string>& arguments = {}) {
    add(phrases().say(name, arguments));
  }

  void admitIgnorance() {
    response_.known = false;
    say("explain_unknown");
  }

  /// Each conflict is told once.
  void restOn(const session::ConflictView& conflict) {
    if (!said_.insert(&conflict).second) return;
    add(phrases().reason(conflict.fluents, conflict.proven, conflict.alone));
    note(conflict);
  }

  void note(const session::ConflictView& conflict) {
    response_.conflicts.push_back(ros_common::toMessage(conflict, phrases()));
  }

  /// What was said of it, or is assumed; false: nothing.
  bool speakOfAnswer(const session::CandidateView& candidate) {
    const std::string name = nameOfAnswer(candidate);
    if (name.empty()) return false;
    const bool by_whom = !candidate.assumed && !candidate.answered_by.empty();
    if (by_whom) {
      say(name + "_by", {that(candidate.fluent), candidate.answered_by});
    } else {
      say(name, {that(candidate.fluent)});
    }
    return true;
  }

  const ExplanationContext& explained_;

 private:
  static std::string nameOfAnswer(const session::CandidateView& candidate) {
    using State = session::CandidateState;
    if (candidate.assumed)
      return candidate.state == State::NotWanted ? "explain_assumed_no" : "explain_assumed_yes";
    switch (candidate.state) {
      case State::Wanted:
        return "explain_yes";
      case State::NotWanted:
        return "explain_no";
      case State::Unsure:
        return "explain_unsure";
      default:
        return "";
    }
  }

  Explain::Response response_;
  std::set<const session::ConflictView*> said_;
};

}  // namespace goal_alignment::aligner
