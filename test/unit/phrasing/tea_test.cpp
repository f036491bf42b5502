// SPDX-License-Identifier: BSD-3-Clause
// The demo's phrase file, config/domains/tea/phrases.yaml, against the models that it speaks of.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "goal_alignment/pddl/model.h"
#include "goal_alignment/phrasing/phrases.h"

namespace goal_alignment::phrasing {
namespace {

pddl::Source teaFile(const std::string& name) {
  const std::filesystem::path root = std::filesystem::path(__FILE__).parent_path() / "../../..";
  return pddl::readFile((root / "config/domains/tea" / name).string());
}

class TeaPhrases : public testing::TestWithParam<const char*> {
 protected:
  Phrases phrases_ = Phrases::fromYaml(teaFile("phrases.yaml").text, "phrases.yaml");
  pddl::Model model_ = pddl::readModel(teaFile(std::string(GetParam()) + "_domain.pddl"),
                                       teaFile(std::string(GetParam()) + "_problem.pddl"));
};

TEST_P(TeaPhrases, EveryPredicateHasASentence) {
  for (const pddl::Predicate& predicate : model_.predicates) {
    const Literal fluent{
        {predicate.name.name, std::vector<std::string>(predicate.parameter_types.size(), "it")}};
    EXPECT_NE(phrases_.clause(fluent), Phrases().clause(fluent)) << predicate.name.spelling;
  }
}

TEST_P(TeaPhrases, EveryActionHasASentence) {
  for (const pddl::Schema& schema : model_.schemas) {
    const GroundName step{schema.name.name,
                          std::vector<std::string>(schema.parameters.size(), "it")};
    const std::string spoken = phrases_.action(step);
    // Without a template it would read like "go: it, it"; "climb up" is its own sentence.
    EXPECT_EQ(spoken.find(':'), std::string::npos) << spoken;
  }
}

TEST_P(TeaPhrases, EveryObjectHasAName) {
  for (const pddl::Object& object : model_.objects) {
    EXPECT_FALSE(phrases_.object(object.name.name).empty());
    EXPECT_EQ(phrases_.object(object.name.name).find('-'), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(BothModels, TeaPhrases, testing::Values("robot", "human"));

}  // namespace
}  // namespace goal_alignment::phrasing
