// SPDX-License-Identifier: BSD-3-Clause
#include "question_ids.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "goal_alignment/ros_common/descriptor.h"

namespace goal_alignment::aligner {
namespace {

constexpr std::uint32_t kBlock = 1000;
constexpr std::uint32_t kLargest = 0xF0000000;  // what is larger was not written by us

// An open and locked file; other processes wait for its end.
class LockedFile {
 public:
  explicit LockedFile(const std::string& path) : file_(path, O_RDWR | O_CREAT | O_CLOEXEC, 0644) {
    if (flock(*file_, LOCK_EX) != 0) ros_common::failWithErrno(path);
  }

  // Nothing where the file holds no number.
  std::optional<std::uint32_t> read() const {
    std::array<char, 16> text{};
    const ssize_t count = pread(*file_, text.data(), text.size(), 0);
    std::uint32_t number = 0;
    const char* end = text.data() + std::max<ssize_t>(count, 0);
    const auto result = std::from_chars(text.data(), end, number);
    if (result.ec != std::errc() || number > kLargest) return std::nullopt;
    return number;
  }

  void write(std::uint32_t number) const {
    const std::string text = std::to_string(number) + "\n";
    const bool written =
        pwrite(*file_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size()) &&
        ftruncate(*file_, static_cast<off_t>(text.size())) == 0 && fsync(*file_) == 0;
    if (!written) ros_common::failWithErrno("writing question ids");
  }

 private:
  ros_common::Descriptor file_;
};

// A first guess above what earlier runs without the file can have used: they asked, over the
// years, far less than one question a second.
std::uint32_t secondsOfWallClock() {
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint32_t>(
      std::chrono::duration_cast<std::chrono::seconds>(since_epoch).count());
}

}  // namespace

QuestionIds::QuestionIds(std::string file) : file_(std::move(file)) {
  reserveBlock();
  first_ = next_;
}

std::uint32_t QuestionIds::next() {
  if (next_ == end_) reserveBlock();
  return next_++;
}

void QuestionIds::reserveBlock() {
  const std::uint32_t least = next_ == 0 ? 1 : next_;
  try {
    std::filesystem::create_directories(std::filesystem::path(file_).parent_path());
    const LockedFile file(file_);
    next_ = std::max(file.read().value_or(secondsOfWallClock()), least);
    file.write(next_ + kBlock);
    last_error_.clear();
  } catch (const std::exception& error) {
    last_error_ = error.what();
    next_ = std::max(secondsOfWallClock(), least);
  }
  end_ = next_ + kBlock;
}

}  // namespace goal_alignment::aligner
