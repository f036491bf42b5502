// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <vector>

#include "drawing.h"
#include "families.h"

namespace goal_alignment::benchmarks {
namespace {

ActionParts handling(const std::string& name, const std::string& place, bool take) {
  const bool cupboard = place == "cupboard";
  const std::string where = cupboard ? "(inside ?d ?p)" : "(upon ?d ?p)";
  ActionParts action = {name,
                        typed("?d - dish ?p - " + place + " ?r - room ?h - hand"),
                        {"(robot-in ?r)", "(stands-in ?p ?r)", "(in-reach ?p)"},
                        {},
                        {}};
  if (cupboard) action.condition.emplace_back("(open ?p)");
  std::vector<std::string>& gone = take ? action.del : action.add;
  std::vector<std::string>& come = take ? action.add : action.del;
  action.condition.push_back(take ? where : "(holds ?h ?d)");
  action.condition.emplace_back(take ? "(idle ?h)" : "(light ?d)");
  if (take) action.condition.emplace_back("(light ?d)");
  if (!take && !cupboard) action.condition.emplace_back("(bare ?p)");
  gone.push_back(where);
  come.emplace_back("(holds ?h ?d)");
  (take ? action.del : action.add).emplace_back("(idle ?h)");
  if (!cupboard) {
    come.emplace_back("(bare ?p)");
    gone.emplace_back("(laid-out ?d)");
  }
  return action;
}

DomainParts domain() {
  return {"household",
          typed("cupboard stand - place place room dish hand"),
          {{"door", typed("?a ?b - room")},
           {"stands-in", typed("?p - place ?r - room")},
           {"in-reach", typed("?p - place")},
           {"light", typed("?d - dish")},
           {"robot-in", typed("?r - room")},
           {"open", typed("?c - cupboard")},
           {"shut", typed("?c - cupboard")},
           {"inside", typed("?d - dish ?c - cupboard")},
           {"upon", typed("?d - dish ?s - stand")},
           {"bare", typed("?s - stand")},
           {"laid-out", typed("?d - dish")},
           {"holds", typed("?h - hand ?d - dish")},
           {"idle", typed("?h - hand")}},
          {{"go",
            typed("?from ?to - room"),
            {"(robot-in ?from)", "(door ?from ?to)"},
            {"(robot-in ?to)"},
            {"(robot-in ?from)"}},
           {"unlatch",
            typed("?c - cupboard ?r - room ?h - hand"),
            {"(robot-in ?r)", "(stands-in ?c ?r)", "(shut ?c)", "(idle ?h)"},
            {"(open ?c)"},
            {"(shut ?c)"}},
           {"latch",
            typed("?c - cupboard ?r - room ?h - hand"),
            {"(robot-in ?r)", "(stands-in ?c ?r)", "(open ?c)", "(idle ?h)"},
            {"(shut ?c)"},
            {"(open ?c)"}},
           handling("take-out", "cupboard", true),
           handling("stow", "cupboard", false),
           handling("take-up", "stand", true),
           handling("set-down", "stand", false)}};
}

void furnish(const std::vector<std::string>& places, const std::vector<std::string>& rooms,
             RandomSource& random, std::vector<std::string>& init) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    init.push_back(atom({"stands-in", places[i], oneOf(rooms, random)}));
    if (i % 10 != 9) init.push_back(atom({"in-reach", places[i]}));  // every tenth is too high
  }
}

}  // namespace

Models household(const HouseholdSize& size, RandomSource& random) {
  Models models = {domain(), {}, {"inside"}};
  ProblemParts& problem = models.problem;
  const auto rooms = problem.addObjects("room", size.rooms, "room");
  for (std::size_t i = 1; i < rooms.size(); ++i) {
    const std::string& neighbour = rooms[random.below(i)];
    problem.init.push_back(atom({"door", rooms[i], neighbour}));
    problem.init.push_back(atom({"door", neighbour, rooms[i]}));
  }
  problem.init.push_back(atom({"robot-in", rooms.front()}));
  for (const std::string& hand : problem.addObjects("hand", 2, "hand"))
    problem.init.push_back(atom({"idle", hand}));

  const auto cupboards = problem.addObjects("cupboard", size.cupboards, "cupboard");
  const auto stands = problem.addObjects("stand", size.stands, "stand");
  furnish(cupboards, rooms, random, problem.init);
  furnish(stands, rooms, random, problem.init);
  for (const std::string& cupboard : cupboards)
    problem.init.push_back(atom({"shut", cupboard}));
  for (const std::string& stand : stands)
    problem.init.push_back(atom({"bare", stand}));

  const auto dishes = problem.addObjects("dish", size.dishes, "dish");
  // Only what the robot can reach is wanted, and so all of it can be had.
  const auto in_reach = std::min<std::size_t>(cupboards.size(), 9);
  for (std::size_t i = 0; i < dishes.size(); ++i) {
    const bool wanted = i < static_cast<std::size_t>(size.laid);
    const std::string& cupboard =
        wanted ? cupboards[random.below(in_reach)] : oneOf(cupboards, random);
    if (i % 20 != 19 || wanted) problem.init.push_back(atom({"light", dishes[i]}));
    problem.init.push_back(atom({"inside", dishes[i], cupboard}));
    if (!wanted) continue;
    problem.goal.push_back(atom({"laid-out", dishes[i]}));
    const std::string shut = atom({"shut", cupboard});
    if (std::find(problem.goal.begin(), problem.goal.end(), shut) == problem.goal.end())
      problem.goal.push_back(shut);
  }
  return models;
}

Models household(int size, RandomSource& random) {
  HouseholdSize all;
  all.rooms = 2 + size / 16;
  all.cupboards = 2 + size / 8;
  all.stands = 3 + size / 8;
  all.dishes = size;
  all.laid = std::max(1, size / 8);
  return household(all, random);
}

}  // namespace goal_alignment::benchmarks
