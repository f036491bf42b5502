// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace goal_alignment::pddl {

/// A text to be read, with the name that errors give it (a file name, or what the text is for).
struct Source {
  std::string name;
  std::string text;
};

/// Reads a file whole. Throws InputError for what is no readable regular file.
Source readFile(const std::string& path);

/// The same, and for a pipe or a device (`<(…)`, /dev/stdin) all that comes until its end, up to
/// 64 MiB. Waits for whoever writes, so it is for what a person typed.
Source readFileOrPipe(const std::string& path);

/// Where something stands; lines and columns count from 1. Line 0: nowhere in particular.
struct SourcePosition {
  int line = 0;
  int column = 0;
};

}  // namespace goal_alignment::pddl
