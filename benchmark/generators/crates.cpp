// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include "drawing.h"
#include "families.h"

namespace goal_alignment::benchmarks {
namespace {

DomainParts yard() {
  return {"yard",
          typed("crate"),
          {{"atop", typed("?upper ?lower - crate")},
           {"grounded", typed("?c - crate")},
           {"uncovered", typed("?c - crate")},
           {"hoisted", typed("?c - crate")},
           {"crane-idle", {}}},
          {{"hoist",
            typed("?c - crate"),
            {"(grounded ?c)", "(uncovered ?c)", "(crane-idle)"},
            {"(hoisted ?c)"},
            {"(grounded ?c)", "(uncovered ?c)", "(crane-idle)"}},
           {"hoist-off",
            typed("?c ?below - crate"),
            {"(atop ?c ?below)", "(uncovered ?c)", "(crane-idle)"},
            {"(hoisted ?c)", "(uncovered ?below)"},
            {"(atop ?c ?below)", "(uncovered ?c)", "(crane-idle)"}},
           {"lower",
            typed("?c - crate"),
            {"(hoisted ?c)"},
            {"(grounded ?c)", "(uncovered ?c)", "(crane-idle)"},
            {"(hoisted ?c)"}},
           {"lower-onto",
            typed("?c ?below - crate"),
            {"(hoisted ?c)", "(uncovered ?below)"},
            {"(atop ?c ?below)", "(uncovered ?c)", "(crane-idle)"},
            {"(hoisted ?c)", "(uncovered ?below)"}}}};
}

// The facts of piles, each crate with one chance in four at the bottom of a new one.
std::vector<std::string> piles(const std::vector<std::string>& crates, RandomSource& random,
                               bool tops) {
  std::vector<std::string> facts;
  std::string below;
  for (const std::string& crate : shuffled(crates, random)) {
    const bool grounded = below.empty() || random.below(4) == 0;
    if (grounded && !below.empty() && tops) facts.push_back(atom({"uncovered", below}));
    facts.push_back(grounded ? atom({"grounded", crate}) : atom({"atop", crate, below}));
    below = crate;
  }
  if (tops) facts.push_back(atom({"uncovered", below}));
  return facts;
}

}  // namespace

Models crates(int size, RandomSource& random) {
  Models models = {yard(), {}};
  const auto names = models.problem.addObjects("crate", size, "crate");
  models.problem.init = piles(names, random, true);
  models.problem.init.emplace_back("(crane-idle)");
  models.problem.goal = piles(names, random, false);
  return models;
}

}  // namespace goal_alignment::benchmarks
