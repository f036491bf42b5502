// SPDX-License-Identifier: BSD-3-Clause
#include "child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <system_error>

namespace goal_alignment::benchmarks {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
}

void writeAll(int pipe_end, const std::string& text) {
  for (std::size_t written = 0; written < text.size();) {
    const ssize_t count = ::write(pipe_end, text.data() + written, text.size() - written);
    if (count < 0 && errno != EINTR) return;  // nobody reads any more
    if (count > 0) written += static_cast<std::size_t>(count);
  }
}

// A sanitizer's shadow takes more address space than any limit leaves.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kAddressSpaceIsOurs = false;
#else
constexpr bool kAddressSpaceIsOurs = true;
#endif

[[noreturn]] void beChild(const std::function<void(Record&, const Save&)>& work,
                          const HardLimits& limits, int out) {
  const rlim_t bytes = static_cast<rlim_t>(limits.mebibytes) << 20U;
  const rlimit memory = {bytes, bytes};
  if (kAddressSpaceIsOurs) ::setrlimit(RLIMIT_AS, &memory);
  const rlimit no_core = {0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  Record record;
  const Save save = [&] { writeAll(out, record.serialised()); };
  try {
    work(record, save);
  } catch (const std::bad_alloc&) {
    record.set("status", std::string("limit: memory"));
  } catch (const std::exception& exception) {
    record.set("status", std::string("failed"));
    record.set("error", std::string(exception.what()));
  }
  save();
  ::_exit(0);  // without the destructors of what belongs to the parent
}

// What the child writes until it ends; kills it at the deadline. True: it was killed.
bool listen(int in, pid_t child, double seconds, std::string& heard) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(seconds));
  std::array<char, 4096> buffer = {};
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0) {
      ::kill(child, SIGKILL);
      return true;
    }
    pollfd waiting = {in, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, static_cast<int>(std::min<long>(left.count(), 1000)));
    if (ready <= 0) continue;
    const ssize_t count = ::read(in, buffer.data(), buffer.size());
    if (count == 0) return false;
    if (count > 0) heard.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

Record runInChild(const std::function<void(Record&, const Save&)>& work, const HardLimits& limits) {
  std::array<int, 2> ends = {};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe");
  const pid_t child = ::fork();
  if (child < 0) fail("fork");
  if (child == 0) {
    ::close(ends[0]);
    beChild(work, limits, ends[1]);
  }
  ::close(ends[1]);
  std::string heard;
  const bool killed = listen(ends[0], child, limits.seconds, heard);
  ::close(ends[0]);
  int ending = 0;
  rusage usage = {};
  while (::wait4(child, &ending, 0, &usage) < 0) {
    if (errno != EINTR) fail("wait4");
  }
  Record record;
  record.read(heard);
  if (killed) {
    record.set("status", std::string("killed: time"));
  } else if (WIFSIGNALED(ending)) {
    record.set("status", "crashed: signal " + std::to_string(WTERMSIG(ending)));
  }
  record.set("cpu", secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime));
  record.set("peak_mib", static_cast<double>(usage.ru_maxrss) / 1024);
  return record;
}

}  // namespace goal_alignment::benchmarks
