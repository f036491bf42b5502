// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/dialogues/line_reader.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

namespace goal_alignment::dialogues {
namespace {

constexpr std::size_t kLongestLine = 4096;  // what is longer is no answer of a person

}  // namespace

LineReader::LineReader(int input, int wake)
    : input_(input), wake_(wake), terminal_(isatty(input) != 0) {}

void LineReader::wait(std::chrono::milliseconds at_most) {
  const bool wants_input = !ended_ && (terminal_ || lines_.empty());
  std::array<pollfd, 2> descriptors{};
  descriptors[0].fd = wants_input ? input_ : -1;  // poll() skips negative descriptors
  descriptors[0].events = POLLIN;
  descriptors[1].fd = wake_;
  descriptors[1].events = POLLIN;
  if (poll(descriptors.data(), descriptors.size(), static_cast<int>(at_most.count())) <= 0) return;
  if (descriptors[1].revents != 0) {
    std::array<char, 64> bytes{};
    (void)!read(wake_, bytes.data(), bytes.size());
  }
  if (descriptors[0].revents != 0) readAvailable();
}

void LineReader::readAvailable() {
  std::array<char, 1024> bytes{};
  const ssize_t count = read(input_, bytes.data(), bytes.size());
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (count <= 0) {  // a terminal that went away reads as an error, not as an end
    ended_ = true;
    if (!partial_.empty()) lines_.push_back(std::exchange(partial_, {}));
    return;
  }
  partial_.append(bytes.data(), static_cast<std::size_t>(count));
  cutLines();
}

void LineReader::cutLines() {
  std::size_t begin = 0;
  for (std::size_t end = partial_.find('\n'); end != std::string::npos;
       end = partial_.find('\n', begin)) {
    lines_.push_back(partial_.substr(begin, end - begin));
    begin = end + 1;
  }
  partial_.erase(0, begin);
  if (partial_.size() > kLongestLine) partial_.resize(kLongestLine);
}

std::optional<std::string> LineReader::nextLine() {
  if (lines_.empty()) return std::nullopt;
  std::string line = std::move(lines_.front());
  lines_.pop_front();
  return line;
}

}  // namespace goal_alignment::dialogues
