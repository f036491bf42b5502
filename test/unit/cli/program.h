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

/// Three things wanted in two places, beside 30 switches that have nothing to do with it: a search
/// that goes on for ever, as far as a person is concerned. FULL stands where the robot fills
/// places.
inline const std::string kEndlessDomain = R"((define (domain endless)
  (:predicates (on ?x) (place ?x) (thing ?x) (full ?p) (stowed ?x) (switch ?x))
  (:action stow :parameters (?x ?p) :precondition (and (thing ?x) (place ?p) (not (full ?p)))
    :effect (and (stowed ?x) FULL))
  (:action flip :parameters (?x) :precondition (and (switch ?x) (not (on ?x))) :effect (on ?x))
  (:action flop :parameters (?x) :precondition (and (switch ?x) (on ?x)) :effect (not (on ?x)))))";

inline std::string endlessDomain(const std::string& full) {
  std::string text = kEndlessDomain;
  return text.replace(text.find("FULL"), 4, full);
}

inline std::string endlessProblem(const std::string& goal) {
  std::string objects;
  std::string init;
  for (int i = 0; i < 30; ++i) {
    objects += " s" + std::to_string(i);
    init += " (switch s" + std::to_string(i) + ")";
  }
  return "(define (problem p) (:domain endless) (:objects a b c p q" + objects +
         ") (:init (thing a) (thing b) (thing c) (place p) (place q)" + init + ") (:goal " + goal +
         "))";
}

inline void writeEndless(const Folder& folder) {
  folder.write("robot_domain.pddl", endlessDomain("(full ?p)"));
  folder.write("human_domain.pddl", endlessDomain(""));
  folder.write("robot_problem.pddl", endlessProblem("(and)"));
  folder.write("human_problem.pddl", endlessProblem("(and)"));
  folder.write("human_plan.txt", "(stow a p)\n(stow b p)\n(stow c p)\n");
  folder.write("true_goal.txt", "(stowed a)\n");
}

}  // namespace goal_alignment::cli::samples
