// SPDX-License-Identifier: BSD-3-Clause
#include "generators/families.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "generators/single_call.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::benchmarks {
namespace {

using search::Status;

Models made(const MonotoneDnf& family, int size, std::uint64_t seed) {
  RandomSource random(seed);
  return family.make(size, random);
}

std::vector<std::string> faultsOf(const Models& models) {
  return pddl::faults({"domain", models.domain.text()}, {"problem", models.problemText()});
}

Status statusOf(const Models& models) {
  constexpr std::uint64_t kPlenty = 2'000'000;
  return singleCall({"domain", models.domain.text()}, {"problem", models.problemText()},
                    CallKind::First, Limits().withStates(kPlenty))
      .result.status;
}

class Families : public testing::TestWithParam<MonotoneDnf> {};

TEST_P(Families, areReadAtEverySize) {
  for (const int size : GetParam().sizes)
    EXPECT_EQ(faultsOf(made(GetParam(), size, 1)), std::vector<std::string>()) << size;
}

TEST_P(Families, haveAPlanOrNoneAsTheySay) {
  const Status expected = GetParam().solvable ? Status::Solved : Status::Unsolvable;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    for (const int size : {2, 3, 4})
      EXPECT_EQ(statusOf(made(GetParam(), size, seed)), expected) << size << ", seed " << seed;
  }
}

RC_GTEST_PROP(FamilyTexts, followFromTheSeedAlone, ()) {
  const MonotoneDnf family = *rc::gen::elementOf(families());
  const int size = *rc::gen::inRange(2, 12);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const Models models = made(family, size, seed);
  RC_ASSERT(models.problemText() == made(family, size, seed).problemText());
  RC_ASSERT(faultsOf(models).empty());
}

TEST(FamilyTexts, differWithTheSeed) {
  EXPECT_NE(made(familyCalled("crates"), 8, 1).problemText(),
            made(familyCalled("crates"), 8, 2).problemText());
}

INSTANTIATE_TEST_SUITE_P(All, Families, testing::ValuesIn(families()),
                         [](const auto& family) { return family.param.name; });

TEST(Courier, needsAllTheChargeThatFiveStreetsTake) {
  for (const int size : {1, 2, 3}) {
    EXPECT_EQ(statusOf(courier(size, 0)), Status::Unsolvable) << size;
    EXPECT_EQ(statusOf(courier(size, 1)), Status::Solved) << size;
  }
}

TEST(FamilyNames, refuseANameThatTheyDontHave) {
  EXPECT_THROW(familyCalled("crate"), std::invalid_argument);
}

}  // namespace
}  // namespace goal_alignment::benchmarks
