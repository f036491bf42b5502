// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <iosfwd>
#include <mutex>
#include <string>
#include <vector>

#include "goal_alignment/AlignResult.h"
#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/AlternativeGoal.h"
#include "goal_alignment/ExecutePlanResult.h"
#include "goal_alignment/HumanTask.h"
#include "goal_alignment/Plan.h"
#include "goal_alignment/Question.h"
#include "goal_alignment/phrasing/phrases.h"

namespace goal_alignment::nodes {

/// Tells one alignment in plain words, in its right order although its messages come on several
/// topics: the task, where the person's plan breaks for the robot, each question with its reason
/// and then its answer, the outcome, the alternative that is taken up, the steps, and what is
/// guaranteed. Thread-safe.
class DemoNarrator {
 public:
  /// `tell_questions` false: a dialogue in the same terminal shows them.
  DemoNarrator(std::ostream& out, phrasing::Phrases phrases, bool tell_questions = true);

  void begin(const HumanTask& task);
  void hear(const Question& question);
  void hear(const AlignmentState& state);
  /// Whether the state and the questions that belong to the result were heard. They come on other
  /// topics, perhaps later than the result.
  bool hasHeardAllOf(const AlignResult& result);
  void hear(const AlignResult& result);
  /// After a result without a plan the person settles for this; another result will follow.
  void takeUp(const AlternativeGoal& alternative);
  /// After a result without a plan it is left to somebody else what to settle for.
  void awaitChoice();
  /// After a result without a plan the person wants none of the alternatives.
  void leaveIt();
  void hearStep(const Plan& plan, std::size_t index);
  /// Why the plan under way is given up for another.
  void hearTrouble(const std::string& reason);
  void hearNewPlan(const Plan& plan);
  void hearEnd(const Plan& plan, const ExecutePlanResult& result);

 private:
  // All below need mutex_.
  void forgetDialogue();
  void resume();
  std::string joined(const std::vector<Fluent>& fluents) const;
  /// What the phrases call so, as a line.
  void tell(const std::string& name, const std::vector<std::string>& arguments = {});
  void tellBelow(const std::string& name, const std::vector<std::string>& arguments);
  void tellBreak();
  void tellDialogue();
  void tellQuestion(const Question& question);
  bool isOver(const Question& question) const;
  bool isLaterAsked() const;
  void tellAnswer(const Question& question);
  void tellOtherAnswers();
  const Candidate* candidateOf(const Fluent& fluent) const;
  const char* answerTo(const Fluent& fluent) const;
  void tellPlan(const Plan& plan);
  std::string foundText(const Plan& plan) const;
  std::string extraText(const Plan& plan) const;
  void tellFailure(const AlignResult& result);
  std::string stepText(const ActionDispatch& step) const;

  std::mutex mutex_;
  std::ostream& out_;
  phrasing::Phrases phrases_;
  bool tell_questions_;
  std::string person_;
  std::string session_;  // known from the first question or the result
  AlignmentState state_;
  bool told_break_ = false;
  bool had_plan_ = false;
  bool told_question_ = false;  // the first of questions_
  bool has_ended_ = false;
  std::deque<Question> questions_;
  std::vector<Fluent> asked_about_;    // in all questions of the session
  std::uint32_t heard_questions_ = 0;  // since the last end
  std::uint32_t last_id_ = 0;
  std::size_t told_steps_ = 0;
};

}  // namespace goal_alignment::nodes
