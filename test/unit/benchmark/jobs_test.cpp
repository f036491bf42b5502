// SPDX-License-Identifier: BSD-3-Clause
#include "measure/jobs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "generators/alignment_instance.h"
#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::benchmarks {
namespace {

class Folders : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(root_); }

  void put(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  void putPair(const std::string& domain, const std::string& problem) const {
    RandomSource random(1);
    const Models models = crates(3, random);
    put(domain, models.domain.text());
    put(problem, models.problemText());
  }
  std::vector<std::string> statuses(const std::string& kind) const {
    std::vector<std::string> result;
    for (const Job& job : jobsBelow(root_.string(), {})) {
      if (job.kind != kind) continue;
      const Record record = run(job, {});
      result.push_back(job.suite + " " + job.task + " " + record.text("status") +
                       record.text("error"));
    }
    return result;
  }

  std::filesystem::path root_ = std::filesystem::path(testing::TempDir()) / "tasks";
};

using Texts = std::vector<std::string>;

TEST_F(Folders, holdProblemsBesideTheirDomains) {
  putPair("yard/domain.pddl", "yard/p01.pddl");
  putPair("yard/p02-domain.pddl", "yard/p02.pddl");
  putPair("yard/domain-p03.pddl", "yard/p03.pddl");
  putPair("yard/p04-domain.pddl", "yard/p04-problem.pddl");
  putPair("other/one/domain.pddl", "other/one/problem.pddl");
  EXPECT_EQ(statuses("first"),
            (Texts{"other other/one solved", "tasks yard/p01 solved", "tasks yard/p02 solved",
                   "tasks yard/p03 solved", "tasks yard/p04-problem solved"}));
  EXPECT_EQ(statuses("optimal").size(), 5U);
}

TEST_F(Folders, holdAlignments) {
  RandomSource random(1);
  write(alignmentOf(crates(3, random), {}, {}, random), (root_ / "aligned").string());
  const auto jobs = jobsBelow(root_.string(), {});
  ASSERT_EQ(jobs.size(), 1U);
  EXPECT_EQ(jobs.front().task, "aligned");
  EXPECT_EQ(jobsBelow((root_ / "aligned/").string(), {}).front().task, "aligned");
  const Record record = run(jobs.front(), {});
  EXPECT_EQ(record.text("status"), "plan_found") << record.text("error");
  EXPECT_GT(record.number("operators"), 0);
  EXPECT_GE(record.number("first_question"), 0);
}

TEST_F(Folders, withoutATaskAreRefused) {
  put("readme.txt", "");
  EXPECT_THROW(jobsBelow(root_.string(), {}), pddl::InputError);
  EXPECT_THROW(jobsBelow((root_ / "none").string(), {}), pddl::InputError);
}

TEST_F(Folders, withABrokenTaskSaySo) {
  putPair("domain.pddl", "p01.pddl");
  put("p02.pddl", "(define");
  const Texts found = statuses("first");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NE(found.back().find("failed"), std::string::npos) << found.back();
}

TEST(GeneratedJobs, haveNamesOfTheirOwn) {
  for (const auto& jobs : {familyCalls(1), familyAlignments(1, {}), householdGrowth(1, {})}) {
    std::vector<std::string> names;
    for (const Job& job : jobs)
      names.push_back(job.kind + " " + job.task);
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  }
}

}  // namespace
}  // namespace goal_alignment::benchmarks
