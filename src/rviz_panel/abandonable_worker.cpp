// SPDX-License-Identifier: BSD-3-Clause
#include "abandonable_worker.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace goal_alignment::rviz_panel {

struct AbandonableWorker::Shared {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::function<void()>> jobs;
  bool ended = false;

  void work() {
    while (true) {
      std::function<void()> job;
      {
        std::unique_lock<std::mutex> lock(mutex);
        changed.wait(lock, [this] { return ended || !jobs.empty(); });
        if (jobs.empty()) return;
        job = std::move(jobs.front());
        jobs.pop_front();
      }
      job();
    }
  }
};

AbandonableWorker::AbandonableWorker() : shared_(std::make_shared<Shared>()) {
  std::thread([shared = shared_] { shared->work(); }).detach();
}

AbandonableWorker::~AbandonableWorker() {
  {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    shared_->ended = true;
  }
  shared_->changed.notify_all();
}

void AbandonableWorker::add(std::function<void()> job) {
  {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    shared_->jobs.push_back(std::move(job));
  }
  shared_->changed.notify_all();
}

}  // namespace goal_alignment::rviz_panel
