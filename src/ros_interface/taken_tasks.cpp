// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/taken_tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <utility>

namespace goal_alignment::ros_interface {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostKeys = 100;
constexpr const char* kNewSuffix = ".new";

}  // namespace

TakenTasks::TakenTasks(std::string file, Complain complain)
    : file_(std::move(file)), complain_(std::move(complain)) {
  std::ifstream input(file_);
  for (std::string key; std::getline(input, key);) {
    keys_.push_back(key);
    if (keys_.size() > kMostKeys) keys_.pop_front();
  }
}

bool TakenTasks::knows(const std::string& key) const {
  return std::find(keys_.begin(), keys_.end(), key) != keys_.end();
}

void TakenTasks::add(const std::string& key) {
  if (knows(key)) return;
  keys_.push_back(key);
  if (keys_.size() > kMostKeys) keys_.pop_front();
  try {
    write();
  } catch (const std::exception& error) {
    if (!std::exchange(complained_, true)) {
      complain_(
          fmt::format("latched tasks may be taken up again after a restart: {}", error.what()));
    }
  }
}

void TakenTasks::write() {
  fs::create_directories(fs::path(file_).parent_path());
  const std::string fresh = file_ + kNewSuffix;
  std::ofstream output;
  output.exceptions(std::ios::failbit | std::ios::badbit);
  output.open(fresh);
  for (const std::string& key : keys_)
    output << key << '\n';
  output.close();
  fs::rename(fresh, file_);
}

}  // namespace goal_alignment::ros_interface
