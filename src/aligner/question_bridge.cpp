// SPDX-License-Identifier: BSD-3-Clause
#include "question_bridge.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "goal_alignment/common/quote.h"
#include "goal_alignment/ros_common/message_conversion.h"
#include "goal_alignment/ros_common/names.h"
#include "goal_alignment/ros_common/outside_text.h"
#include "goal_alignment/ros_common/stamp.h"

namespace goal_alignment::aligner {
namespace {

using session::AnswerKind;
using session::CandidateState;
using session::SubmitResult;

constexpr std::chrono::duration<double> kGrace{ros_common::kAnswerGraceSeconds};
constexpr std::size_t kMaxRefusals = 3;  // reasons that are remembered

bool isAnswered(CandidateState state) {
  return state == CandidateState::Wanted || state == CandidateState::NotWanted ||
         state == CandidateState::Unsure;
}

CandidateState stateAfter(AnswerKind kind) {
  switch (kind) {
    case AnswerKind::Yes:
      return CandidateState::Wanted;
    case AnswerKind::No:
      return CandidateState::NotWanted;
    default:
      return CandidateState::Unsure;
  }
}

std::string refusalOfValue(const Answer::Request& request) {
  if (request.answer >= Answer::Request::NO && request.answer <= Answer::Request::DECLINE)
    return {};
  return fmt::format("{} is not an answer: expected NO=0, YES=1, UNSURE=2 or DECLINE=3",
                     static_cast<int>(request.answer));
}

void show(const AcceptedAnswer& answer, AlignmentState& state) {
  if (answer.kind == AnswerKind::Decline) return;
  for (Candidate& candidate : state.candidates) {
    const auto& fluents = answer.fluents;
    if (std::find(fluents.begin(), fluents.end(), ros_common::toLiteral(candidate.fluent)) ==
        fluents.end())
      continue;
    candidate.state = static_cast<std::uint8_t>(stateAfter(answer.kind));
    candidate.answered_by = answer.answered_by;
    candidate.answered_at = answer.at;
  }
}

// Each once, in the order given.
std::vector<Literal> distinct(const std::vector<Literal>& literals) {
  std::vector<Literal> result;
  for (const Literal& literal : literals) {
    if (std::find(result.begin(), result.end(), literal) == result.end()) result.push_back(literal);
  }
  return result;
}

}  // namespace

QuestionBridge::QuestionBridge(QuestionIds ids, Keep keep, std::function<Clock::time_point()> now)
    : keep_(std::move(keep)), now_(std::move(now)), ids_(std::move(ids)) {}

void QuestionBridge::keep(std::unique_lock<std::mutex>& lock,
                          const std::vector<AcceptedAnswer>& answers) const {
  const std::string session_id = session_id_;
  lock.unlock();
  if (keep_) keep_(session_id, answers);
}

void QuestionBridge::beginSession(const std::string& session_id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  under_way_ = true;
  interrupted_ = false;
  refusals_.clear();
  if (session_id == session_id_) return;
  session_id_ = session_id;
  accepted_.clear();
  taken_.clear();
  candidates_known_ = false;
  candidates_.clear();
  specified_.clear();
}

void QuestionBridge::endSession() {
  const std::lock_guard<std::mutex> lock(mutex_);
  closeOpen(false);
  under_way_ = false;
  const auto declines = [](const AcceptedAnswer& answer) {
    return answer.kind == AnswerKind::Decline;
  };
  accepted_.erase(std::remove_if(accepted_.begin(), accepted_.end(), declines), accepted_.end());
}

bool QuestionBridge::endSessionIfIdle() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!accepted_.empty()) return false;
  closeOpen(false);
  under_way_ = false;
  return true;
}

void QuestionBridge::update(const session::Snapshot& snapshot) {
  const std::lock_guard<std::mutex> lock(mutex_);
  candidates_known_ = !snapshot.specified.empty() || !snapshot.candidates.empty();
  specified_ = {snapshot.specified.begin(), snapshot.specified.end()};
  candidates_.clear();
  for (const auto& candidate : snapshot.candidates) {
    // What is assumed nobody has said: a first answer may still come.
    const CandidateState state = candidate.assumed ? CandidateState::Settled : candidate.state;
    candidates_.emplace(candidate.fluent, state);
  }
  // The session has not heard these yet, but their givers were told that they count.
  for (const AcceptedAnswer& answer : accepted_)
    count(answer);
}

std::uint32_t QuestionBridge::open(const std::vector<Literal>& fluents) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!accepted_.empty()) return 0;
  closeOpen(false);
  OpenQuestion question;
  question.id = ids_.next();
  question.fluents = {fluents.begin(), fluents.end()};
  question.opened = now_();
  const bool same_dialogue = last_closed_ && last_session_ == session_id_;
  const bool vanished = last_closed_ && !last_answered_ && question.opened - *last_closed_ < kGrace;
  // The same question put once more is the one that was read.
  const bool another = last_session_ != session_id_ || last_fluents_ != question.fluents;
  question.replaced_another = another && (same_dialogue || vanished);
  if (!another && !last_answered_) question.earlier_ids = last_ids_;
  if (another) refusals_.clear();
  open_ = std::move(question);
  return open_->id;
}

void QuestionBridge::close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  closeOpen(false);
}

void QuestionBridge::closeOpen(bool answered) {
  if (!open_) return;
  last_fluents_ = std::move(open_->fluents);
  last_ids_ = std::move(open_->earlier_ids);
  last_ids_.insert(open_->id);
  open_.reset();
  last_answered_ = answered;
  last_session_ = session_id_;
  last_closed_ = now_();
}

std::vector<AcceptedAnswer> QuestionBridge::take() {
  // What a session has taken must not be kept after what it has made of it.
  const std::lock_guard<std::mutex> keeping(keeping_);
  const std::lock_guard<std::mutex> lock(mutex_);
  taken_.insert(taken_.end(), accepted_.begin(), accepted_.end());
  return std::exchange(accepted_, {});
}

void QuestionBridge::markShown() {
  const std::lock_guard<std::mutex> lock(mutex_);
  taken_.clear();
}

QuestionBridge::Unshown QuestionBridge::unshown() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  Unshown unshown{session_id_, taken_};
  unshown.answers.insert(unshown.answers.end(), accepted_.begin(), accepted_.end());
  return unshown;
}

void QuestionBridge::Unshown::addTo(AlignmentState& state) const {
  if (state.session_id != session_id) return;
  for (const AcceptedAnswer& answer : answers)
    show(answer, state);
}

QuestionBridge::Wake QuestionBridge::wait(Clock::time_point deadline) {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto woken = [this] { return interrupted_ || woken_ || !accepted_.empty(); };
  // wait_until() with the largest time point overflows in some standard libraries.
  if (deadline == Clock::time_point::max()) {
    changed_.wait(lock, woken);
  } else if (!changed_.wait_until(lock, deadline, woken)) {
    return Wake::TimedOut;
  }
  const bool interrupted = std::exchange(interrupted_, false);
  const bool nudged = std::exchange(woken_, false);
  return interrupted ? Wake::Interrupt : nudged ? Wake::News : Wake::Answer;
}

void QuestionBridge::wakeUp() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    woken_ = true;
  }
  changed_.notify_all();
}

void QuestionBridge::interrupt() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    interrupted_ = true;
  }
  changed_.notify_all();
}

SubmitResult QuestionBridge::submit(const Answer::Request& request) {
  std::vector<Literal> fluents;
  std::string why_not;
  try {
    fluents = distinct(ros_common::toLiterals(request.fluents));
  } catch (const std::invalid_argument& error) {
    why_not = error.what();
  }
  const std::lock_guard<std::mutex> keeping(keeping_);
  std::unique_lock<std::mutex> lock(mutex_);
  if (why_not.empty()) why_not = refusalOf(request, fluents);
  if (!why_not.empty()) return refuse(why_not);

  AcceptedAnswer answer;
  answer.kind = static_cast<AnswerKind>(request.answer);
  answer.answered_by = ros_common::outsideName(request.answered_by);
  answer.at = ros_common::stampNow();
  answer.fluents = std::move(fluents);
  if (open_ && (answer.fluents.empty() || request.question_id != 0)) answer.question_id = open_->id;
  AcceptedAnswer rest = answer;
  rest.kind = AnswerKind::No;
  rest.fluents.clear();
  if (open_ && answer.fluents.empty()) {
    answer.fluents = unanswered();
  } else if (request.question_id != 0 && answer.kind == AnswerKind::Yes) {
    for (const Literal& fluent : unanswered()) {
      const auto& named = answer.fluents;
      if (std::find(named.begin(), named.end(), fluent) == named.end())
        rest.fluents.push_back(fluent);
    }
  }
  std::vector<AcceptedAnswer> accepted = {std::move(answer)};
  if (!rest.fluents.empty()) accepted.push_back(std::move(rest));
  for (const AcceptedAnswer& each : accepted)
    accept(each);
  keep(lock, accepted);
  return {true, ""};
}

// The last of the reasons stands last.
SubmitResult QuestionBridge::refuse(const std::string& why_not) {
  const std::string reason = shortened(why_not);
  refusals_.erase(std::remove(refusals_.begin(), refusals_.end(), reason), refusals_.end());
  if (refusals_.size() == kMaxRefusals) refusals_.erase(refusals_.begin());
  refusals_.push_back(reason);
  return {false, why_not};
}

std::string QuestionBridge::refusals() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::string text;
  for (const std::string& reason : refusals_)
    text += (text.empty() ? "" : "; ") + reason;
  return text;
}

std::vector<Literal> QuestionBridge::unanswered() const {
  std::vector<Literal> fluents;
  for (const Literal& fluent : open_->fluents) {
    const auto known = candidates_.find(fluent);
    if (known == candidates_.end() || !isAnswered(known->second)) fluents.push_back(fluent);
  }
  return fluents;
}

QuestionBridge::Revision QuestionBridge::revise(const Answer::Request& request) {
  AcceptedAnswer answer;
  try {
    answer.fluents = distinct(ros_common::toLiterals(request.fluents));
  } catch (const std::invalid_argument& error) {
    return {{false, error.what()}, ""};
  }
  const std::lock_guard<std::mutex> keeping(keeping_);
  std::unique_lock<std::mutex> lock(mutex_);
  std::string why_not = refusalOfValue(request);
  if (why_not.empty() && request.answer == Answer::Request::DECLINE) {
    why_not = "a revised answer is NO, YES or UNSURE";
  }
  if (why_not.empty() && answer.fluents.empty()) why_not = "name the fluents to revise";
  if (why_not.empty()) why_not = refusalOfFluents(answer.fluents, 0, true);
  if (!why_not.empty()) return {{false, why_not}, ""};
  answer.kind = static_cast<AnswerKind>(request.answer);
  answer.answered_by = ros_common::outsideName(request.answered_by);
  answer.at = ros_common::stampNow();
  accept(answer);
  const std::string goes_on = under_way_ ? "" : session_id_;
  keep(lock, {answer});
  return {{true, ""}, goes_on};
}

std::string QuestionBridge::refusalOf(const Answer::Request& request,
                                      const std::vector<Literal>& fluents) const {
  std::string why_not = refusalOfValue(request);
  if (why_not.empty()) why_not = refusalOfQuestion(request);
  if (why_not.empty()) why_not = refusalOfFluents(fluents, request.question_id, false);
  return why_not;
}

bool QuestionBridge::isOpen(std::uint32_t id) const {
  return open_ && (open_->id == id || open_->earlier_ids.count(id) > 0);
}

std::string QuestionBridge::refusalOfQuestion(const Answer::Request& request) const {
  const std::uint32_t id = request.question_id;
  if (!under_way_) return "no alignment is under way";
  if (id != 0) {
    if (isOpen(id)) return {};
    return ids_.issued(id) ? fmt::format("question {} is over", id)
                           : fmt::format("question {} was not asked here", id);
  }
  const bool volunteered = !request.fluents.empty() && request.answer != Answer::Request::DECLINE;
  if (volunteered) return {};
  if (!open_) return "no question is open";
  if (open_->replaced_another && now_() - open_->opened < kGrace) {
    return fmt::format("question {} has just replaced another: read it, or name its id", open_->id);
  }
  return {};
}

std::string QuestionBridge::refusalOfFluents(const std::vector<Literal>& fluents,
                                             std::uint32_t question_id, bool revising) const {
  if (!fluents.empty() && !candidates_known_) {
    return "the candidates are not known yet";
  }
  for (const Literal& fluent : fluents) {
    std::string why_not = refusalOfFluent(fluent, revising);
    if (why_not.empty() && question_id != 0 && open_->fluents.count(fluent) == 0) {
      why_not = fmt::format("{} is not part of question {}", fluent.text(), question_id);
    }
    if (!why_not.empty()) return why_not;
  }
  return {};
}

std::string QuestionBridge::refusalOfFluent(const Literal& fluent, bool revising) const {
  const auto found = candidates_.find(fluent);
  const bool specified = specified_.count(fluent) > 0 ||
                         (found != candidates_.end() && found->second == CandidateState::Specified);
  const std::string text = shortened(fluent.text());
  if (specified) return text + " is part of the specified goal";
  if (found == candidates_.end()) return text + " is outside the state that the person expects";
  if (!revising && isAnswered(found->second))
    return text + " is answered already: use ~revise_answer";
  return {};
}

void QuestionBridge::accept(AcceptedAnswer answer) {
  refusals_.clear();
  count(answer);
  accepted_.push_back(std::move(answer));
  changed_.notify_all();
}

// An answer that leaves no fluent of the open question unanswered closes it for everyone else.
void QuestionBridge::count(const AcceptedAnswer& answer) {
  const bool declines = answer.kind == AnswerKind::Decline;
  if (!declines) {
    for (const Literal& fluent : answer.fluents)
      candidates_[fluent] = stateAfter(answer.kind);
  }
  if (open_ && (declines || unanswered().empty())) closeOpen(true);
}

std::uint32_t QuestionBridge::openId() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return open_ ? open_->id : 0;
}

}  // namespace goal_alignment::aligner
