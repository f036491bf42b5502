// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/task_story.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>
#include <utility>
#include <vector>

#include "goal_alignment/phrasing/outcomes.h"
#include "goal_alignment/ros_interface/message_conversion.h"
#include "goal_alignment/ros_interface/node_constants.h"

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

bool isIn(const std::vector<Fluent>& fluents, const Fluent& fluent) {
  return std::any_of(fluents.begin(), fluents.end(),
                     [&](const Fluent& other) { return sameFluent(other, fluent); });
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

// By somebody, not assumed.
bool isAnswered(const Candidate& candidate) {
  return answerWord(candidate.state) != nullptr && candidate.answered_by != kAssumed;
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

void TaskStory::hear(const Question& question) {
  const std::lock_guard<std::mutex> lock(mutex_);
  // One that narrows keeps its id.
  if (question.question_id == 0 || question.question_id == last_id_) return;
  last_id_ = question.question_id;
  if (question.session_id != session_) forgetDialogue();
  session_ = question.session_id;
  // Put again after silence it is the same question.
  const bool again = !questions_.empty() && questions_.back().text == question.text &&
                     questions_.back().why == question.why;
  if (!again) {
    questions_.push_back(question);
    ++heard_questions_;
  }
  for (const Fluent& fluent : question.fluents)
    asked_about_.push_back(fluent);
  tellDialogue();
}

// What was heard so far was another's.
void TaskStory::forgetDialogue() {
  questions_.clear();
  asked_about_.clear();
  told_question_ = false;
  heard_questions_ = 0;
}

void TaskStory::hear(const AlignmentState& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_ = state;
  tellDialogue();
}

bool TaskStory::hasHeardAllOf(const AlignResult& result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (result.session_id.empty()) return true;  // refused before there was a session
  if (state_.session_id != result.session_id || state_.phase != AlignmentState::DONE) return false;
  const auto is_explained = [this](const Candidate& candidate) {
    return !isAnswered(candidate) || isIn(asked_about_, candidate.fluent);
  };
  return heard_questions_ >= result.questions &&
         std::all_of(result.candidates.begin(), result.candidates.end(), is_explained);
}

void TaskStory::hear(const AlignResult& result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  // The last state may have been lost; the result has the answers, too.
  if (session_ != result.session_id) forgetDialogue();
  session_ = result.session_id;
  if (state_.session_id != session_) state_ = AlignmentState{};
  state_.session_id = session_;
  state_.candidates = result.candidates;
  has_ended_ = true;
  tellDialogue();
  tellOtherAnswers();
  if (result.outcome == AlignResult::SUCCESS) {
    tellPlan(result.plan);
  } else {
    tellFailure(result);
  }
  out_ << std::flush;
}

void TaskStory::takeUp(const AlternativeGoal& alternative) {
  const std::lock_guard<std::mutex> lock(mutex_);
  fmt::print(out_, "\n{} settles for this: all but that {}.\n", person_,
             joined(alternative.given_up, phrases_));
  out_ << std::flush;
  goOn();
}

void TaskStory::awaitChoice() {
  const std::lock_guard<std::mutex> lock(mutex_);
  out_ << "\nIt goes on when somebody chooses one of the alternatives.\n" << std::flush;
  goOn();
}

void TaskStory::leaveIt() {
  const std::lock_guard<std::mutex> lock(mutex_);
  fmt::print(out_, "\n{} leaves it at that.\n", person_);
  out_ << std::flush;
}

// Another end will be heard, and its questions are counted anew.
void TaskStory::goOn() {
  has_ended_ = false;
  state_.phase = AlignmentState::ANALYSING;
  heard_questions_ = 0;
}

void TaskStory::tellDialogue() {
  if (session_.empty() || state_.session_id != session_) return;
  tellBreak();
  while (!questions_.empty()) {
    if (!told_question_) tellQuestion(questions_.front());
    told_question_ = true;
    if (!isOver(questions_.front())) return;
    tellAnswer(questions_.front());
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

// Answered, or taken back since other answers have made it needless.
bool TaskStory::isOver(const Question& question) const {
  const auto& fluents = question.fluents;
  const auto answered = [this](const Fluent& fluent) { return answerTo(fluent) != nullptr; };
  return has_ended_ || isLaterAsked() || std::all_of(fluents.begin(), fluents.end(), answered);
}

// The next question is open, as far as the state says, so the first of those known is not.
bool TaskStory::isLaterAsked() const {
  if (questions_.size() < 2) return false;
  const auto is_asked = [this](const Fluent& fluent) {
    const Candidate* candidate = candidateOf(fluent);
    return candidate != nullptr && candidate->state == Candidate::ASKED;
  };
  const auto& now = questions_.front().fluents;
  const auto& next = questions_[1].fluents;
  return std::any_of(next.begin(), next.end(), is_asked) &&
         std::none_of(now.begin(), now.end(), is_asked);
}

const Candidate* TaskStory::candidateOf(const Fluent& fluent) const {
  const auto found = std::find_if(state_.candidates.begin(), state_.candidates.end(),
                                  [&](const Candidate& c) { return sameFluent(c.fluent, fluent); });
  return found == state_.candidates.end() ? nullptr : &*found;
}

// Null where there is none.
const char* TaskStory::answerTo(const Fluent& fluent) const {
  const Candidate* candidate = candidateOf(fluent);
  return candidate == nullptr ? nullptr : answerWord(candidate->state);
}

void TaskStory::tellAnswer(const Question& question) {
  // Where a dialogue shows the questions, the next one may stand above this.
  const bool names = question.fluents.size() > 1 || !tell_questions_;
  for (const Fluent& fluent : question.fluents) {
    const char* word = answerTo(fluent);
    const std::string about = names ? fluent.text + ": " : "";
    if (word != nullptr) {
      fmt::print(out_, "  {} answers: {}{}.\n", person_, about, word);
    } else if (!has_ended_) {
      fmt::print(out_, "  {}no answer is needed any more.\n", about);
    }
  }
  out_ << std::flush;
}

// Volunteered, known from a dialogue that was broken off, or the question was lost.
void TaskStory::tellOtherAnswers() {
  for (const Candidate& candidate : state_.candidates) {
    if (!isAnswered(candidate) || isIn(asked_about_, candidate.fluent)) continue;
    asked_about_.push_back(candidate.fluent);
    fmt::print(out_, "  {} has also answered: {}: {}.\n", person_,
               joined({candidate.fluent}, phrases_), answerWord(candidate.state));
  }
}

void TaskStory::tellPlan(const Plan& plan) {
  fmt::print(out_, "\nThe robot has a plan of {} steps.\n", plan.steps.size());
  if (!plan.not_wanted.empty()) {
    fmt::print(out_, "What need not be: {}.\n", joined(plan.not_wanted, phrases_));
  }
  if (!plan.assumed_not_wanted.empty()) {
    fmt::print(out_, "What nobody was asked about, and is not promised: {}.\n",
               joined(plan.assumed_not_wanted, phrases_));
  }
  if (plan.extra_cost > 0) {
    fmt::print(out_, "To keep what nobody asked for costs {} of its {}.\n", plan.extra_cost,
               plan.cost);
  }
}

void TaskStory::tellFailure(const AlignResult& result) {
  // "There is no plan" is said only where that is proven.
  const bool proven = result.outcome == AlignResult::GOAL_UNSOLVABLE ||
                      result.outcome == AlignResult::EXPECTATION_UNACHIEVABLE;
  const bool sentence = !result.message.empty() && result.message.back() == '.';
  fmt::print(out_, "\n{} (outcome {}): {}{}\n",
             proven ? "There is no plan" : "The robot does not act", result.outcome, result.message,
             sentence ? "" : ".");
  // The first ones are in the message.
  for (std::size_t i = phrasing::kSpokenAlternatives; i < result.alternatives.size(); ++i) {
    fmt::print(out_, "  It could be done without this: {}.\n",
               joined(result.alternatives[i].given_up, phrases_));
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

void TaskStory::hearTrouble(const std::string& reason) {
  const std::lock_guard<std::mutex> lock(mutex_);
  fmt::print(out_, "\nSomething went wrong: {}.\n", reason);
  out_ << std::flush;
}

void TaskStory::hearNewPlan(const Plan& plan) {
  const std::lock_guard<std::mutex> lock(mutex_);
  told_steps_ = 0;
  fmt::print(out_, "The robot has a new plan of {} steps, under the same answers:\n",
             plan.steps.size());
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
