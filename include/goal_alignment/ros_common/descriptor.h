// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <string>

namespace goal_alignment::ros_common {

/// Throws std::system_error for errno, whose what() begins with these words.
[[noreturn]] void failWithErrno(const std::string& what);

/// An open file, closed at the end.
class Descriptor {
 public:
  /// As open(2); throws std::system_error that names the path.
  Descriptor(const std::string& path, int flags, mode_t mode = 0600);
  ~Descriptor();
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int operator*() const { return number_; }

 private:
  int number_;
};

}  // namespace goal_alignment::ros_common
