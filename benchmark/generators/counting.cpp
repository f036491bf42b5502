// SPDX-License-Identifier: BSD-3-Clause
// The families without a plan: what they want is too much by one, and no pair of facts shows it.
#include <string>
#include <vector>

#include "drawing.h"
#include "families.h"

namespace goal_alignment::benchmarks {

Models pegs(int size, RandomSource& random) {
  Models models = {{"pegs",
                    typed("ring peg"),
                    {{"loose", typed("?r - ring")},
                     {"hangs", typed("?r - ring")},
                     {"hangs-on", typed("?r - ring ?p - peg")},
                     {"vacant", typed("?p - peg")}},
                    {{"hang",
                      typed("?r - ring ?p - peg"),
                      {"(loose ?r)", "(vacant ?p)"},
                      {"(hangs ?r)", "(hangs-on ?r ?p)"},
                      {"(loose ?r)", "(vacant ?p)"}},
                     {"unhang",
                      typed("?r - ring ?p - peg"),
                      {"(hangs-on ?r ?p)"},
                      {"(loose ?r)", "(vacant ?p)"},
                      {"(hangs ?r)", "(hangs-on ?r ?p)"}}}},
                   {}};
  ProblemParts& problem = models.problem;
  for (const std::string& ring : shuffled(problem.addObjects("ring", size + 1, "ring"), random)) {
    problem.init.push_back(atom({"loose", ring}));
    problem.goal.push_back(atom({"hangs", ring}));
  }
  for (const std::string& peg : problem.addObjects("peg", size, "peg"))
    problem.init.push_back(atom({"vacant", peg}));
  return models;
}

Models courier(int size, int spare) {
  Models models = {{"courier",
                    typed("house charge"),
                    {{"street", typed("?a ?b - house")},
                     {"less", typed("?c ?rest - charge")},
                     {"at-door", typed("?h - house")},
                     {"charged", typed("?c - charge")},
                     {"called", typed("?h - house")}},
                    {{"walk",
                      typed("?from ?to - house ?c ?rest - charge"),
                      {"(at-door ?from)", "(street ?from ?to)", "(charged ?c)", "(less ?c ?rest)"},
                      {"(at-door ?to)", "(called ?to)", "(charged ?rest)"},
                      {"(at-door ?from)", "(charged ?c)"}}}},
                   {}};
  ProblemParts& problem = models.problem;
  // Two streets there and back, the third one way: 5 · size steps.
  const int steps = 5 * size - 1 + spare;
  const auto charges = problem.addObjects("charge", steps + 1, "charge");
  for (std::size_t i = 0; i + 1 < charges.size(); ++i)
    problem.init.push_back(atom({"less", charges[i + 1], charges[i]}));
  problem.init.push_back(atom({"charged", charges.back()}));
  problem.objects.push_back({"middle", "house"});
  problem.init.push_back(atom({"at-door", "middle"}));
  for (const std::string street : {"east", "north", "west"}) {
    std::string before = "middle";
    for (const std::string& house : problem.addObjects(street, size, "house")) {
      problem.init.push_back(atom({"street", before, house}));
      problem.init.push_back(atom({"street", house, before}));
      before = house;
    }
    problem.goal.push_back(atom({"called", before}));
  }
  return models;
}

Models guests(int size, RandomSource& random) {
  Models models = {{"evening",
                    typed("guest chair"),
                    {{"arrived", typed("?g - guest")},
                     {"seated", typed("?g - guest")},
                     {"sits-on", typed("?g - guest ?c - chair")},
                     {"unused", typed("?c - chair")},
                     {"friends", typed("?a ?b - guest")}},
                    {{"seat",
                      typed("?g - guest ?c - chair"),
                      {"(arrived ?g)", "(unused ?c)"},
                      {"(seated ?g)", "(sits-on ?g ?c)"},
                      {"(arrived ?g)", "(unused ?c)"}},
                     {"swap",
                      typed("?g ?other - guest ?c - chair"),
                      {"(sits-on ?g ?c)", "(friends ?g ?other)", "(arrived ?other)"},
                      {"(seated ?other)", "(sits-on ?other ?c)", "(arrived ?g)"},
                      {"(seated ?g)", "(sits-on ?g ?c)", "(arrived ?other)"}},
                     {"rise",
                      typed("?g - guest ?c - chair"),
                      {"(sits-on ?g ?c)"},
                      {"(arrived ?g)", "(unused ?c)"},
                      {"(seated ?g)", "(sits-on ?g ?c)"}}}},
                   {}};
  ProblemParts& problem = models.problem;
  for (const std::string& chair : problem.addObjects("chair", size, "chair"))
    problem.init.push_back(atom({"unused", chair}));
  const auto names = problem.addObjects("guest", 2 * size, "guest");
  for (const std::string& guest : names) {
    problem.init.push_back(atom({"arrived", guest}));
    const std::string& friend_of = oneOf(names, random);
    if (friend_of != guest) problem.init.push_back(atom({"friends", guest, friend_of}));
  }
  // One more than there are chairs; the others only make the space larger.
  const auto wanted = shuffled(names, random);
  for (std::size_t i = 0; i <= static_cast<std::size_t>(size); ++i)
    problem.goal.push_back(atom({"seated", wanted[i]}));
  return models;
}

}  // namespace goal_alignment::benchmarks
