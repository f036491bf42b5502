// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/fact_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace goal_alignment::aligner {
namespace {

namespace fs = std::filesystem;

constexpr double kDay = 86400;  // seconds

session::Input models() {
  session::Input input;
  input.robot_domain.text = "rd";
  input.robot_problem.text = "rp";
  input.human_domain.text = "hd";
  input.human_problem.text = "hp";
  return input;
}

SaidFacts someFacts() {
  SaidFacts facts;
  facts.setRobot(GroundName::parse("(at duck box)"), true, false);
  facts.setRobot(GroundName::parse("(at duck hall)"), false, false);
  facts.setRobot(GroundName::parse("(at robot hall)"), true, true);
  facts.setHuman(GroundName::parse("(at duck hall)"), true);
  return facts;
}

class FactFileTest : public testing::Test {
 protected:
  FactFileTest()
      : folder_(fs::temp_directory_path() / ("fact_file_test." + std::to_string(getpid()))) {}
  ~FactFileTest() override { fs::remove_all(folder_); }

  std::unique_ptr<FactFile> fileOf(const std::string& robot = "/robot1/goal_alignment") {
    return std::make_unique<FactFile>(
        folder_.string(), robot, [this](const std::string& line) { complaints_.push_back(line); });
  }

  void leave(const SaidFacts& facts, const std::string& world = "") {
    const auto file = fileOf();
    file->open(FactScope::of(models(), world), kDay);
    file->write(facts);
  }

  // As after a restart.
  std::optional<FactFile::Kept> taken(const session::Input& now = models(), double expiry = kDay,
                                      const std::string& world = "") {
    complaints_.clear();
    return fileOf()->open(FactScope::of(now, world), expiry);
  }

  bool isComplainedOf(const std::string& part) const {
    return complaints_.size() == 1 && complaints_[0].find(part) != std::string::npos;
  }

  std::string text() const {
    std::stringstream text;
    text << std::ifstream(path()).rdbuf();
    return text.str();
  }

  void overwrite(const std::string& text) const { std::ofstream(path()) << text; }
  fs::path path() const { return folder_ / "robot1.goal_alignment.json"; }

  // The file says that it was written so long ago.
  void makeOlder(int seconds) const {
    nlohmann::json entry = nlohmann::json::parse(text());
    entry["sec"] = entry["sec"].get<std::int64_t>() - seconds;
    overwrite(entry.dump());
  }

  fs::path folder_;
  std::vector<std::string> complaints_;
};

TEST_F(FactFileTest, keepsFactsAcrossARestart) {
  leave(someFacts());
  makeOlder(300);
  const auto kept = taken();
  ASSERT_TRUE(kept);
  EXPECT_TRUE(complaints_.empty());
  EXPECT_GE(kept->age, 300);
  EXPECT_LT(kept->age, 400);
  EXPECT_EQ(kept->facts.ofRobot(), someFacts().ofRobot());
  const auto believed = kept->facts.ofHuman(true);
  const auto expected = someFacts().ofHuman(true);
  ASSERT_EQ(believed.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(believed[i].fact, expected[i].fact);
}

TEST_F(FactFileTest, isOfOneRobot) {
  leave(someFacts());
  EXPECT_FALSE(fileOf("/robot2/goal_alignment")->open(FactScope::of(models(), ""), kDay));
  EXPECT_TRUE(complaints_.empty());
  EXPECT_TRUE(taken());
}

TEST_F(FactFileTest, goesWithTheLastFact) {
  leave(someFacts());
  leave({});
  EXPECT_FALSE(fs::exists(path()));
  EXPECT_FALSE(taken());
}

TEST_F(FactFileTest, isLeftOutWhereAModelHasChangedAndSaysWhich) {
  leave(someFacts());
  session::Input other = models();
  other.human_problem.text += " ";
  EXPECT_FALSE(taken(other));
  EXPECT_TRUE(
      isComplainedOf("(3 of the robot's world, 1 of what the person believes; the last was set"))
      << complaints_.at(0);
  EXPECT_TRUE(isComplainedOf("these have changed: human_problem"));
  other.robot_domain.text = "another";
  EXPECT_FALSE(taken(other));
  EXPECT_TRUE(isComplainedOf("these have changed: robot_domain, human_problem"));
  other = models();
  other.robot_domain.name = "another file of the same text";
  EXPECT_TRUE(taken(other));
}

TEST_F(FactFileTest, holdsForTheModelsThatWereSetLast) {
  session::Input other = models();
  other.robot_problem.text = "another";
  const auto file = fileOf();
  file->open(FactScope::of(models(), ""), kDay);
  file->setScope(FactScope::of(other, ""));
  file->write(someFacts());
  EXPECT_FALSE(taken());
  EXPECT_TRUE(taken(other));
}

TEST_F(FactFileTest, ofAnotherWorldIsLeftOutWithoutAWarning) {
  leave(someFacts(), "simulation 1");
  const auto kept = taken(models(), kDay, "simulation 2");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->facts.size(), 0U);
  EXPECT_NE(kept->line.find("(3 of the robot's world, 1 of"), std::string::npos) << kept->line;
  EXPECT_NE(kept->line.find("another world"), std::string::npos) << kept->line;
  EXPECT_TRUE(complaints_.empty());
  EXPECT_EQ(taken(models(), kDay, "simulation 1")->facts.size(), 4U);
}

TEST_F(FactFileTest, thatIsTooOldIsLeftOut) {
  leave(someFacts());
  makeOlder(7200);
  EXPECT_FALSE(taken(models(), 3600));
  EXPECT_TRUE(isComplainedOf("the last was set 2 h ago) are left out: facts_expiry is 3600 s"));
  EXPECT_TRUE(taken(models(), 10800));
  makeOlder(-20000);
  EXPECT_EQ(taken()->age, 0) << "a clock was set back";
}

TEST_F(FactFileTest, withoutExpiryNothingIsReadOrWritten) {
  leave(someFacts());
  const std::string before = text();
  const auto file = fileOf();
  EXPECT_FALSE(file->open(FactScope::of(models(), ""), 0));
  file->write({});
  EXPECT_EQ(text(), before);
}

TEST_F(FactFileTest, writesNothingBeforeItWasOpened) {
  fileOf()->write(someFacts());
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(FactFileTest, aDamagedFileIsSetAsideWithAWarning) {
  leave(someFacts());
  const std::string good = text();
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  const std::vector<std::string> damaged = {"",
                                            good.substr(0, good.size() / 2),
                                            "[]",
                                            "{}",
                                            replaced("\"version\": 1", "\"version\": 99"),
                                            replaced("/robot1/", "/robot2/"),
                                            replaced("(at duck box)", "(at duck"),
                                            replaced("(at duck box)", "(at robot hall)"),
                                            replaced("\"order\": 1", "\"order\": \"first\""),
                                            replaced("\"sec\": ", "\"sec\": -\"")};
  for (const std::string& each : damaged) {
    overwrite(each);
    EXPECT_FALSE(taken()) << each;
    EXPECT_TRUE(isComplainedOf("is damaged and set aside as ")) << each;
    EXPECT_FALSE(fs::exists(path()));
    EXPECT_TRUE(fs::exists(path().string() + ".damaged"));
  }
  leave(someFacts());
  EXPECT_TRUE(taken());
}

TEST_F(FactFileTest, aFolderThatCannotBeIsComplainedOfOnce) {
  std::ofstream(folder_) << "a file stands where the folder should be";
  const auto file = fileOf();
  EXPECT_FALSE(file->open(FactScope::of(models(), ""), kDay));
  file->write(someFacts());
  file->write(someFacts());
  EXPECT_TRUE(isComplainedOf("can't be kept"));
  EXPECT_FALSE(file->lastError().empty());
}

TEST(SpokenAge, isRoundAndHasAUnit) {
  EXPECT_EQ(spokenAge(0), "0 s");
  EXPECT_EQ(spokenAge(119), "119 s");
  EXPECT_EQ(spokenAge(130), "2 min");
  EXPECT_EQ(spokenAge(7200), "2 h");
  EXPECT_EQ(spokenAge(259200), "3 days");
}

}  // namespace
}  // namespace goal_alignment::aligner
