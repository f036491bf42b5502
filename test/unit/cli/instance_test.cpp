// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/cli/instance.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "goal_alignment/pddl/exceptions.h"
#include "program.h"

/// Instance folders, and what they take from the folder above.
namespace goal_alignment::cli {
namespace {

using samples::Folder;
using samples::hagl;
using samples::writeDesk;

// The desk's domains and phrases stand in the folder, all else in `desk` below it.
void writeShared(const Folder& folder) {
  writeDesk(folder, "(down b)\n(held a)\n", "desk/");
  for (const char* name : {"robot_domain.pddl", "human_domain.pddl"})
    std::filesystem::rename(folder / ("desk/" + std::string(name)), folder / name);
  folder.write("phrases.yaml", "predicates: {held: '{0} is in my hand'}\n");
}

TEST(InstanceFolder, TakesWhatItLacksFromTheFolderAbove) {
  const Folder folder;
  writeShared(folder);
  for (const std::string& name : {folder / "desk", folder / "desk/", folder / "desk/../desk/."}) {
    const InstanceFiles files = InstanceFiles::of(name);
    EXPECT_EQ(std::filesystem::canonical(files.robot_domain), folder / "robot_domain.pddl") << name;
    EXPECT_EQ(std::filesystem::canonical(files.phrases), folder / "phrases.yaml") << name;
    EXPECT_EQ(std::filesystem::canonical(files.human_plan), folder / "desk/human_plan.txt") << name;
    EXPECT_EQ(hagl({"align", name}).status, 0) << name;
  }
}

TEST(InstanceFolder, WhatItHasItselfCounts) {
  const Folder folder;
  writeShared(folder);
  folder.write("human_plan.txt", "no plan at all");
  folder.write("desk/phrases.yaml", "{}");
  const InstanceFiles files = InstanceFiles::of(folder / "desk");
  EXPECT_EQ(files.human_plan, folder / "desk/human_plan.txt");
  EXPECT_EQ(files.phrases, folder / "desk/phrases.yaml");
}

TEST(InstanceFolder, AnErrorNamesBothPlaces) {
  const Folder folder;
  writeShared(folder);
  std::filesystem::remove(folder / "robot_domain.pddl");
  try {
    InstanceFiles::of(folder / "desk");
    FAIL() << "there is no robot_domain.pddl";
  } catch (const pddl::InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("robot_domain.pddl"), std::string::npos) << text;
    EXPECT_EQ(text.find(folder / "desk"), 0U) << text;
    EXPECT_NE(text.find("above, " + folder.path()), std::string::npos) << text;
  }
}

TEST(InstanceFolder, TheTrueGoalAndThePhrasesMayBeNowhere) {
  const Folder folder;
  writeDesk(folder, "", "lonely/desk/");
  const InstanceFiles files = InstanceFiles::of(folder / "lonely/desk");
  EXPECT_EQ(files.true_goal, "");
  EXPECT_EQ(files.phrases, "");
}

TEST(InstanceFoldersBelow, LeaveOutFoldersThatOnlyLend) {
  const Folder folder;
  writeShared(folder);
  writeDesk(folder, "", "own/");
  writeDesk(folder, "", "own/deeper/");
  const std::vector<std::filesystem::path> expected = {folder / "desk", folder / "own",
                                                       folder / "own/deeper"};
  EXPECT_EQ(instanceFoldersBelow(folder.path()), expected);
  EXPECT_EQ(instanceFoldersBelow(folder / "desk").size(), 1U);
  EXPECT_EQ(hagl({"bench", folder.path(), "--runs", "1", "--truth", "0.5"}).status, 0);
}

TEST(InstanceFoldersBelow, AFolderWithoutAPlanIsOneThatDoesNotRun) {
  const Folder folder;
  writeDesk(folder, "", "desk/");
  std::filesystem::remove(folder / "desk/human_plan.txt");
  EXPECT_EQ(instanceFoldersBelow(folder.path()).size(), 1U);
  EXPECT_NE(hagl({"bench", folder.path(), "--runs", "1", "--truth", "0.5"}).status, 0);
}

}  // namespace
}  // namespace goal_alignment::cli
