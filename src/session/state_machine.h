// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis.h"
#include "decision.h"
#include "dialogue.h"
#include "goal_alignment/session/session.h"
#include "thinking_budget.h"

namespace goal_alignment::session {

/// Where a session stands, and what leads from one state to the next. What is thought in between is
/// done by its parts: the analysis grows in the first phases, decide() says what follows from it
/// and the dialogue, and that is applied here.
class Session::StateMachine {
 public:
  explicit StateMachine(Options options);

  void begin(Input input);
  State step();
  SubmitResult answer(const std::vector<Literal>& fluents, AnswerKind kind,
                      const std::string& answered_by, bool revising);
  void setRobotState(const std::vector<GroundName>& atoms);
  void resume(const Options& options);
  void finish(OutcomeCode code, std::string message);

  State state() const { return state_; }
  Snapshot snapshot() const;
  const std::optional<QuestionView>& question() const { return question_; }
  const Outcome& outcome() const { return outcome_; }
  const Options& options() const { return options_; }
  const Dialogue& dialogue() const { return dialogue_; }
  Analysis& analysis() { return *analysis_; }
  ThinkingBudget& budget() { return budget_; }

 private:
  /// Each is one step(); the last one repeats.
  enum class Phase { Read, Ground, Check, Believe, FindConflicts, Decide };

  void run(Phase phase);
  void read();
  void decide();
  void apply(const Decision& decision);
  void ask(const Ask& question);
  void conclude(const PlanFor& decision);
  void conclude(const NoPlan& decision);
  void finish(Outcome outcome);
  void resumeAt(Phase phase);
  Phase nextPhase() const;
  static double Statistics::*timeOf(Phase phase);

  Options options_;
  ThinkingBudget budget_;
  State state_ = State::Idle;
  Phase phase_ = Phase::Read;
  Input input_;
  std::unique_ptr<Analysis> analysis_;  // never null; a new one for each task
  Dialogue dialogue_;
  std::optional<QuestionView> question_;
  Outcome outcome_;
  std::size_t asked_before_ = 0;  // questions that do not count against max_questions
  bool ends_unsure_ = false;      // as soon as it is known what the person could choose
};

}  // namespace goal_alignment::session
