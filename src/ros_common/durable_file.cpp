// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_common/durable_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "goal_alignment/ros_common/descriptor.h"

namespace goal_alignment::ros_common {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDamagedSuffix = ".damaged";
constexpr const char* kNewSuffix = ".new";

void writeAll(int descriptor, const std::string& text, const std::string& path) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR) failWithErrno(path);
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

}  // namespace

// The rename is the moment at which the new text stands for the old one.
void replaceFile(const std::string& path, const std::string& text) {
  fs::create_directories(fs::path(path).parent_path());
  // Of this process alone: another robot's aligner may share the folder.
  const std::string fresh = path + kNewSuffix + std::to_string(getpid());
  {
    const Descriptor file(fresh, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC);
    writeAll(*file, text, fresh);
    if (fsync(*file) != 0) failWithErrno(fresh);
  }
  fs::rename(fresh, path);
  const Descriptor folder(fs::path(path).parent_path(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  fsync(*folder);  // some file systems can't; the text is safe in either case
}

std::string asideOf(const std::string& path) {
  return path + kDamagedSuffix;
}

std::string setAside(const std::string& path) {
  std::error_code failed;
  fs::rename(path, asideOf(path), failed);
  return failed ? "can't be set aside" : "set aside as " + asideOf(path);
}

}  // namespace goal_alignment::ros_common
