// SPDX-License-Identifier: BSD-3-Clause
#include "progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include <fmt/format.h>

namespace goal_alignment::cli {

namespace {

constexpr std::size_t kCells = 30;

std::string clock(double seconds) {
  const auto whole = static_cast<long>(seconds);
  if (whole >= 3600)
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

ProgressBar::ProgressBar(std::ostream* out, std::size_t total)
    : out_(out), total_(std::max<std::size_t>(total, 1)) {}

void ProgressBar::draw(std::size_t done) {
  if (out_ == nullptr) return;
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - began_;
  done = std::min(done, total_);
  const std::size_t full = kCells * done / total_;
  std::string line =
      fmt::format("[{}{}] {} of {} alignments, {}", std::string(full, '#'),
                  std::string(kCells - full, '.'), done, total_, clock(spent.count()));
  if (done > 0 && done < total_) {
    const double share = static_cast<double>(done) / static_cast<double>(total_);
    line += fmt::format(", about {} left", clock(spent.count() * (1 - share) / share));
  }
  if (line == drawn_) return;
  *out_ << "\r" << line << "\x1b[K" << std::flush;
  drawn_ = line;
}

void ProgressBar::erase() {
  if (!drawn_.empty()) *out_ << "\r\x1b[K" << std::flush;
  drawn_.clear();
}

std::ostream* progressStream(bool wanted) {
  const char* terminal = std::getenv("TERM");
  const bool draws = terminal != nullptr && std::string(terminal) != "dumb";
  return wanted && draws && ::isatty(STDERR_FILENO) == 1 ? &std::cerr : nullptr;
}

}  // namespace goal_alignment::cli
