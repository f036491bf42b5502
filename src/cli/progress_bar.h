// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

namespace goal_alignment::cli {

/// One line that tells how far long work is, for people at a terminal.
class ProgressBar {
 public:
  /// Draws on `out`, or nowhere where that is null.
  ProgressBar(std::ostream* out, std::size_t total);
  ~ProgressBar() { erase(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void draw(std::size_t done);
  /// Before anything else is written to the terminal.
  void erase();

 private:
  std::ostream* out_;
  std::size_t total_;
  std::string drawn_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

/// std::cerr where it is a terminal that can draw such a line, and `wanted`; else null.
std::ostream* progressStream(bool wanted);

}  // namespace goal_alignment::cli
