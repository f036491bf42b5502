// SPDX-License-Identifier: BSD-3-Clause
#include "taken_tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <utility>

#include "goal_alignment/ros_common/durable_file.h"

namespace goal_alignment::aligner {
namespace {

constexpr std::size_t kMaxKeys = 100;

}  // namespace

TakenTasks::TakenTasks(std::string file, ErrorCallback complain)
    : file_(std::move(file)), report_error_(std::move(complain)) {
  std::ifstream input(file_);
  for (std::string key; std::getline(input, key);) {
    keys_.push_back(key);
    if (keys_.size() > kMaxKeys) keys_.pop_front();
  }
}

bool TakenTasks::knows(const std::string& key) const {
  return std::find(keys_.begin(), keys_.end(), key) != keys_.end();
}

void TakenTasks::add(const std::string& key) {
  if (knows(key)) return;
  keys_.push_back(key);
  if (keys_.size() > kMaxKeys) keys_.pop_front();
  try {
    write();
  } catch (const std::exception& error) {
    if (!std::exchange(complained_, true)) {
      report_error_(
          fmt::format("latched tasks may be taken up again after a restart: {}", error.what()));
    }
  }
}

void TakenTasks::write() const {
  std::string text;
  for (const std::string& key : keys_)
    text += key + "\n";
  ros_common::replaceFile(file_, text);
}

}  // namespace goal_alignment::aligner
