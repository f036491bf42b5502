// SPDX-License-Identifier: BSD-3-Clause
#include "generators/pddl_text.h"

#include <gtest/gtest.h>

namespace goal_alignment::benchmarks {
namespace {

std::string written(const std::vector<Typed>& names) {
  std::string text;
  for (const Typed& each : names)
    text += each.name + ":" + each.type + " ";
  return text;
}

TEST(TypedNames, areOfTheTypeAfterTheDash) {
  EXPECT_EQ(written(typed("?a ?b - van ?p - spot ?x")), "a:van b:van p:spot x:object ");
  EXPECT_EQ(written(typed("")), "");
}

TEST(DomainParts, knowWhatIsBelowWhat) {
  DomainParts domain;
  domain.types = typed("van - vehicle vehicle spot");
  EXPECT_TRUE(domain.isA("van", "vehicle"));
  EXPECT_TRUE(domain.isA("van", "object"));
  EXPECT_FALSE(domain.isA("vehicle", "van"));
  EXPECT_FALSE(domain.isA("spot", "vehicle"));
}

TEST(ProblemParts, countTheirObjects) {
  ProblemParts problem;
  EXPECT_EQ(problem.addObjects("cup", 2, "dish"), (std::vector<std::string>{"cup0", "cup1"}));
  EXPECT_EQ(written(problem.objects), "cup0:dish cup1:dish ");
}

TEST(Atom, isANameAndItsArguments) {
  EXPECT_EQ(atom({"idle"}), "(idle)");
  EXPECT_EQ(atom({"on", "a", "b"}), "(on a b)");
}

}  // namespace
}  // namespace goal_alignment::benchmarks
