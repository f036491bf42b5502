// SPDX-License-Identifier: BSD-3-Clause
#include "ask_human_client.h"

#include <fmt/format.h>
#include <ros/service.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "goal_alignment/AskHuman.h"
#include "goal_alignment/ros_common/message_conversion.h"
#include "goal_alignment/ros_common/names.h"

namespace goal_alignment::aligner {
namespace {

constexpr std::chrono::milliseconds kRetryPause{500};
constexpr std::chrono::seconds kPatienceAtTheEnd{2};

bool areTheSame(const Fluent& one, const Fluent& other) {
  return one.name == other.name && one.args == other.args && one.negated == other.negated;
}

// The same question, perhaps put again after silence, and as much of it.
bool asksTheSame(const Question& one, const Question& other) {
  return one.session_id == other.session_id &&
         std::equal(one.fluents.begin(), one.fluents.end(), other.fluents.begin(),
                    other.fluents.end(), areTheSame);
}

// A dialogue that names no id means the question it was asked, not whichever is open by now. Where
// it names fluents, it volunteers them.
Answer::Request requestOf(const Question& asked, const AskHuman::Response& response) {
  Answer::Request request;
  request.answer = response.answer;
  request.question_id = response.question_id;
  request.fluents = response.fluents;
  request.answered_by = response.answered_by;
  const bool volunteers = !request.fluents.empty() && request.answer != AskHuman::Response::DECLINE;
  if (request.question_id == 0 && !volunteers) request.question_id = asked.question_id;
  return request;
}

// Whether an answer leaves nothing of the question to ask.
bool covers(const Answer::Request& answer, const Question& asked) {
  if (answer.question_id != 0) return true;
  const std::vector<Literal> named = ros_common::toLiterals(answer.fluents);
  const std::vector<Literal> all = ros_common::toLiterals(asked.fluents, "fluents");
  return std::all_of(all.begin(), all.end(), [&](const Literal& fluent) {
    return std::find(named.begin(), named.end(), fluent) != named.end();
  });
}

}  // namespace

struct AskHumanClient::Shared {
  std::optional<ros::NodeHandle> node;  // gone before `finished`: roscpp must outlive it
  Deliver deliver;
  ErrorCallback complain;

  std::mutex mutex;  // guards all below
  std::condition_variable changed;
  std::optional<Question> question;  // the open one, until it was answered through us
  bool stop = false;
  bool finished = false;

  // Of the client's own thread.
  std::uint32_t complained_of = 0;  // a question
  std::string complaint;

  void run();
  // Of one question the same is told once: it is tried again and again.
  void complainOnce(const Question& asked, const std::string& line);
  // The next question to ask, or nothing at the end.
  std::optional<Question> await();
  void treat(const Question& asked, const AskHuman::Response& response);
  // Waits before the same question is tried again; ends early when it changes.
  void pause(const Question& asked);
  bool isOpen(const Question& asked) {
    const std::lock_guard<std::mutex> lock(mutex);
    return stillOpen(asked);
  }
  // Needs the mutex.
  bool stillOpen(const Question& asked) const {
    return !stop && question && question->question_id == asked.question_id;
  }
};

AskHumanClient::AskHumanClient(ros::NodeHandle node, Deliver deliver, ErrorCallback complain)
    : shared_(std::make_shared<Shared>()) {
  shared_->node = std::move(node);
  shared_->deliver = std::move(deliver);
  shared_->complain = std::move(complain);
  std::thread([shared = shared_] { shared->run(); }).detach();
}

AskHumanClient::~AskHumanClient() {
  std::unique_lock<std::mutex> lock(shared_->mutex);
  shared_->stop = true;
  shared_->changed.notify_all();
  shared_->changed.wait_for(lock, kPatienceAtTheEnd, [this] { return shared_->finished; });
}

void AskHumanClient::ask(const Question& question) {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  shared_->question = question;
  shared_->changed.notify_all();
}

void AskHumanClient::withdraw() {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  shared_->question.reset();
  shared_->changed.notify_all();
}

void AskHumanClient::Shared::run() {
  while (const auto asked = await()) {
    AskHuman call;
    call.request.question = *asked;
    // A client of its own, since the next call may go to another node; persistent all the same,
    // since of other calls roscpp loses a response now and then (ros_comm issue 1976), and a person
    // would be asked twice.
    const std::string service = node->resolveName(ros_common::kAskHumanService);
    if (ros::service::exists(service, false)) {
      if (node->serviceClient<AskHuman>(ros_common::kAskHumanService, true).call(call)) {
        treat(*asked, call.response);
      } else if (isOpen(*asked)) {  // else who was asked may have left it
        complainOnce(*asked, fmt::format("a call of {} failed and is retried", service));
      }
    }
    pause(*asked);
  }
  node.reset();
  const std::lock_guard<std::mutex> lock(mutex);
  finished = true;
  changed.notify_all();
}

std::optional<Question> AskHumanClient::Shared::await() {
  std::unique_lock<std::mutex> lock(mutex);
  changed.wait(lock, [this] { return stop || question.has_value(); });
  if (stop) return std::nullopt;
  return question;
}

void AskHumanClient::Shared::treat(const Question& asked, const AskHuman::Response& response) {
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (stop || response.answer == AskHuman::Response::NONE) return;
  }
  const Answer::Request request = requestOf(asked, response);
  const session::SubmitResult receipt = deliver(request);
  if (!receipt.accepted) {
    return complainOnce(
        asked, fmt::format("an answer from {} was refused: {}",
                           node->resolveName(ros_common::kAskHumanService), receipt.message));
  }
  // Answered in part, it is asked once more as soon as it is shown without what was answered; if
  // something else was volunteered, once more as it is.
  const std::lock_guard<std::mutex> lock(mutex);
  if (question && asksTheSame(*question, asked) && covers(request, asked)) question.reset();
}

void AskHumanClient::Shared::complainOnce(const Question& asked, const std::string& line) {
  if (complained_of == asked.question_id && complaint == line) return;
  complained_of = asked.question_id;
  complaint = line;
  complain(line);
}

void AskHumanClient::Shared::pause(const Question& asked) {
  std::unique_lock<std::mutex> lock(mutex);
  changed.wait_for(lock, kRetryPause, [&] { return !stillOpen(asked); });
}

}  // namespace goal_alignment::aligner
