// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

namespace goal_alignment::rviz_panel {

/// Does jobs one after the other in a thread of its own. A job may hang, for roscpp waits for a
/// master that is gone: nobody ever waits for it, and the thread ends by itself after its last job.
class AbandonableWorker {
 public:
  AbandonableWorker();
  ~AbandonableWorker();
  AbandonableWorker(const AbandonableWorker&) = delete;
  AbandonableWorker& operator=(const AbandonableWorker&) = delete;

  /// Jobs own what they use. Those that have not begun when the worker goes are still done.
  void add(std::function<void()> job);

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

}  // namespace goal_alignment::rviz_panel
