// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/journal.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace goal_alignment::aligner {
namespace {

namespace fs = std::filesystem;
using session::AnswerKind;

constexpr double kWeek = 604800;  // seconds

JournalAnswer answer(const std::string& fluent, AnswerKind kind, const std::string& by = "Ann") {
  return {Literal::parse(fluent), kind, by, ros::Time(12, 34)};
}

class JournalTest : public testing::Test {
 protected:
  JournalTest()
      : folder_(fs::temp_directory_path() / ("journal_test." + std::to_string(getpid()))),
        journal_(makeJournal()) {}
  ~JournalTest() override { fs::remove_all(folder_); }

  std::unique_ptr<Journal> makeJournal() {
    return std::make_unique<Journal>(
        folder_.string(), [this](const std::string& line) { complaints_.push_back(line); });
  }

  // As after a restart.
  std::vector<JournalAnswer> reopened(const std::string& key, double expiry = kWeek) {
    journal_ = makeJournal();
    return journal_->open(key, "s", expiry);
  }

  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder_, none))
      found.push_back(entry.path());
    return found;
  }

  void overwrite(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

  fs::path folder_;
  std::vector<std::string> complaints_;
  std::unique_ptr<Journal> journal_;
};

TEST_F(JournalTest, keepsAnswersAcrossARestart) {
  EXPECT_TRUE(journal_->open("k", "s", kWeek).empty());
  journal_->write({answer("(on a b)", AnswerKind::Yes)});
  journal_->write({answer("(on a b)", AnswerKind::Yes), answer("(not (p))", AnswerKind::No, ""),
                   answer("(q)", AnswerKind::Unsure,
                          "B\xc3\xa9"
                          "a \"x\"\n")});
  const auto answers = reopened("k");
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0].fluent.text(), "(on a b)");
  EXPECT_EQ(answers[0].kind, AnswerKind::Yes);
  EXPECT_EQ(answers[0].answered_by, "Ann");
  EXPECT_EQ(answers[0].at, ros::Time(12, 34));
  EXPECT_TRUE(answers[1].fluent.negated);
  EXPECT_EQ(answers[1].kind, AnswerKind::No);
  EXPECT_EQ(answers[2].kind, AnswerKind::Unsure);
  EXPECT_EQ(answers[2].answered_by,
            "B\xc3\xa9"
            "a \"x\"\n");
  EXPECT_TRUE(complaints_.empty());
  EXPECT_EQ(files().size(), 1U) << "no temporary file stays";
}

TEST_F(JournalTest, namesThatAreNoUtf8AreWrittenAllTheSame) {
  journal_->open("k", "s", kWeek);
  journal_->write({answer("(p)", AnswerKind::Yes, "\xff\xfe")});
  EXPECT_EQ(reopened("k").size(), 1U);
  EXPECT_TRUE(complaints_.empty());
}

TEST_F(JournalTest, entriesOfOtherTasksAreApart) {
  journal_->open("k", "s", kWeek);
  journal_->write({answer("(p)", AnswerKind::Yes)});
  EXPECT_TRUE(reopened("l").empty());
  journal_->drop();
  EXPECT_EQ(reopened("k").size(), 1U);
}

TEST_F(JournalTest, theOutcomeAndForgetDropTheEntry) {
  EXPECT_FALSE(journal_->forget()) << "there is no task yet";
  journal_->open("k", "s", kWeek);
  journal_->write({answer("(p)", AnswerKind::Yes)});
  journal_->drop();
  EXPECT_TRUE(files().empty());
  journal_->write({answer("(p)", AnswerKind::Yes)});
  EXPECT_EQ(files().size(), 1U) << "a session that goes on after its outcome is kept again";
  EXPECT_TRUE(journal_->forget());
  EXPECT_TRUE(files().empty());
  journal_->write({answer("(p)", AnswerKind::Yes)});
  EXPECT_TRUE(files().empty()) << "forgotten is forgotten";
  journal_->open("k", "s", kWeek);
  journal_->write({answer("(p)", AnswerKind::Yes)});
  EXPECT_EQ(files().size(), 1U);
}

TEST_F(JournalTest, hasAnswersBeforeTheSessionTakesThem) {
  journal_->open("k", "s", kWeek);
  journal_->write({answer("(p)", AnswerKind::Yes)});
  journal_->add("s", {answer("(q)", AnswerKind::No), answer("(p)", AnswerKind::No)});
  journal_->write({answer("(p)", AnswerKind::Yes), answer("(r)", AnswerKind::Unsure)});
  journal_->add("another", {answer("(x)", AnswerKind::No)});
  const auto kept = Journal(folder_.string(), {}).open("k", "t", kWeek);
  std::map<std::string, AnswerKind> kinds;
  for (const JournalAnswer& each : kept)
    kinds[each.fluent.text()] = each.kind;
  const std::map<std::string, AnswerKind> expected = {
      {"(p)", AnswerKind::No}, {"(q)", AnswerKind::No}, {"(r)", AnswerKind::Unsure}};
  EXPECT_EQ(kinds, expected);
  EXPECT_EQ(kept.size(), 3U);
}

TEST_F(JournalTest, addsNothingAfterTheOutcomeOrWhatWasForgotten) {
  journal_->open("k", "s", kWeek);
  journal_->add("s", {answer("(p)", AnswerKind::Yes)});
  EXPECT_EQ(files().size(), 1U);
  journal_->drop();
  journal_->add("s", {answer("(q)", AnswerKind::Yes)});
  EXPECT_TRUE(files().empty());
  journal_->write({answer("(p)", AnswerKind::Yes)});
  EXPECT_EQ(reopened("k").size(), 1U) << "what was accepted before the outcome is not new any more";
  journal_->forget();
  journal_->add("s", {answer("(q)", AnswerKind::Yes)});
  EXPECT_TRUE(files().empty());
}

TEST_F(JournalTest, oldEntriesGo) {
  journal_->open("k", "s", kWeek);
  journal_->write({answer("(p)", AnswerKind::Yes)});
  fs::last_write_time(files().front(), fs::file_time_type::clock::now() - std::chrono::hours(2));
  EXPECT_EQ(reopened("k", 3 * 3600).size(), 1U);
  EXPECT_TRUE(reopened("l", 3600).empty());
  EXPECT_TRUE(files().empty()) << "that of another task as well";
}

TEST_F(JournalTest, withoutExpiryNothingIsReadOrWritten) {
  journal_->open("k", "s", kWeek);
  journal_->write({answer("(p)", AnswerKind::Yes)});
  EXPECT_TRUE(reopened("k", 0).empty());
  journal_->drop();
  journal_->write({answer("(p)", AnswerKind::Yes)});
  EXPECT_TRUE(files().empty());
}

TEST_F(JournalTest, aDamagedEntryIsSetAsideWithAWarning) {
  journal_->open("k", "s", kWeek);
  journal_->write({answer("(p)", AnswerKind::Yes), answer("(q)", AnswerKind::No)});
  const fs::path file = files().front();
  std::stringstream good;
  good << std::ifstream(file).rdbuf();
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = good.str();
    return text.replace(text.find(from), from.size(), to);
  };
  const std::vector<std::string> damaged = {"",
                                            "\0\0\0",
                                            good.str().substr(0, good.str().size() / 2),
                                            "[]",
                                            "{}",
                                            replaced("\"version\": 1", "\"version\": 99"),
                                            replaced("\"key\": \"k\"", "\"key\": \"l\""),
                                            replaced("\"yes\"", "\"maybe\""),
                                            replaced("\"yes\"", "7"),
                                            replaced("(p)", "(p"),
                                            replaced("(p)", "(q)"),
                                            std::string(100'000, '[')};
  for (const std::string& text : damaged) {
    overwrite(file, text);
    complaints_.clear();
    EXPECT_TRUE(reopened("k").empty()) << text.substr(0, 200);
    EXPECT_EQ(complaints_.size(), 1U) << text.substr(0, 200);
    EXPECT_FALSE(journal_->lastError().empty());
    EXPECT_TRUE(fs::exists(file.string() + ".damaged"));
    EXPECT_FALSE(fs::exists(file));
    journal_->write({answer("(p)", AnswerKind::Yes)});
    EXPECT_TRUE(journal_->lastError().empty());
  }
  journal_->forget();
  EXPECT_TRUE(files().empty()) << "what was set aside is forgotten, too";
}

TEST_F(JournalTest, aFolderThatCannotBeIsComplainedOfOnce) {
  overwrite(folder_, "a file stands where the folder should be");
  EXPECT_TRUE(journal_->open("k", "s", kWeek).empty());
  journal_->write({answer("(p)", AnswerKind::Yes)});
  journal_->write({answer("(p)", AnswerKind::Yes)});
  journal_->drop();
  EXPECT_EQ(complaints_.size(), 1U);
  EXPECT_FALSE(journal_->lastError().empty());
}

TEST(JournalKey, dependsOnWhatThePersonKnowsAndOnWhoAsks) {
  session::Input input;
  input.robot_domain.text = "rd";
  input.human_domain.text = "hd";
  input.human_problem.text = "hp";
  input.goal = {Literal::parse("(g)"), Literal::parse("(h)")};
  input.human_plan = {GroundName::parse("(a x)")};
  const std::string key = journalKey(input, "Ann", "/r");

  session::Input other = input;
  other.robot_domain.text = "something else";
  other.robot_problem.text = "what is so now";
  other.human_domain.name = "another file";
  other.goal = {Literal::parse("(H)"), Literal::parse("(g)")};
  other.human_facts = {{Literal::parse("(f)"), true}};
  EXPECT_EQ(journalKey(other, "Ann", "/r"), key);

  EXPECT_NE(journalKey(input, "Bob", "/r"), key);
  EXPECT_NE(journalKey(input, "Ann", "/s"), key) << "what one robot was told is no other's";
  EXPECT_NE(journalKey(input, "", "/rAnn"), journalKey(input, "Ann", "/r"));
  const auto changed = [&](void (*change)(session::Input&)) {
    session::Input copy = input;
    change(copy);
    return journalKey(copy, "Ann", "/r");
  };
  EXPECT_NE(changed([](session::Input& i) { i.human_domain.text += " "; }), key);
  EXPECT_NE(changed([](session::Input& i) { i.human_problem.text += " "; }), key);
  EXPECT_NE(changed([](session::Input& i) { i.goal.pop_back(); }), key);
  EXPECT_NE(changed([](session::Input& i) { i.human_plan.clear(); }), key);
  EXPECT_NE(changed([](session::Input& i) { std::swap(i.human_domain, i.human_problem); }), key);
}

}  // namespace
}  // namespace goal_alignment::aligner
