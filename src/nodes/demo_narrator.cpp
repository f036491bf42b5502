// SPDX-License-Identifier: BSD-3-Clause
#include "demo_narrator.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>
#include <utility>
#include <vector>

#include "goal_alignment/phrasing/outcomes.h"
#include "goal_alignment/ros_common/message_conversion.h"
#include "goal_alignment/ros_common/names.h"

namespace goal_alignment::nodes {
namespace {

bool sameFluent(const Fluent& a, const Fluent& b) {
  return a.name == b.name && a.args == b.args && a.negated == b.negated;
}

bool isIn(const std::vector<Fluent>& fluents, const Fluent& fluent) {
  return std::any_of(fluents.begin(), fluents.end(),
                     [&](const Fluent& other) { return sameFluent(other, fluent); });
}

// Null where there is none.
const char* nameOfAnswer(std::uint8_t state) {
  switch (state) {
    case Candidate::WANTED:
      return "answer_yes";
    case Candidate::NOT_WANTED:
      return "answer_no";
    case Candidate::UNSURE:
      return "answer_unsure";
    default:
      return nullptr;
  }
}

// By somebody, not assumed.
bool isAnswered(const Candidate& candidate) {
  return nameOfAnswer(candidate.state) != nullptr && candidate.answered_by != ros_common::kAssumed;
}

// A sentence of its own.
std::string ended(const std::string& text) {
  return text.empty() || text.back() == '.' ? text : text + ".";
}

}  // namespace

DemoNarrator::DemoNarrator(std::ostream& out, phrasing::Phrases phrases, bool tell_questions)
    : out_(out),
      phrases_(std::move(phrases)),
      tell_questions_(tell_questions),
      person_(phrases_.say("story_person")) {}

// As they were worded where they come from.
std::string DemoNarrator::joined(const std::vector<Fluent>& fluents) const {
  std::string text;
  for (const Fluent& fluent : fluents) {
    const std::string clause =
        fluent.text.empty() ? phrases_.clause(ros_common::toLiteral(fluent)) : fluent.text;
    text = text.empty() ? clause : phrases_.say("clauses_more", {text, clause});
  }
  return text;
}

void DemoNarrator::tell(const std::string& name, const std::vector<std::string>& arguments) {
  out_ << phrases_.say(name, arguments) << '\n';
}

void DemoNarrator::tellBelow(const std::string& name, const std::vector<std::string>& arguments) {
  out_ << "  ";
  tell(name, arguments);
}

void DemoNarrator::begin(const HumanTask& task) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!task.person.empty()) person_ = task.person;
  had_plan_ = !task.plan.empty();
  tell("story_task",
       {person_, task.goal.empty() ? phrases_.say("event_goal_of_files") : joined(task.goal)});
  tell(had_plan_ ? "story_plan" : "story_no_plan", {person_});
  for (std::size_t i = 0; i < task.plan.size(); ++i) {
    fmt::print(out_, "  {:2}. {}\n", i + 1, phrases_.action(ros_common::toAction(task.plan[i])));
  }
  out_ << std::flush;
}

void DemoNarrator::hear(const Question& question) {
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
void DemoNarrator::forgetDialogue() {
  questions_.clear();
  asked_about_.clear();
  told_question_ = false;
  heard_questions_ = 0;
}

void DemoNarrator::hear(const AlignmentState& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_ = state;
  tellDialogue();
}

bool DemoNarrator::hasHeardAllOf(const AlignResult& result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (result.session_id.empty()) return true;  // refused before there was a session
  if (state_.session_id != result.session_id || state_.phase != AlignmentState::DONE) return false;
  const auto is_explained = [this](const Candidate& candidate) {
    return !isAnswered(candidate) || isIn(asked_about_, candidate.fluent);
  };
  return heard_questions_ >= result.questions &&
         std::all_of(result.candidates.begin(), result.candidates.end(), is_explained);
}

void DemoNarrator::hear(const AlignResult& result) {
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

void DemoNarrator::takeUp(const AlternativeGoal& alternative) {
  const std::lock_guard<std::mutex> lock(mutex_);
  out_ << '\n';
  tell("story_settles", {person_, joined(alternative.given_up)});
  out_ << std::flush;
  resume();
}

void DemoNarrator::awaitChoice() {
  const std::lock_guard<std::mutex> lock(mutex_);
  out_ << '\n';
  tell("story_awaits_choice");
  out_ << std::flush;
  resume();
}

void DemoNarrator::leaveIt() {
  const std::lock_guard<std::mutex> lock(mutex_);
  out_ << '\n';
  tell("story_leaves", {person_});
  out_ << std::flush;
}

// Another end will be heard, and its questions are counted anew.
void DemoNarrator::resume() {
  has_ended_ = false;
  state_.phase = AlignmentState::ANALYSING;
  heard_questions_ = 0;
}

void DemoNarrator::tellDialogue() {
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

void DemoNarrator::tellBreak() {
  if (told_break_) return;
  told_break_ = true;
  if (state_.human_plan_break.empty()) return;
  out_ << '\n';
  tell("story_break", {state_.human_plan_break});
}

void DemoNarrator::tellQuestion(const Question& question) {
  if (!tell_questions_) return;
  out_ << '\n';
  tell("story_asks", {question.text});
  if (!question.why.empty()) tellBelow("story_reason", {question.why});
  out_ << std::flush;
}

// Answered, or taken back since other answers have made it needless.
bool DemoNarrator::isOver(const Question& question) const {
  const auto& fluents = question.fluents;
  const auto answered = [this](const Fluent& fluent) { return answerTo(fluent) != nullptr; };
  return has_ended_ || isLaterAsked() || std::all_of(fluents.begin(), fluents.end(), answered);
}

// The next question is open, as far as the state says, so the first of those known is not.
bool DemoNarrator::isLaterAsked() const {
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

const Candidate* DemoNarrator::candidateOf(const Fluent& fluent) const {
  const auto found = std::find_if(state_.candidates.begin(), state_.candidates.end(),
                                  [&](const Candidate& c) { return sameFluent(c.fluent, fluent); });
  return found == state_.candidates.end() ? nullptr : &*found;
}

// Null where there is none.
const char* DemoNarrator::answerTo(const Fluent& fluent) const {
  const Candidate* candidate = candidateOf(fluent);
  return candidate == nullptr ? nullptr : nameOfAnswer(candidate->state);
}

void DemoNarrator::tellAnswer(const Question& question) {
  // Where a dialogue shows the questions, the next one may stand above this.
  const bool names = question.fluents.size() > 1 || !tell_questions_;
  for (const Fluent& fluent : question.fluents) {
    const char* answer = answerTo(fluent);
    if (answer != nullptr) {
      const std::string word = phrases_.say(answer);
      if (names) {
        tellBelow("story_answers_of", {person_, joined({fluent}), word});
      } else {
        tellBelow("story_answers", {person_, word});
      }
    } else if (!has_ended_) {
      tellBelow(names ? "story_needless_of" : "story_needless", {joined({fluent})});
    }
  }
  out_ << std::flush;
}

// Volunteered, known from a dialogue that was broken off, or the question was lost.
void DemoNarrator::tellOtherAnswers() {
  for (const Candidate& candidate : state_.candidates) {
    if (!isAnswered(candidate) || isIn(asked_about_, candidate.fluent)) continue;
    asked_about_.push_back(candidate.fluent);
    tellBelow("story_also_answered",
              {person_, joined({candidate.fluent}), phrases_.say(nameOfAnswer(candidate.state))});
  }
}

void DemoNarrator::tellPlan(const Plan& plan) {
  out_ << '\n' << foundText(plan) << '\n';
  if (!plan.not_wanted.empty()) tell("story_left_out", {joined(plan.not_wanted)});
  if (!plan.assumed_not_wanted.empty())
    tell("story_not_promised", {joined(plan.assumed_not_wanted)});
  if (plan.extra_cost > 0) out_ << extraText(plan) << '\n';
}

std::string DemoNarrator::foundText(const Plan& plan) const {
  return plan.steps.empty() ? phrases_.say("story_found_done")
                            : phrases_.counted("story_found", plan.steps.size());
}

// Where each step costs 1, the cost is a number of steps.
std::string DemoNarrator::extraText(const Plan& plan) const {
  const auto steps = static_cast<std::size_t>(plan.extra_cost);
  const bool counts_steps = plan.cost == static_cast<double>(plan.steps.size());
  if (counts_steps)
    return phrases_.counted("story_extra_steps", steps, {std::to_string(plan.steps.size())});
  return phrases_.say("story_extra_cost",
                      {fmt::format("{}", plan.extra_cost), fmt::format("{}", plan.cost)});
}

void DemoNarrator::tellFailure(const AlignResult& result) {
  // "There is no plan" is said only where that is proven.
  const bool proven = result.outcome == AlignResult::GOAL_UNSOLVABLE ||
                      result.outcome == AlignResult::EXPECTATION_UNACHIEVABLE;
  out_ << '\n';
  tell(proven ? "story_impossible" : "story_undecided",
       {std::to_string(result.outcome), ended(result.message)});
  // The first ones are in the message.
  for (std::size_t i = phrasing::kSpokenAlternatives; i < result.alternatives.size(); ++i)
    tellBelow("story_except", {joined(result.alternatives[i].given_up)});
}

std::string DemoNarrator::stepText(const ActionDispatch& step) const {
  GroundName action;
  action.name = step.name;
  for (const auto& parameter : step.parameters)
    action.arguments.push_back(parameter.value);
  return phrases_.action(action);
}

void DemoNarrator::hearStep(const Plan& plan, std::size_t index) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (; told_steps_ <= index && told_steps_ < plan.steps.size(); ++told_steps_) {
    tellBelow("story_step", {std::to_string(told_steps_ + 1), std::to_string(plan.steps.size()),
                             stepText(plan.steps[told_steps_])});
  }
  out_ << std::flush;
}

void DemoNarrator::hearTrouble(const std::string& reason) {
  const std::lock_guard<std::mutex> lock(mutex_);
  out_ << '\n';
  tell("story_trouble", {ended(phrases_.inWords(reason))});
  out_ << std::flush;
}

void DemoNarrator::hearNewPlan(const Plan& plan) {
  const std::lock_guard<std::mutex> lock(mutex_);
  told_steps_ = 0;
  out_ << phrases_.counted("story_new", plan.steps.size()) << std::endl;
}

void DemoNarrator::hearEnd(const Plan& plan, const ExecutePlanResult& result) {
  const bool done = result.outcome == ExecutePlanResult::SUCCESS;
  if (done && !plan.steps.empty()) hearStep(plan, plan.steps.size() - 1);
  const std::lock_guard<std::mutex> lock(mutex_);
  out_ << '\n';
  if (done) {
    tell("story_guaranteed", {joined(plan.guaranteed)});
  } else {
    tell("story_not_done",
         {std::to_string(result.outcome), ended(phrases_.inWords(result.reason))});
  }
  out_ << std::flush;
}

}  // namespace goal_alignment::nodes
