// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/source_position.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "unit/pddl/samples.h"

namespace goal_alignment::pddl {
namespace {

namespace fs = std::filesystem;

class ReadFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string error(const std::string& path) const {
    return samples::errorOf<InputError>([&] { readFile(path); });
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("goal_alignment_read_file_" + std::to_string(getpid()));
};

TEST_F(ReadFile, GivesEveryByte) {
  const std::string bytes("(a)\r\n\0\xff b", 9);
  std::ofstream(path("a.pddl"), std::ios::binary) << bytes;
  const Source source = readFile(path("a.pddl"));
  EXPECT_EQ(source.name, path("a.pddl"));
  EXPECT_EQ(source.text, bytes);
}

TEST_F(ReadFile, AnEmptyFileIsAnEmptyText) {
  std::ofstream(path("empty")).flush();
  EXPECT_EQ(readFile(path("empty")).text, "");
}

TEST_F(ReadFile, NamesThePathAndTheReason) {
  EXPECT_EQ(error(path("none")), path("none") + ": can't be read: no such file");
  EXPECT_EQ(error(path("none/below")), path("none/below") + ": can't be read: no such file");
  EXPECT_EQ(error(folder_.string()), folder_.string() + ": can't be read: it is a directory");
  EXPECT_EQ(error("/dev/null"), "/dev/null: can't be read: it is no regular file");
  EXPECT_EQ(error(""), ": can't be read: no such file");
}

TEST_F(ReadFile, APipeIsReadToItsEndWhereThatIsWanted) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(error(path("pipe")), path("pipe") + ": can't be read: it is no regular file");
  const std::string text(300'000, 'x');  // more than a pipe holds
  std::thread writer([&] { std::ofstream(path("pipe")) << text; });
  const Source source = readFileOrPipe(path("pipe"));
  writer.join();
  EXPECT_EQ(source.name, path("pipe"));
  EXPECT_EQ(source.text, text);
  EXPECT_EQ(readFileOrPipe("/dev/null").text, "");
}

TEST_F(ReadFile, WhatIsNoPipeIsReadLikeAFile) {
  const auto refused = [](const std::string& path) {
    return samples::errorOf<InputError>([&] { readFileOrPipe(path); });
  };
  std::ofstream(path("plan")) << "(go a)";
  EXPECT_EQ(readFileOrPipe(path("plan")).text, "(go a)");
  EXPECT_EQ(refused(path("none")), path("none") + ": can't be read: no such file");
  EXPECT_EQ(refused(folder_.string()), folder_.string() + ": can't be read: it is a directory");
  EXPECT_EQ(refused("/dev/zero"), "/dev/zero: can't be read: more than 64 MiB come out of it");
}

TEST_F(ReadFile, RefusesWhatIsTooLarge) {
  std::ofstream(path("huge")).flush();
  fs::resize_file(path("huge"), (std::uintmax_t{256} << 20U) + 1);  // sparse: takes no disk
  EXPECT_EQ(error(path("huge")), path("huge") + ": can't be read: it is larger than 256 MiB");
}

TEST_F(ReadFile, RefusesWhatMayNotBeRead) {
  std::ofstream(path("secret")) << "x";
  fs::permissions(path("secret"), fs::perms::none);
  const uid_t user = geteuid();
  const bool root = user == 0;  // who may read everything, so become nobody for a moment
  constexpr uid_t kNobody = 65534;
  if (root && seteuid(kNobody) != 0) GTEST_SKIP() << "root may read everything";
  const std::string message = error(path("secret"));
  if (root) {
    ASSERT_EQ(seteuid(user), 0);
  }
  EXPECT_EQ(message, path("secret") + ": can't be read: Permission denied");
}

TEST(InputError, GivesNoPositionWhereThereIsNone) {
  EXPECT_EQ(std::string(InputError("f", {}, "m").what()), "f: m");
  const InputError error("f", {3, 4}, "m");
  EXPECT_EQ(std::string(error.what()), "f:3:4: m");
  EXPECT_EQ(error.sourceName(), "f");
  EXPECT_EQ(error.position().line, 3);
  EXPECT_EQ(error.position().column, 4);
}

}  // namespace
}  // namespace goal_alignment::pddl
