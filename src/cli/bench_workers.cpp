// SPDX-License-Identifier: BSD-3-Clause
#include "bench_workers.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace goal_alignment::cli {

namespace {

/// A cancel takes effect within this time, and the bar moves as often.
constexpr std::chrono::milliseconds kTick{50};

class Workers {
 public:
  Workers(const std::vector<InstanceFolder>& instances, const BenchPlan& plan)
      : instances_(instances), plan_(plan), results_(instances.size()) {}
  ~Workers() {
    sessions_.cancelAll();
    for (std::thread& thread : threads_)
      thread.join();
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  void start(int count) {
    const std::size_t most = std::min(static_cast<std::size_t>(count), instances_.size());
    for (std::size_t i = 0; i < most; ++i)
      threads_.emplace_back([this] { work(); });
  }

  void cancel() { sessions_.cancelAll(); }

  /// The next result in order, if it is there or comes within a tick.
  std::optional<InstanceResult> next() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, kTick, [this] { return thrown_ || results_[reported_]; });
    if (thrown_) std::rethrow_exception(thrown_);
    if (!results_[reported_]) return std::nullopt;
    return std::exchange(results_[reported_++], std::nullopt);
  }
  bool finished() const { return reported_ == instances_.size(); }

  std::size_t alignments() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return alignments_;
  }

 private:
  void work() {
    try {
      for (std::optional<std::size_t> i = take(); i; i = take()) {
        set(*i, measureInstance(instances_[*i], plan_, sessions_, [this](std::size_t count) {
          const std::lock_guard<std::mutex> lock(mutex_);
          alignments_ += count;
        }));
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      thrown_ = std::current_exception();
    }
    changed_.notify_one();
  }

  std::optional<std::size_t> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (taken_ == instances_.size()) return std::nullopt;
    return taken_++;
  }

  void set(std::size_t i, InstanceResult result) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      results_[i] = std::move(result);
    }
    changed_.notify_one();
  }

  const std::vector<InstanceFolder>& instances_;
  const BenchPlan& plan_;
  RunningSessions sessions_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::optional<InstanceResult>> results_;  // until they are reported
  std::size_t reported_ = 0;                            // of the calling thread alone
  std::size_t taken_ = 0;
  std::size_t alignments_ = 0;
  std::exception_ptr thrown_;
  std::vector<std::thread> threads_;
};

}  // namespace

void measureAll(const std::vector<InstanceFolder>& instances, const BenchPlan& plan, int threads,
                const CancelToken& cancel, ProgressBar& bar,
                const std::function<void(InstanceResult)>& report) {
  Workers workers(instances, plan);
  workers.start(threads);
  while (!workers.finished()) {
    if (cancel.cancelled()) workers.cancel();
    if (auto result = workers.next()) {
      bar.erase();
      report(std::move(*result));
    }
    bar.draw(workers.alignments());
  }
}

}  // namespace goal_alignment::cli
