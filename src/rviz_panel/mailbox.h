// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QMetaObject>
#include <QObject>
#include <memory>
#include <mutex>
#include <utility>

namespace goal_alignment::rviz_panel {

/// Takes work from other threads to the thread of a QObject, for as long as that lives: threads
/// that hang in a call may outlive the panel.
class Mailbox {
 public:
  explicit Mailbox(QObject* owner) : owner_(owner) {}

  /// From any thread; never waits for the owner's.
  template <typename Work>
  void post(Work work) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (owner_ != nullptr) QMetaObject::invokeMethod(owner_, std::move(work), Qt::QueuedConnection);
  }

  /// By the owner, before it goes.
  void close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    owner_ = nullptr;
  }

 private:
  std::mutex mutex_;
  QObject* owner_;
};

using MailboxPtr = std::shared_ptr<Mailbox>;

}  // namespace goal_alignment::rviz_panel
