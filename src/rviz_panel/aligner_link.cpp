// SPDX-License-Identifier: BSD-3-Clause
#include "aligner_link.h"

#include <ros/init.h>
#include <ros/names.h>
#include <ros/service.h>
#include <ros/this_node.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "names.h"

namespace goal_alignment::rviz_panel {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLookPeriod = 200;             // milliseconds
constexpr std::chrono::seconds kSilence{3};  // the status comes every 0.2 s
constexpr int kReplayAfter = 1500;           // milliseconds: a status comes soon if it comes at all
constexpr unsigned kMaxCalls = 8;            // that hang; each holds a thread
constexpr int kReplyPatience = 10000;        // milliseconds until a call is given up

ros::Time stampNow() {
  return ros::Time::isValid() ? ros::Time::now() : ros::Time();
}

template <typename ActionGoal>
void stamp(ActionGoal& message) {
  static std::atomic<unsigned> number{0};
  message.header.stamp = message.goal_id.stamp = stampNow();
  message.goal_id.id = ros::this_node::getName() + "-panel-" +
                       std::to_string(Clock::now().time_since_epoch().count()) + "-" +
                       std::to_string(++number);
}

}  // namespace

// What the threads of the link share with it.
struct AlignerLink::Shared {
  std::atomic<Clock::rep> last_heartbeat{0};
  std::atomic<unsigned> generation{0};        // of subscriptions
  std::atomic<unsigned> heard_generation{0};  // whose heartbeat was the last
  std::atomic<unsigned> hanging{0};           // calls
  std::mutex mutex;
  std::shared_ptr<AlignerTopics> topics;  // null while the worker has not got that far

  std::shared_ptr<AlignerTopics> current() {
    const std::lock_guard<std::mutex> lock(mutex);
    return topics;
  }

  // By the worker alone: what was there goes in its thread, for that talks to the master.
  void replaceTopics(std::shared_ptr<AlignerTopics> next) {
    {
      const std::lock_guard<std::mutex> lock(mutex);
      std::swap(topics, next);
    }
    while (next.use_count() > 1)
      std::this_thread::yield();  // the panel is just sending something
  }
};

AlignerLink::AlignerLink(QObject* parent)
    : QObject(parent),
      mailbox_(std::make_shared<Mailbox>(this)),
      shared_(std::make_shared<Shared>()) {
  connect(&timer_, &QTimer::timeout, this, &AlignerLink::look);
  timer_.start(kLookPeriod);
}

AlignerLink::~AlignerLink() {
  mailbox_->close();
  ++shared_->generation;
  worker_.add([shared = shared_] { shared->replaceTopics(nullptr); });
}

QString AlignerLink::connectTo(const QString& aligner) {
  std::string resolved;
  std::string error;
  const std::string name = aligner.trimmed().toStdString();
  if (!name.empty()) {
    if (!ros::names::validate(name, error)) return QString::fromStdString(error);
    if (name[0] == '~') return QStringLiteral("the name of an aligner can't begin with ~");
    resolved = ros::names::resolve(name);
  }
  aligner_ = resolved;
  was_there_ = false;
  setPresence(Presence::Absent);
  shared_->last_heartbeat = 0;
  subscribe();
  return {};
}

void AlignerLink::subscribe() {
  first_message_.invalidate();
  task_.reset();
  const unsigned generation = ++shared_->generation;
  emit cleared();
  const auto fail = [this, shared = shared_, generation](const QString& why) {
    if (generation == shared->generation) emit failed(why);
  };
  worker_.add([shared = shared_, mailbox = mailbox_, generation, aligner = aligner_,
               listener = listener(), fail] {
    shared->replaceTopics(nullptr);
    if (generation != shared->generation || aligner.empty()) return;
    try {
      shared->replaceTopics(std::make_shared<AlignerTopics>(aligner, listener));
    } catch (const std::exception& error) {  // nobody is above to catch it: rviz would end
      mailbox->post([fail, why = QString::fromStdString(error.what())] { fail(why); });
    }
  });
}

template <typename Message>
std::function<void(const boost::shared_ptr<const Message>&)> AlignerLink::forward(
    void (AlignerLink::*take)(const boost::shared_ptr<const Message>&)) {
  return
      [this, take, mailbox = mailbox_, shared = shared_,
       generation = shared_->generation.load()](const boost::shared_ptr<const Message>& message) {
        mailbox->post([this, take, message, shared, generation] {
          if (generation == shared->generation) (this->*take)(message);
        });
      };
}

Listener AlignerLink::listener() {
  Listener listener;
  listener.state = forward<AlignmentState>(&AlignerLink::hear);
  listener.question = forward<Question>(&AlignerLink::hear);
  listener.plan = forward<Plan>(&AlignerLink::hear);
  listener.align_goal = forward<AlignActionGoal>(&AlignerLink::hear);
  listener.align_result = forward<AlignActionResult>(&AlignerLink::hear);
  listener.execution_begun = forward<ExecutePlanActionGoal>(&AlignerLink::hear);
  listener.execution_feedback = forward<ExecutePlanActionFeedback>(&AlignerLink::hear);
  listener.execution_ended = forward<ExecutePlanActionResult>(&AlignerLink::hear);
  listener.heartbeat = [shared = shared_, generation = shared_->generation.load()] {
    if (generation != shared->generation) return;
    shared->heard_generation = generation;
    shared->last_heartbeat = Clock::now().time_since_epoch().count();
  };
  return listener;
}

void AlignerLink::noteMessage() {
  if (!first_message_.isValid()) first_message_.start();
}

void AlignerLink::hear(const AlignmentState::ConstPtr& state) {
  noteMessage();
  emit stateHeard(state);
}

void AlignerLink::hear(const Question::ConstPtr& question) {
  noteMessage();
  emit questionHeard(question);
}

void AlignerLink::hear(const Plan::ConstPtr& plan) {
  noteMessage();
  emit planHeard(plan);
}

void AlignerLink::hear(const AlignActionGoal::ConstPtr& goal) {
  if (goal->goal.continue_session.empty()) task_ = boost::make_shared<AlignGoal>(goal->goal);
}

// What comes of a goal is seen in the state, but for one that was not even begun.
void AlignerLink::hear(const AlignActionResult::ConstPtr& result) {
  const bool ours = !last_goal_.empty() && result->status.goal_id.id == last_goal_;
  if (ours && result->status.status == actionlib_msgs::GoalStatus::REJECTED)
    emit replied(false, QString::fromStdString(result->result.message));
}

void AlignerLink::hear(const ExecutePlanActionGoal::ConstPtr& /*goal*/) {
  emit executionBegun();
}

void AlignerLink::hear(const ExecutePlanActionFeedback::ConstPtr& feedback) {
  emit executionHeard(feedback->feedback);
}

void AlignerLink::hear(const ExecutePlanActionResult::ConstPtr& result) {
  emit executionEnded(result->result);
}

void AlignerLink::answer(int answer, quint32 question_id, const QStringList& fluents,
                         const QString& answered_by) {
  Answer::Request request;
  request.answer = static_cast<std::int8_t>(answer);
  request.question_id = question_id;
  for (const QString& fluent : fluents)
    request.fluents.push_back(fluent.toStdString());
  request.answered_by = answered_by.toStdString();
  call(kAnswerService, request);
}

void AlignerLink::revise(int answer, const QStringList& fluents, const QString& answered_by) {
  Answer::Request request;
  request.answer = static_cast<std::int8_t>(answer);
  for (const QString& fluent : fluents)
    request.fluents.push_back(fluent.toStdString());
  request.answered_by = answered_by.toStdString();
  call(kReviseAnswerService, request);
}

// roscpp's calls have no time-out: the thread waits, the person doesn't.
void AlignerLink::call(const char* service, const Answer::Request& request) {
  if (shared_->hanging >= kMaxCalls) {
    emit replied(false, QStringLiteral("too many earlier calls have had no reply"));
    return;
  }
  const auto pending = std::make_shared<bool>(true);  // of the owner's thread
  const auto reply = [this, pending](bool accepted, const QString& message) {
    if (std::exchange(*pending, false)) emit replied(accepted, message);
  };
  QTimer::singleShot(kReplyPatience, this, [reply] {
    reply(false, QStringLiteral("no reply so far; whether it counts will be seen"));
  });
  ++shared_->hanging;
  const std::string name = ros::names::append(aligner_, service);
  std::thread([name, request, reply, shared = shared_, mailbox = mailbox_]() mutable {
    Answer::Response response;
    // Persistent, since of other calls roscpp loses a response now and then (ros_comm issue 1976).
    const bool called = ros::NodeHandle().serviceClient<Answer>(name, true).call(request, response);
    --shared->hanging;
    const QString message = called ? QString::fromStdString(response.message)
                                   : QStringLiteral("nobody offers %1").arg(name.c_str());
    const bool accepted = called && response.accepted != 0;
    mailbox->post([reply, accepted, message] { reply(accepted, message); });
  }).detach();
}

void AlignerLink::takeUp(const QString& session_id, const std::vector<Fluent>& given_up,
                         const QString& answered_by) {
  AlignGoal goal;
  goal.task.person = answered_by.toStdString();
  goal.max_questions = -1;
  goal.unsure_policy = AlignGoal::KEEP;
  goal.continue_session = session_id.toStdString();
  goal.revised_not_wanted = given_up;
  send(goal);
}

void AlignerLink::tryAgain(const QString& session_id, const QString& answered_by) {
  if (!session_id.isEmpty()) return takeUp(session_id, {}, answered_by);
  if (task_) return send(*task_);
  emit replied(false, QStringLiteral("the task was not heard here; send it once more"));
}

void AlignerLink::send(AlignGoal goal) {
  AlignActionGoal message;
  message.goal = std::move(goal);
  stamp(message);
  last_goal_ = message.goal_id.id;
  const auto topics = shared_->current();
  const bool sent = topics && topics->send(message);
  emit replied(sent, sent ? QString() : QStringLiteral("nobody takes tasks there"));
}

void AlignerLink::execute(const Plan& plan) {
  ExecutePlanActionGoal message;
  message.goal.plan = plan;
  stamp(message);
  const auto topics = shared_->current();
  const bool sent = topics && topics->send(message);
  emit replied(sent, sent ? QString() : QStringLiteral("there is no executor to carry it out"));
}

void AlignerLink::withdraw(const QString& goal_id) {
  const auto topics = shared_->current();
  // An empty id would cancel everything.
  if (goal_id.isEmpty() || !topics || !topics->cancelAlignment(goal_id.toStdString()))
    emit replied(false, QStringLiteral("nobody hears the cancel"));
}

void AlignerLink::cancelAlignment() {
  const auto topics = shared_->current();
  if (!topics || !topics->cancelAlignment())
    emit replied(false, QStringLiteral("nobody hears the cancel"));
}

void AlignerLink::cancelExecution() {
  const auto topics = shared_->current();
  if (!topics || !topics->cancelExecution())
    emit replied(false, QStringLiteral("no executor hears the cancel"));
}

bool AlignerLink::isHeard() const {
  const Clock::rep last = shared_->last_heartbeat;
  return last != 0 && Clock::now() - Clock::time_point(Clock::duration(last)) < kSilence;
}

void AlignerLink::look() {
  if (isHeard()) {
    // Its latched messages may be those of an earlier run, and a lost connection brings no new
    // ones.
    if (std::exchange(was_there_, false)) subscribe();
    return setPresence(Presence::There);
  }
  if (presence_ == Presence::There) {
    // A silence that our own new subscriptions made says nothing about the aligner.
    was_there_ = shared_->heard_generation == shared_->generation;
    first_message_.invalidate();
    return setPresence(Presence::Absent);
  }
  const auto topics = shared_->current();
  const bool spoken = first_message_.isValid() && first_message_.hasExpired(kReplayAfter);
  const bool replayed = spoken && topics && topics->hasPublisher();
  setPresence(replayed ? Presence::Replay : Presence::Absent);
}

void AlignerLink::setPresence(Presence presence) {
  if (presence == presence_) return;
  presence_ = presence;
  emit presenceChanged(presence);
}

}  // namespace goal_alignment::rviz_panel
