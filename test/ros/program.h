// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

#include "scenario.h"

namespace goal_alignment::test {

/// A process that the scenario starts, so that it can kill it; it ends with this object at the
/// latest.
class Program {
 public:
  /// The environment is ours with these changes. Both outputs are appended to the file.
  Program(const std::string& file, const std::vector<std::string>& arguments,
          const std::map<std::string, std::string>& environment, const std::string& output_file);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void signal(int number) const;
  /// The exit status, 128 + n after signal n, or -1 where it does not end in time.
  int exitStatus(double seconds = kPatience);

 private:
  pid_t pid_ = -1;
  int status_ = -1;
};

/// A folder that vanishes with this object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string textOf(const std::string& file);
void writeText(const std::string& file, const std::string& text);

}  // namespace goal_alignment::test
