// SPDX-License-Identifier: BSD-3-Clause
// The phrase files of config/domains against the models that they speak of.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "goal_alignment/pddl/model.h"
#include "goal_alignment/phrasing/phrases.h"
#include "unit/source_root.h"

namespace goal_alignment::phrasing {
namespace {

// One side's models of one task.
struct Spoken {
  std::string domain;  // folder of the domains and the phrases
  std::string task;    // folder of the problems, below it
  std::string side;    // robot, human
};

class DomainPhrases : public testing::TestWithParam<Spoken> {
 protected:
  static pddl::Source file(const std::string& name) {
    const auto folder = sourceRoot() / "config/domains" / GetParam().domain;
    return pddl::readFile((folder / name).string());
  }

  Phrases phrases_ = Phrases::fromYaml(file("phrases.yaml").text, "phrases.yaml");
  pddl::Model model_ =
      pddl::readModel(file(GetParam().side + "_domain.pddl"),
                      file(GetParam().task + "/" + GetParam().side + "_problem.pddl"));
};

TEST_P(DomainPhrases, EveryPredicateHasASentence) {
  for (const pddl::Predicate& predicate : model_.predicates) {
    const GroundName atom{predicate.name.name,
                          std::vector<std::string>(predicate.parameter_types.size(), "it")};
    for (const bool negated : {false, true}) {
      const Literal fluent{atom, negated};
      EXPECT_NE(phrases_.clause(fluent), Phrases().clause(fluent)) << predicate.name.spelling;
    }
  }
}

TEST_P(DomainPhrases, EveryActionHasASentence) {
  for (const pddl::Schema& schema : model_.schemas) {
    const GroundName step{schema.name.name,
                          std::vector<std::string>(schema.parameters.size(), "it")};
    const std::string spoken = phrases_.action(step);
    // Without a template it would read like "go: it, it"; "climb up" is its own sentence.
    EXPECT_EQ(spoken.find(':'), std::string::npos) << spoken;
  }
}

TEST_P(DomainPhrases, EveryObjectHasAName) {
  for (const pddl::Object& object : model_.objects) {
    const std::string spoken = phrases_.object(object.name.name);
    EXPECT_FALSE(spoken.empty());
    EXPECT_EQ(spoken.find('-'), std::string::npos) << spoken;
  }
}

std::vector<Spoken> spoken() {
  std::vector<Spoken> all;
  for (const char* side : {"robot", "human"}) {
    all.push_back({"tea", ".", side});
    all.push_back({"ward", ".", side});
    for (const char* task : {"clear_table", "nap_time", "evening_tablets", "laundry_day",
                             "afternoon_tea", "lay_table"})
      all.push_back({"home", task, side});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(BothModels, DomainPhrases, testing::ValuesIn(spoken()),
                         [](const auto& spoken) {
                           const std::string task =
                               spoken.param.task == "." ? spoken.param.domain : spoken.param.task;
                           return task + "_" + spoken.param.side;
                         });

}  // namespace
}  // namespace goal_alignment::phrasing
