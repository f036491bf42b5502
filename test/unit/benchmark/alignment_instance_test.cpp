// SPDX-License-Identifier: BSD-3-Clause
#include "generators/alignment_instance.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>

#include "goal_alignment/alignment/problem.h"
#include "goal_alignment/cli/instance.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/pddl/parser.h"
#include "unit/source_root.h"

namespace goal_alignment::benchmarks {
namespace {

alignment::Problem problemOf(const AlignmentInstance& instance) {
  const session::Input input = instance.input();
  return alignment::makeProblem(pddl::readModel(input.robot_domain, input.robot_problem),
                                pddl::readModel(input.human_domain, input.human_problem), {},
                                input.human_plan);
}

// What makeProblem() doesn't check: that the person can want what they do, and wants what they say.
void expectSound(const AlignmentInstance& instance) {
  const alignment::Problem problem = problemOf(instance);  // throws where the human plan fails
  for (const Literal& asked_for : problem.specified) {
    EXPECT_TRUE(std::binary_search(instance.true_goal.begin(), instance.true_goal.end(), asked_for))
        << asked_for.text();
  }
  EXPECT_TRUE(
      validation::unsatisfied(problem.human, problem.expectation.finalState(), instance.true_goal)
          .empty());
}

std::vector<MonotoneDnf> solvableFamilies() {
  std::vector<MonotoneDnf> result;
  for (const MonotoneDnf& family : families()) {
    if (family.solvable && !family.formulas) result.push_back(family);
  }
  return result;
}

class Alignments : public testing::TestWithParam<std::string> {
 protected:
  static AlignmentInstance drawn(const MonotoneDnf& family, const std::string& differences,
                                 const Truth& truth, std::uint64_t seed) {
    RandomSource random(seed);
    return alignmentOf(family.make(4, random), misreadingOf(differences), truth, random);
  }
};

TEST_P(Alignments, areSoundUnderEachTruth) {
  for (const MonotoneDnf& family : solvableFamilies()) {
    for (const double wanted : {-1.0, 0.2, 0.5}) {
      SCOPED_TRACE(family.name);
      Truth truth;
      truth.wanted = wanted;
      expectSound(drawn(family, GetParam(), truth, 7));
    }
  }
}

TEST_P(Alignments, followFromTheSeedAlone) {
  for (const MonotoneDnf& family : solvableFamilies()) {
    const AlignmentInstance one = drawn(family, GetParam(), {}, 3);
    const AlignmentInstance other = drawn(family, GetParam(), {}, 3);
    EXPECT_EQ(one.input().human_domain.text, other.input().human_domain.text);
    EXPECT_EQ(one.input().human_problem.text, other.input().human_problem.text);
    EXPECT_EQ(one.human_plan, other.human_plan);
    EXPECT_EQ(one.true_goal, other.true_goal);
  }
}

TEST_P(Alignments, differInWhatTheyNameAlone) {
  const std::string differences = GetParam();
  const auto has = [&](char letter) { return differences.find(letter) != std::string::npos; };
  for (const MonotoneDnf& family : solvableFamilies()) {
    const session::Input input = drawn(family, differences, {}, 5).input();
    EXPECT_EQ(input.robot_domain.text != input.human_domain.text, has('a') || has('v'));
    const bool has_statics = family.name != "crates";
    if (has('s') && has_statics) {
      EXPECT_NE(input.robot_problem.text, input.human_problem.text);
    }
    if (differences == "a") {
      EXPECT_EQ(input.robot_problem.text, input.human_problem.text);
    }
    const bool noticed = input.human_domain.text.find("(noticed ") != std::string::npos;
    EXPECT_EQ(noticed, has('v'));
  }
}

INSTANTIATE_TEST_SUITE_P(Differing, Alignments, testing::Values("a", "i", "s", "v", "aisv"),
                         [](const auto& letters) { return letters.param; });

TEST(HouseholdAlignment, isSound) {
  RandomSource random(1);
  HouseholdSize size;
  size.dishes = 12;
  expectSound(householdAlignment(size, 6, {}, random));
}

TEST(HomeAlignment, isSoundAtAnySizeAndFollowsFromTheSeed) {
  for (const int size : {1, 2, 3, 8, 20, 64}) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      SCOPED_TRACE(std::to_string(size) + ", seed " + std::to_string(seed));
      RandomSource random(seed);
      RandomSource same(seed);
      const AlignmentInstance instance = homeAlignment(size, {}, random);
      expectSound(instance);
      EXPECT_FALSE(instance.robot.problem.goal.empty());
      EXPECT_EQ(homeAlignment(size, {}, same).input().robot_problem.text,
                instance.input().robot_problem.text);
    }
  }
}

TEST(HomeAlignment, speaksOfTheHomesDomains) {
  RandomSource random(1);
  const session::Input input = homeAlignment(8, {}, random).input();
  const auto folder = sourceRoot() / "config/domains/home";
  EXPECT_EQ(input.robot_domain.text, pddl::readFile((folder / "robot_domain.pddl").string()).text);
  EXPECT_EQ(input.human_domain.text, pddl::readFile((folder / "human_domain.pddl").string()).text);
}

TEST(HomeAlignment, growsInFloorsRoomsAndThings) {
  const auto objects = [](int size) {
    RandomSource random(1);
    return homeAlignment(size, {}, random).robot.problem.objects.size();
  };
  EXPECT_LT(objects(4), objects(16));
  EXPECT_LT(objects(16), objects(64));
  RandomSource random(1);
  const std::string problem = homeAlignment(128, {}, random).input().robot_problem.text;
  EXPECT_NE(problem.find("landing3"), std::string::npos) << "four floors";
}

TEST(LargeHome, isAsLargeAsItSays) {
  const AlignmentInstance home = largeHome(1);
  expectSound(home);
  const alignment::Problem problem = problemOf(home);
  EXPECT_GE(problem.robot.objects.size(), 200U);
  EXPECT_GE(std::count_if(problem.candidates.begin(), problem.candidates.end(),
                          [](const auto& candidate) { return !candidate.is_static; }),
            100);
  EXPECT_GE(grounding::ground(problem.robot, {}, {}, {}).task.operators.size(), 20'000U);
}

TEST(WrittenInstance, isReadBackAsItWas) {
  RandomSource random(2);
  const AlignmentInstance instance = alignmentOf(crates(4, random), {}, {}, random);
  const auto folder = std::filesystem::path(testing::TempDir()) / "written_instance";
  write(instance, folder.string());
  const auto files = cli::InstanceFiles::of(folder.string());
  const session::Input read = cli::readInput(files);
  EXPECT_EQ(read.robot_domain.text, instance.input().robot_domain.text);
  EXPECT_EQ(read.human_problem.text, instance.input().human_problem.text);
  EXPECT_EQ(read.human_plan, instance.human_plan);
  EXPECT_EQ(pddl::parseLiterals(pddl::readFile(files.true_goal)), instance.true_goal);
  std::filesystem::remove_all(folder);
}

TEST(Differences, haveFourLetters) {
  EXPECT_THROW(misreadingOf("ax"), std::invalid_argument);
}

}  // namespace
}  // namespace goal_alignment::benchmarks
