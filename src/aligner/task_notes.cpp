// SPDX-License-Identifier: BSD-3-Clause
#include "task_notes.h"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "file_of_robot.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_common/durable_file.h"

namespace goal_alignment::aligner {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

json toJson(const TaskNotes::Task& task) {
  return {{"session_id", task.session_id}, {"task_id", task.task_id}, {"person", task.person}};
}

TaskNotes::Task taskOf(const json& note) {
  return {note.at("session_id"), note.at("task_id"), note.at("person")};
}

}  // namespace

TaskNotes::TaskNotes(const std::string& folder, const std::string& robot, ErrorCallback complain)
    : file_(fileOfRobot(folder, robot)), report_error_(std::move(complain)) {}

void TaskNotes::begin(const Task& task) {
  const std::lock_guard<std::mutex> lock(mutex_);
  now_.running = task;
  write();
}

void TaskNotes::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  now_.running.reset();
  write();
}

void TaskNotes::setWaiting(std::vector<Task> tasks) {
  const std::lock_guard<std::mutex> lock(mutex_);
  now_.waiting = std::move(tasks);
  write();
}

void TaskNotes::write() {
  if (!now_.running && now_.waiting.empty()) {
    std::error_code gone;
    if (std::exchange(noted_, false)) fs::remove(file_, gone);
    return;
  }
  json note = {{"waiting", json::array()}};
  if (now_.running) note["running"] = toJson(*now_.running);
  for (const Task& task : now_.waiting)
    note["waiting"].push_back(toJson(task));
  try {
    ros_common::replaceFile(file_, note.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
    noted_ = true;
  } catch (const std::exception& error) {
    if (!std::exchange(complained_, true))
      report_error_(fmt::format("the running task can't be recorded: {}", error.what()));
  }
}

TaskNotes::Tasks TaskNotes::takeLost() {
  std::error_code none;
  if (!fs::exists(file_, none)) return {};
  Tasks tasks;
  try {
    const json note = json::parse(pddl::readFile(file_).text);
    if (note.contains("running")) tasks.running = taskOf(note.at("running"));
    for (const json& task : note.at("waiting"))
      tasks.waiting.push_back(taskOf(task));
  } catch (const std::exception& error) {
    tasks = {};
    report_error_(fmt::format("the record of running tasks can't be read: {}", error.what()));
  }
  fs::remove(file_, none);
  return tasks;
}

}  // namespace goal_alignment::aligner
