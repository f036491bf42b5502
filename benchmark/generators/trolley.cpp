// SPDX-License-Identifier: BSD-3-Clause
#include "drawing.h"
#include "families.h"

namespace goal_alignment::benchmarks {
namespace {

DomainParts hall() {
  return {"hall",
          typed("corner item"),
          {{"joined", typed("?a ?b - corner")},
           {"trolley-at", typed("?c - corner")},
           {"at", typed("?i - item ?c - corner")},
           {"loaded", typed("?i - item")},
           {"fragile", typed("?i - item")}},
          {{"load",
            typed("?i - item ?c - corner"),
            {"(at ?i ?c)", "(trolley-at ?c)",
             "(or (not (fragile ?i)) (forall (?j - item) (not (loaded ?j))))"},
            {"(loaded ?i)"},
            {}},
           {"unload", typed("?i - item"), {"(loaded ?i)"}, {}, {"(loaded ?i)"}},
           {"push",
            typed("?from ?to - corner"),
            {"(trolley-at ?from)", "(joined ?from ?to)"},
            {"(trolley-at ?to)",
             "(forall (?i - item) (when (loaded ?i) (and (at ?i ?to) (not (at ?i ?from)))))"},
            {"(trolley-at ?from)"}}}};
}

}  // namespace

Models trolley(int size, RandomSource& random) {
  Models models = {hall(), {}};
  ProblemParts& problem = models.problem;
  const auto corners = problem.addObjects("corner", size / 2 + 2, "corner");
  const auto items = problem.addObjects("item", size, "item");
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::string& next = corners[(i + 1) % corners.size()];
    problem.init.push_back(atom({"joined", corners[i], next}));
    problem.init.push_back(atom({"joined", next, corners[i]}));
  }
  problem.init.push_back(atom({"trolley-at", corners[0]}));
  for (const std::string& item : items) {
    problem.init.push_back(atom({"at", item, corners[random.below(corners.size())]}));
    problem.goal.push_back(atom({"at", item, corners[random.below(corners.size())]}));
    if (random.below(3) == 0) problem.init.push_back(atom({"fragile", item}));
  }
  problem.goal.emplace_back("(forall (?i - item) (not (loaded ?i)))");
  return models;
}

}  // namespace goal_alignment::benchmarks
