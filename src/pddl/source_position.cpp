// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/source_position.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::pddl {

namespace {

/// Far above any planning task; keeps a wrong path from filling the memory.
constexpr std::uintmax_t kLargestFile = std::uintmax_t{256} << 20U;

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw InputError(path, {}, "can't be read: " + reason);
}

/// The file's size, once it is sure that it can be read whole.
std::uintmax_t checkedSize(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) refuse(path, "no such file");
  if (error) refuse(path, error.message());
  // A pipe or a device might never end.
  if (fs::is_directory(status)) refuse(path, "it is a directory");
  if (!fs::is_regular_file(status)) refuse(path, "it is no regular file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) refuse(path, error.message());
  if (size > kLargestFile) refuse(path, "it is larger than 256 MiB");
  return size;
}

}  // namespace

Source readFile(const std::string& path) {
  Source source{path, std::string(checkedSize(path), '\0')};
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(path, errno != 0 ? std::strerror(errno) : "it can't be opened");
  file.read(source.text.data(), static_cast<std::streamsize>(source.text.size()));
  if (file.bad()) refuse(path, "reading stopped half-way");
  // A file that shrank meanwhile gives what was there.
  source.text.resize(static_cast<std::size_t>(file.gcount()));
  return source;
}

}  // namespace goal_alignment::pddl
