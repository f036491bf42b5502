// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/under_way.h"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "durable_file.h"
#include "file_of_robot.h"
#include "goal_alignment/pddl/source_position.h"

namespace goal_alignment::ros_interface {

namespace fs = std::filesystem;
using nlohmann::json;

UnderWay::UnderWay(const std::string& folder, const std::string& robot, Complain complain)
    : file_(fileOfRobot(folder, robot)), complain_(std::move(complain)) {}

void UnderWay::begin(const Task& task) {
  const json note = {
      {"session_id", task.session_id}, {"task_id", task.task_id}, {"person", task.person}};
  try {
    replaceFile(file_, note.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
    noted_ = true;
  } catch (const std::exception& error) {
    if (!std::exchange(complained_, true))
      complain_(fmt::format("the task under way can't be noted: {}", error.what()));
  }
}

void UnderWay::end() {
  std::error_code gone;
  if (std::exchange(noted_, false)) fs::remove(file_, gone);
}

std::optional<UnderWay::Task> UnderWay::lost() {
  std::error_code none;
  if (!fs::exists(file_, none)) return std::nullopt;
  std::optional<Task> task;
  try {
    const json note = json::parse(pddl::readFile(file_).text);
    task = Task{note.at("session_id"), note.at("task_id"), note.at("person")};
  } catch (const std::exception& error) {
    complain_(
        fmt::format("the note of the task that was under way can't be read: {}", error.what()));
  }
  fs::remove(file_, none);
  return task;
}

}  // namespace goal_alignment::ros_interface
