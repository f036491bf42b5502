// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include "drawing.h"
#include "families.h"

namespace goal_alignment::benchmarks {
namespace {

DomainParts tower() {
  const std::vector<Typed> change = typed("?p - passenger ?l - lift ?f - storey ?n ?more - number");
  return {"tower",
          typed("passenger lift storey number"),
          {{"above", typed("?upper ?lower - storey")},
           {"serves", typed("?l - lift ?f - storey")},
           {"successor", typed("?n ?more - number")},
           {"stands-at", typed("?l - lift ?f - storey")},
           {"carries", typed("?l - lift ?n - number")},
           {"waits", typed("?p - passenger ?f - storey")},
           {"rides", typed("?p - passenger ?l - lift")}},
          {{"ascend",
            typed("?l - lift ?from ?to - storey"),
            {"(stands-at ?l ?from)", "(above ?to ?from)", "(serves ?l ?to)"},
            {"(stands-at ?l ?to)"},
            {"(stands-at ?l ?from)"}},
           {"descend",
            typed("?l - lift ?from ?to - storey"),
            {"(stands-at ?l ?from)", "(above ?from ?to)", "(serves ?l ?to)"},
            {"(stands-at ?l ?to)"},
            {"(stands-at ?l ?from)"}},
           {"enter",
            change,
            {"(waits ?p ?f)", "(stands-at ?l ?f)", "(carries ?l ?n)", "(successor ?n ?more)"},
            {"(rides ?p ?l)", "(carries ?l ?more)"},
            {"(waits ?p ?f)", "(carries ?l ?n)"}},
           {"leave",
            change,
            {"(rides ?p ?l)", "(stands-at ?l ?f)", "(carries ?l ?more)", "(successor ?n ?more)"},
            {"(waits ?p ?f)", "(carries ?l ?n)"},
            {"(rides ?p ?l)", "(carries ?l ?more)"}}}};
}

}  // namespace

Models lifts(int size, RandomSource& random) {
  constexpr int kCapacity = 2;
  Models models = {tower(), {}, {"waits"}};
  ProblemParts& problem = models.problem;
  const auto storeys = problem.addObjects("storey", size + 2, "storey");
  const auto numbers = problem.addObjects("n", kCapacity + 1, "number");
  const auto lift_names = problem.addObjects("lift", 2, "lift");
  for (std::size_t i = 0; i < storeys.size(); ++i) {
    for (std::size_t j = i + 1; j < storeys.size(); ++j)
      problem.init.push_back(atom({"above", storeys[j], storeys[i]}));
    // The second lift is the express: it stops at every other storey.
    problem.init.push_back(atom({"serves", lift_names[0], storeys[i]}));
    if (i % 2 == 0) problem.init.push_back(atom({"serves", lift_names[1], storeys[i]}));
  }
  for (std::size_t n = 0; n + 1 < numbers.size(); ++n)
    problem.init.push_back(atom({"successor", numbers[n], numbers[n + 1]}));
  for (const std::string& lift : lift_names) {
    problem.init.push_back(atom({"stands-at", lift, storeys.front()}));
    problem.init.push_back(atom({"carries", lift, numbers.front()}));
  }
  for (const std::string& passenger : problem.addObjects("passenger", size, "passenger")) {
    const auto way = shuffled(storeys, random);
    problem.init.push_back(atom({"waits", passenger, way[0]}));
    problem.goal.push_back(atom({"waits", passenger, way[1]}));
  }
  return models;
}

}  // namespace goal_alignment::benchmarks
