// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/Fluent.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/session/session.h"
#include "journal.h"
#include "question_bridge.h"
#include "session_record.h"

namespace goal_alignment::aligner {

/// Passes answers to the current session and keeps the journal up to date with what the session
/// has accepted. Belongs to the solver thread.
class SessionAnswers {
 public:
  /// Takes one line for people.
  using Tell = std::function<void(const std::string&)>;

  /// All outlive this.
  SessionAnswers(SessionRecord& current, Journal& journal, Tell tell);

  /// Throws GoalError, which names the field, for what is no candidate of the session.
  std::vector<Literal> candidatesOf(const std::vector<Fluent>& fluents,
                                    const std::string& field) const;
  /// Answers from before the dialogue was interrupted, perhaps by a crash, are not asked for again.
  void restoreFromJournal();
  void apply(const AcceptedAnswer& answer);
  /// What nobody was sure about is asked again when the task is sent again.
  void forgetUnsureAnswers();

 private:
  session::SubmitResult applyToSession(const AcceptedAnswer& answer);
  std::vector<JournalAnswer> journalAnswers() const;
  std::set<Literal> answered() const;

  SessionRecord& current_;
  Journal& journal_;
  const Tell tell_;
};

}  // namespace goal_alignment::aligner
