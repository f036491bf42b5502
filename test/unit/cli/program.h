// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "generators/dialogue_tasks.h"
#include "unit/alignment/samples.h"

/// The program `hagl` run as a process, and files for it to read.
namespace goal_alignment::cli::samples {

namespace fs = std::filesystem;

/// A folder that goes when the test does.
class Folder {
 public:
  Folder() {
    static std::atomic<int> count{0};
    path_ = fs::path(testing::TempDir()) /
            ("hagl_test_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string path() const { return path_.string(); }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories(fs::path(*this / name).parent_path());
    std::ofstream(*this / name) << text;
  }
  std::string read(const std::string& name) const {
    std::stringstream text;
    text << std::ifstream(*this / name).rdbuf();
    return text.str();
  }

 private:
  fs::path path_;
};

/// Writes the task of unit/alignment/samples.h as an instance folder.
inline void writeDesk(const Folder& folder, const std::string& true_goal,
                      const std::string& below = "") {
  using namespace goal_alignment::samples;
  folder.write(below + "robot_domain.pddl", kDeskRobotDomain);
  folder.write(below + "human_domain.pddl", kDeskHumanDomain);
  folder.write(below + "robot_problem.pddl", kDeskProblem);
  folder.write(below + "human_problem.pddl", kDeskProblem);
  folder.write(below + "human_plan.txt", "; take both\n(take A)\n(take B)\n");
  if (!true_goal.empty()) folder.write(below + "true_goal.txt", true_goal);
}

struct Ended {
  int status = -1;  ///< exit status; 128 + n: ended by signal n
  std::string out;
  std::string err;

  nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// One run of hagl. Its output goes to files, so that it never waits for us to read.
class Program {
 public:
  explicit Program(std::vector<std::string> arguments) {
    int input[2];
    if (pipe2(input, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    input_ = input[1];
    arguments.insert(arguments.begin(), HAGL_PROGRAM);
    std::vector<char*> argv;
    for (std::string& argument : arguments)
      argv.push_back(argument.data());
    argv.push_back(nullptr);
    const std::string out = folder_ / "out";
    const std::string err = folder_ / "err";
    id_ = fork();
    if (id_ != 0) {
      close(input[0]);
      return;
    }
    dup2(input[0], STDIN_FILENO);
    dup2(open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    execv(HAGL_PROGRAM, argv.data());
    _exit(127);
  }
  ~Program() {
    if (id_ > 0) kill(id_, SIGKILL);
    if (id_ > 0) wait();
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void type(const std::string& text) const {
    if (write(input_, text.data(), text.size()) < 0) throw std::runtime_error("nobody reads");
  }
  void signal(int number) const { kill(id_, number); }

  /// Waits until it has used up some processor time: it is in the middle of its work then, however
  /// busy the machine. False when it never does.
  bool works() const {
    const long enough = sysconf(_SC_CLK_TCK) / 4;
    for (int i = 0; i < 6000; ++i) {
      std::ifstream stat("/proc/" + std::to_string(id_) + "/stat");
      std::string field;
      for (int n = 0; n < 14; ++n)
        stat >> field;  // the 14th: user time
      if (stat && std::stol(field) >= enough) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  /// Waits until stderr has the text; false when it never comes.
  bool says(const std::string& text) const {
    for (int i = 0; i < 6000; ++i) {
      if (folder_.read("err").find(text) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  /// Ends its input and waits for its end.
  Ended wait() {
    close(input_);
    return waitWithInputOpen();
  }
  Ended waitWithInputOpen() {
    int status = 0;
    waitpid(id_, &status, 0);
    id_ = 0;
    const int exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {exit_status, folder_.read("out"), folder_.read("err")};
  }

 private:
  Folder folder_;
  pid_t id_ = 0;
  int input_ = -1;
};

inline Ended hagl(const std::vector<std::string>& arguments, const std::string& input = "") {
  Program program(arguments);
  if (!input.empty()) program.type(input);
  return program.wait();
}

/// A sliding puzzle with two tiles swapped: a search that goes on for ever, as far as a person is
/// concerned. As an alignment, in which the person believes that tiles can be swapped:
inline void writeEndless(const Folder& folder) {
  const session::Input input = benchmarks::swappedTiles(4);
  folder.write("robot_domain.pddl", input.robot_domain.text);
  folder.write("human_domain.pddl", input.human_domain.text);
  folder.write("robot_problem.pddl", input.robot_problem.text);
  folder.write("human_problem.pddl", input.human_problem.text);
  folder.write("human_plan.txt", input.human_plan.front().text() + "\n");
  folder.write("true_goal.txt", "(at t1 c2)\n");
}

/// As a planning task: d.pddl and p.pddl, whose goal names the place of every tile.
inline void writeEndlessTask(const Folder& folder) {
  const session::Input input = benchmarks::swappedTiles(4);
  std::string goal = "(at t1 c2) (at t2 c1)";
  for (int i = 3; i < 16; ++i)
    goal += " (at t" + std::to_string(i) + " c" + std::to_string(i) + ")";
  std::string problem = input.robot_problem.text;
  problem.replace(problem.rfind("(at t1 c2)"), 10, goal);
  folder.write("d.pddl", input.robot_domain.text);
  folder.write("p.pddl", problem);
}

}  // namespace goal_alignment::cli::samples
