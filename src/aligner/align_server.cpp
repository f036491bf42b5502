// SPDX-License-Identifier: BSD-3-Clause
#include "align_server.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include "goal_alignment/ros_common/names.h"
#include "goal_alignment/ros_common/stamp.h"

namespace goal_alignment::aligner {
namespace {

using Standing = PlanWatch::Standing;

constexpr unsigned kLateWords = 1;  // of the executor, under way when the task came

AlignResult canceledBeforeItBegan() {
  AlignResult result;
  result.outcome = AlignResult::CANCELED;
  result.message = "canceled before it began";
  result.failing_step = -1;
  return result;
}

TaskQueue<std::shared_ptr<GoalTicket>>::Entry entryFor(const std::shared_ptr<GoalTicket>& ticket) {
  TaskQueue<std::shared_ptr<GoalTicket>>::Entry entry;
  entry.shown.goal_id = ticket->id();
  entry.shown.task_id = ticket->goal().task.task_id;
  entry.shown.person = ticket->goal().task.person;
  entry.shown.since = ros_common::stampNow();
  entry.identity = ticket->identity();
  entry.ticket = ticket;
  return entry;
}

// The subject of a sentence, since a task may have no id.
std::string named(const GoalTicket& ticket) {
  const std::string& task_id = ticket.goal().task.task_id;
  return task_id.empty() ? "the task" : "task " + task_id;
}

}  // namespace

AlignServer::AlignServer(const ros::NodeHandle& private_node, AlignmentRunner& runner,
                         Announcer& announcer, const PlanWatch& watch,
                         RefusesIfBusy refuses_if_busy, NoteWaiting note_waiting)
    : runner_(runner),
      announcer_(announcer),
      watch_(watch),
      refuses_if_busy_(std::move(refuses_if_busy)),
      note_waiting_(std::move(note_waiting)),
      server_(
          private_node, ros_common::kAlignAction,
          [this](GoalTicket::Handle handle) { takeGoal(std::move(handle)); },
          [this](const GoalTicket::Handle& handle) { cancelGoal(handle); },
          canceledBeforeItBegan()),
      solver_([this] { work(); }) {
  server_.start();
}

AlignServer::~AlignServer() {
  endGoals();
}

void AlignServer::endGoals() {
  std::vector<Ticket> ended;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
    for (Queue::Entry& entry : queue_.takeAll([](const Queue::Entry&) { return true; }))
      ended.push_back(std::move(entry.ticket));
    if (!ended.empty()) note_waiting_({});
    if (next_) ended.push_back(std::exchange(next_, nullptr));
    if (current_) ended.push_back(current_);
  }
  changed_.notify_all();
  for (const Ticket& ticket : ended)
    end(ticket, "the node shuts down");
  if (solver_.joinable()) solver_.join();
}

void AlignServer::wakeUp() {
  { const std::lock_guard<std::mutex> lock(mutex_); }  // so that no wait begins in between
  changed_.notify_all();
}

// What waited until it was known whether a plan is carried out, and what that plan is for. Who
// knows the end of a plan may send the next task before the executor's word of that end is here.
void AlignServer::onExecutorStatus() {
  std::vector<Queue::Entry> refused;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!queue_.empty() && watch_.standing() == Standing::Busy) {
      refused = queue_.takeAll([this](const Queue::Entry& entry) {
        const bool is_new = watch_.statusCount() <= entry.statuses_before + kLateWords;
        return !is_new && (entry.refused_if_busy || watch_.isExecuting(entry.identity));
      });
    }
    if (!refused.empty()) showQueue();
  }
  changed_.notify_all();
  for (const Queue::Entry& entry : refused)
    refuse(entry.ticket, watch_.description());
}

void AlignServer::submit(const AlignGoal& goal, const std::string& origin) {
  unsigned number = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    number = ++submitted_;
  }
  // Unique among goals of this node, and those of an earlier run with the same name.
  server_.inject(goal, fmt::format("{}-{}-{}", origin, ros_common::stampNow().toNSec(), number));
}

bool AlignServer::isUnderWay(const AlignGoal& goal) const {
  const std::string identity = identityOf(goal);
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const Ticket& ticket : {current_, next_}) {
    if (ticket && !ticket->ended() && ticket->identity() == identity) return true;
  }
  return queue_.holds(identity) || watch_.isExecuting(identity);
}

bool AlignServer::mustWait(const GoalTicket& ticket) const {
  if (ticket.continuesSession()) return false;
  // Between a plan and the first that waits for its end nobody slips in.
  return watch_.standing() != Standing::Idle || (!queue_.empty() && !current_ && !next_);
}

void AlignServer::takeGoal(GoalTicket::Handle handle) {
  const auto ticket = std::make_shared<GoalTicket>(std::move(handle));
  Ticket waiting;
  Ticket running;
  bool must_wait = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stop_ || ticket->cancelOvertookIt()) {
      waiting = ticket;
    } else if (mustWait(*ticket)) {
      must_wait = true;
    } else {
      waiting = std::exchange(next_, ticket);
      running = current_;
    }
  }
  if (must_wait) return queueUp(ticket);
  changed_.notify_all();
  if (waiting == ticket) {
    end(waiting, "canceled");
  } else if (waiting) {
    displace(waiting);
  }
  if (running) displace(running);
}

void AlignServer::queueUp(const Ticket& ticket) {
  const bool refuses_if_busy = refuses_if_busy_();  // asks the parameter server
  std::string why_not;
  std::optional<Queue::Entry> replaced;
  bool may_stay = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    may_stay = !refuses_if_busy && !watch_.isExecuting(ticket->identity());
    if (queue_.isFull() && !queue_.holds(ticket->identity())) {
      why_not = fmt::format("{}, and {} tasks wait already", watch_.description(), Queue::kMost);
    } else {
      Queue::Entry entry = entryFor(ticket);
      entry.refused_if_busy = refuses_if_busy;
      entry.statuses_before = watch_.statusCount();
      replaced = queue_.add(std::move(entry));
      showQueue();
    }
  }
  changed_.notify_all();
  if (!why_not.empty()) return refuse(ticket, why_not);
  if (replaced) displace(replaced->ticket);
  if (!may_stay) return;
  announcer_.tell(fmt::format("{} waits: {}", named(*ticket), watch_.description()));
}

void AlignServer::cancelGoal(const GoalTicket::Handle& handle) {
  Ticket ticket;
  bool waited = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    auto waiting =
        queue_.takeAll([&](const Queue::Entry& entry) { return entry.ticket->isFor(handle); });
    if (!waiting.empty()) {
      ticket = std::move(waiting.front().ticket);
      waited = true;
      showQueue();
    } else if (next_ && next_->isFor(handle)) {
      ticket = std::exchange(next_, nullptr);
    } else if (current_ && current_->isFor(handle)) {
      ticket = current_;
    }
  }
  if (!ticket) return;
  end(ticket, "canceled");
  if (waited) announcer_.tell(fmt::format("{} no longer waits: it was canceled", named(*ticket)));
}

// At once and from this thread: a cancel must not wait for the solver to notice it.
void AlignServer::end(const Ticket& ticket, const std::string& reason) {
  if (!runner_.cancel(*ticket)) return;
  AlignResult result = ticket->interim();
  result.outcome = AlignResult::CANCELED;
  result.message = reason;
  ticket->sendResult(result);
}

void AlignServer::displace(const Ticket& ticket) {
  ticket->displace();
  end(ticket, "displaced by a newer goal");
}

// ~state stays that of the plan under way.
void AlignServer::refuse(const Ticket& ticket, const std::string& reason) {
  if (!ticket->claim()) return;
  AlignResult result = ticket->interim();
  result.outcome = AlignResult::BUSY;
  result.message = reason;
  announcer_.warn(fmt::format("{} is refused ({}): {}", named(*ticket), result.outcome, reason));
  ticket->sendResult(result);
}

void AlignServer::showQueue() {
  const std::vector<WaitingTask> waiting = queue_.shown();
  announcer_.showWaiting(waiting);
  note_waiting_(waiting);
}

void AlignServer::work() {
  while (true) {
    Ticket ticket;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      ticket = current_ = awaitNext(lock);
      if (stop_) return;
    }
    if (!ticket) {
      runner_.answerQuery();
      continue;
    }
    run(*ticket);
    const std::lock_guard<std::mutex> lock(mutex_);
    current_.reset();
  }
}

// Null: it is asked to suppose something, or to end.
AlignServer::Ticket AlignServer::awaitNext(std::unique_lock<std::mutex>& lock) {
  while (!stop_) {
    if (Ticket ticket = takeNext()) return ticket;
    if (runner_.hasQueries()) break;
    const auto until = queue_.empty() ? PlanWatch::Clock::time_point::max() : watch_.nextChange();
    // wait_until() with the largest time point overflows in some standard libraries.
    if (until == PlanWatch::Clock::time_point::max()) {
      changed_.wait(lock);
    } else {
      changed_.wait_until(lock, until);
    }
  }
  return nullptr;
}

AlignServer::Ticket AlignServer::takeNext() {
  // A plan may have gone out since it came.
  if (next_ && !next_->continuesSession() && watch_.standing() != Standing::Idle) {
    queue_.addFirst(entryFor(std::exchange(next_, nullptr)));
    showQueue();
  }
  if (next_) return std::exchange(next_, nullptr);
  if (watch_.standing() != Standing::Idle) return nullptr;
  const std::optional<Queue::Entry> first = queue_.takeFirst();
  if (!first) return nullptr;
  showQueue();
  return first->ticket;
}

// Whatever goes wrong with one goal, the thread is there for the next; a ticket that has no result
// by then gets one when it goes.
void AlignServer::run(GoalTicket& ticket) {
  try {
    runner_.run(ticket);
  } catch (const std::exception& error) {
    ROS_ERROR("a goal was aborted: %s", error.what());
  }
}

}  // namespace goal_alignment::aligner
