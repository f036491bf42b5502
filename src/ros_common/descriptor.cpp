// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_common/descriptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace goal_alignment::ros_common {

void failWithErrno(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

Descriptor::Descriptor(const std::string& path, int flags, mode_t mode)
    : number_(open(path.c_str(), flags, mode)) {
  if (number_ < 0) failWithErrno(path);
}

Descriptor::~Descriptor() {
  close(number_);
}

}  // namespace goal_alignment::ros_common
