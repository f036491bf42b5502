// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/task_story.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>
#include <utility>
#include <vector>

#include "goal_alignment/ros_interface/message_conversion.h"

namespace goal_alignment::ros_interface {
namespace {

std::string joined(const std::vector<Fluent>& fluents, const phrasing::Phrases& phrases) {
  std::string text;
  for (const Fluent& fluent : fluents) {
    const std::string clause =
        fluent.text.empty() ? phrases.clause(toLiteral(fluent)) : fluent.text;
    text += (text.empty() ? "" : "; ") + clause;
  }
  return text;
}

bool sameFluent(const Fluent& a, const Fluent& b) {
  return a.name == b.name && a.args == b.args && a.negated == b.negated;
}

const char* answerWord(std::uint8_t state) {
  switch (state) {
    case Candidate::WANTED:
      return "yes";
    case Candidate::NOT_WANTED:
      return "no";
    case Candidate::UNSURE:
      return "don't know";
    default:
      return nullptr;
  }
}

}  // namespace

TaskStory::TaskStory(std::ostream& out, phrasing::Phrases phrases, bool tell_questions)
    : out_(out), phrases_(std::move(phrases)), tell_questions_(tell_questions) {}

void TaskStory::begin(const HumanTask& task) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!task.person.empty()) person_ = task.person;
  had_plan_ = !task.plan.empty();
  fmt::print(out_, "The task, from {}: {}.\n", person_,
             task.goal.empty() ? "the goal of the problem files" : joined(task.goal, phrases_));
  fmt::print(out_, "The plan that {} has in mind{}\n", person_, had_plan_ ? ":" : ": none.");
  for (std::size_t i = 0; i < task.plan.size(); ++i) {
    fmt::print(out_, "  {:2}. {}\n", i + 1, phrases_.action(toAction(task.plan[i])));
  }
  out_ << std::flush;
}

void TaskStory::hear(const AlignFeedback& feedback) {
  const Question& question = feedback.question;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (question.question_id == 0 || question.question_id == last_id_) return;
  last_id_ = question.question_id;
  session_ = question.session_id;
  questions_.push_back(question);
  tellDialogue();
}

void TaskStory::hear(const AlignmentState& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_ = state;
  tellDialogue();
}

void TaskStory::hear(const AlignResult& result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  // The last state may still be on its way; the result has the answers, too.
  session_ = result.session_id;
  if (state_.session_id != session_) state_ = AlignmentState{};
  state_.session_id = session_;
  state_.candidates = result.candidates;
  tellDialogue();
  if (result.outcome == AlignResult::SUCCESS) {
    tellPlan(result.plan);
  } else {
    tellFailure(result);
  }
  out_ << std::flush;
}

void TaskStory::tellDialogue() {
  if (session_.empty() || state_.session_id != session_) return;
  tellBreak();
  while (!questions_.empty()) {
    if (!told_question_) tellQuestion(questions_.front());
    told_question_ = true;
    if (!tellAnswer(questions_.front())) return;
    questions_.pop_front();
    told_question_ = false;
  }
}

void TaskStory::tellBreak() {
  if (told_break_) return;
  told_break_ = true;
  if (!state_.human_plan_break.empty()) {
    fmt::print(out_, "\nWhere this plan breaks for the robot: {}\n", state_.human_plan_break);
  }
}

void TaskStory::tellQuestion(const Question& question) {
  if (!tell_questions_) return;
  fmt::print(out_, "\nThe robot asks: {}\n", question.text);
  if (!question.why.empty()) fmt::print(out_, "  Its reason: {}\n", question.why);
  out_ << std::flush;
}

// False while a fluent of the question is not answered.
bool TaskStory::tellAnswer(const Question& question) {
  std::vector<std::string> answers;
  for (const Fluent& fluent : question.fluents) {
    const auto candidate =
        std::find_if(state_.candidates.begin(), state_.candidates.end(),
                     [&](const Candidate& c) { return sameFluent(c.fluent, fluent); });
    if (candidate == state_.candidates.end()) return false;
    const char* word = answerWord(candidate->state);
    if (word == nullptr) return false;
    const bool group = question.fluents.size() > 1;
    answers.push_back(group ? fmt::format("{}: {}", fluent.text, word) : word);
  }
  for (const std::string& answer : answers) {
    fmt::print(out_, "  {} answers: {}.\n", person_, answer);
  }
  out_ << std::flush;
  return true;
}

void TaskStory::tellPlan(const Plan& plan) {
  fmt::print(out_, "\nThe robot has a plan of {} steps.\n", plan.steps.size());
  if (!plan.not_wanted.empty()) {
    fmt::print(out_, "What need not be: {}.\n", joined(plan.not_wanted, phrases_));
  }
}

void TaskStory::tellFailure(const AlignResult& result) {
  // "There is no plan" is said only where that is proven.
  const bool proven = result.outcome == AlignResult::GOAL_UNSOLVABLE ||
                      result.outcome == AlignResult::EXPECTATION_UNACHIEVABLE;
  fmt::print(out_, "\n{} (outcome {}): {}.\n",
             proven ? "There is no plan" : "The robot does not act", result.outcome,
             result.message);
  for (const AlternativeGoal& alternative : result.alternatives) {
    fmt::print(out_, "  It could be done without this: {}.\n",
               joined(alternative.given_up, phrases_));
  }
}

std::string TaskStory::stepText(const ActionDispatch& step) const {
  GroundName action;
  action.name = step.name;
  for (const auto& parameter : step.parameters)
    action.arguments.push_back(parameter.value);
  return phrases_.action(action);
}

void TaskStory::hearStep(const Plan& plan, std::size_t index) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (; told_steps_ <= index && told_steps_ < plan.steps.size(); ++told_steps_) {
    fmt::print(out_, "  step {} of {}: {}\n", told_steps_ + 1, plan.steps.size(),
               stepText(plan.steps[told_steps_]));
  }
  out_ << std::flush;
}

void TaskStory::hearEnd(const Plan& plan, const ExecutePlanResult& result) {
  const bool done = result.outcome == ExecutePlanResult::SUCCESS;
  if (done && !plan.steps.empty()) hearStep(plan, plan.steps.size() - 1);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!done) {
    fmt::print(out_, "\nThe plan was not carried out (outcome {}): {}\n", result.outcome,
               result.reason);
  } else {
    fmt::print(out_, "\nGuaranteed: {}.\n", joined(plan.guaranteed, phrases_));
  }
  out_ << std::flush;
}

}  // namespace goal_alignment::ros_interface
