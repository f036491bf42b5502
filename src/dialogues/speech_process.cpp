// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/dialogues/speech_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <thread>

namespace goal_alignment::dialogues {
namespace {

constexpr std::chrono::milliseconds kPatience{300};  // for the polite way
constexpr std::chrono::milliseconds kPoll{5};

void check(int error, const char* what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

// Reads nothing, keeps no file of ours open but the terminal's.
class FileActions {
 public:
  FileActions() {
    check(posix_spawn_file_actions_init(&actions_), "posix_spawn_file_actions_init");
    check(posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0),
          "posix_spawn_file_actions_addopen");
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 34)
    check(posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1),
          "posix_spawn_file_actions_addclosefrom_np");
#endif
  }
  ~FileActions() {
    posix_spawn_file_actions_destroy(&actions_);
  }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;

  const posix_spawn_file_actions_t* get() const {
    return &actions_;
  }

 private:
  posix_spawn_file_actions_t actions_{};
};

// A process group of its own, all signals as a program expects them.
class Attributes {
 public:
  Attributes() {
    check(posix_spawnattr_init(&attributes_), "posix_spawnattr_init");
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~Attributes() { posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

}  // namespace

SpeechProcess::~SpeechProcess() {
  stop();
}

bool SpeechProcess::start(const std::vector<std::string>& command) {
  stop();
  std::vector<char*> arguments;
  for (const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));  // NOLINT: execve() changes nothing
  arguments.push_back(nullptr);
  const FileActions files;
  const Attributes attributes;
  const int error = posix_spawnp(&process_, arguments.front(), files.get(), attributes.get(),
                                 arguments.data(), environ);
  if (error != 0) process_ = 0;
  if (error == ENOENT) return false;
  check(error, command.front().c_str());
  return true;
}

bool SpeechProcess::isRunning() {
  return process_ != 0 && !waitAtMost(std::chrono::milliseconds(0));
}

void SpeechProcess::stop() {
  if (process_ == 0) return;
  const pid_t group = process_;
  kill(-group, SIGTERM);
  if (!waitAtMost(kPatience)) {
    kill(-group, SIGKILL);
    while (!waitAtMost(kPatience)) {
    }
  }
}

// True as soon as it has ended. What it has started and left behind goes as well.
bool SpeechProcess::waitAtMost(std::chrono::milliseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (true) {
    int status = 0;
    const pid_t ended = waitpid(process_, &status, WNOHANG);
    if (ended == process_ || (ended < 0 && errno != EINTR)) {
      last_status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      kill(-process_, SIGKILL);
      process_ = 0;
      return true;
    }
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(kPoll);
  }
}

}  // namespace goal_alignment::dialogues
