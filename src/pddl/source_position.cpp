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
/// Of a pipe all must be read to know.
constexpr std::uintmax_t kLargestPipe = std::uintmax_t{64} << 20U;

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw InputError(path, {}, "can't be read: " + reason);
}

/// Of what is there and no folder.
std::filesystem::file_type typeOf(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) refuse(path, "no such file");
  if (error) refuse(path, error.message());
  if (fs::is_directory(status)) refuse(path, "it is a directory");
  return status.type();
}

/// The file's size, once it is sure that it can be read whole.
std::uintmax_t checkedSize(const std::string& path) {
  // A pipe or a device might never end.
  if (typeOf(path) != std::filesystem::file_type::regular) refuse(path, "it is no regular file");
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) refuse(path, error.message());
  if (size > kLargestFile) refuse(path, "it is larger than 256 MiB");
  return size;
}

std::ifstream opened(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(path, errno != 0 ? std::strerror(errno) : "it can't be opened");
  return file;
}

/// The next bytes, at most so many.
void append(std::ifstream& file, const std::string& path, std::size_t most, std::string& text) {
  const std::size_t before = text.size();
  text.resize(before + most);
  file.read(text.data() + before, static_cast<std::streamsize>(most));
  if (file.bad()) refuse(path, "reading stopped half-way");
  text.resize(before + static_cast<std::size_t>(file.gcount()));
}

}  // namespace

Source readFile(const std::string& path) {
  const std::uintmax_t size = checkedSize(path);
  std::ifstream file = opened(path);
  Source source{path, {}};
  // A file that shrank meanwhile gives what was there.
  append(file, path, static_cast<std::size_t>(size), source.text);
  return source;
}

Source readFileOrPipe(const std::string& path) {
  using std::filesystem::file_type;
  const file_type type = typeOf(path);
  if (type != file_type::fifo && type != file_type::character) return readFile(path);
  constexpr std::size_t kAtOnce = std::size_t{64} << 10U;
  std::ifstream file = opened(path);
  Source source{path, {}};
  while (file) {
    append(file, path, kAtOnce, source.text);
    if (source.text.size() > kLargestPipe) refuse(path, "more than 64 MiB come out of it");
  }
  return source;
}

}  // namespace goal_alignment::pddl
