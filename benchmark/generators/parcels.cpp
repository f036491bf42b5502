// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include "drawing.h"
#include "families.h"

namespace goal_alignment::benchmarks {
namespace {

DomainParts mail() {
  const std::vector<Typed> transfer = typed("?p - parcel ?v - vehicle ?s - stop");
  return {
      "mail",
      typed("van plane - vehicle vehicle parcel stop"),
      {{"street", typed("?a ?b - stop")},
       {"airway", typed("?a ?b - stop")},
       {"halts", typed("?v - vehicle ?s - stop")},
       {"aboard", typed("?p - parcel ?v - vehicle")},
       {"lies", typed("?p - parcel ?s - stop")}},
      {{"drive",
        typed("?v - van ?from ?to - stop"),
        {"(street ?from ?to)", "(halts ?v ?from)"},
        {"(halts ?v ?to)"},
        {"(halts ?v ?from)"}},
       {"fly",
        typed("?v - plane ?from ?to - stop"),
        {"(airway ?from ?to)", "(halts ?v ?from)"},
        {"(halts ?v ?to)"},
        {"(halts ?v ?from)"}},
       {"load", transfer, {"(lies ?p ?s)", "(halts ?v ?s)"}, {"(aboard ?p ?v)"}, {"(lies ?p ?s)"}},
       {"unload",
        transfer,
        {"(aboard ?p ?v)", "(halts ?v ?s)"},
        {"(lies ?p ?s)"},
        {"(aboard ?p ?v)"}}}};
}

}  // namespace

Models parcels(int size, RandomSource& random) {
  constexpr int kStopsInTown = 3;  // the first is the airfield
  const int towns = 2 + size / 4;
  Models models = {mail(), {}, {"lies"}};
  ProblemParts& problem = models.problem;
  const auto stops = problem.addObjects("stop", towns * kStopsInTown, "stop");
  const auto vans = problem.addObjects("van", towns, "van");
  const auto airfield = [&](int town) {
    return stops[static_cast<std::size_t>(town * kStopsInTown)];
  };
  for (int town = 0; town < towns; ++town) {
    const auto first = stops.begin() + town * kStopsInTown;
    const std::vector<std::string> here(first, first + kStopsInTown);
    for (const std::string& a : here) {
      for (const std::string& b : here) {
        if (a != b) problem.init.push_back(atom({"street", a, b}));
      }
    }
    for (int other = 0; other < towns; ++other) {
      if (other != town) problem.init.push_back(atom({"airway", airfield(town), airfield(other)}));
    }
    problem.init.push_back(
        atom({"halts", vans[static_cast<std::size_t>(town)], oneOf(here, random)}));
  }
  for (const std::string& plane : problem.addObjects("plane", 1 + size / 8, "plane")) {
    const auto town = random.below(static_cast<std::size_t>(towns));
    problem.init.push_back(atom({"halts", plane, airfield(static_cast<int>(town))}));
  }
  for (const std::string& parcel : problem.addObjects("parcel", size, "parcel")) {
    const auto way = shuffled(stops, random);
    problem.init.push_back(atom({"lies", parcel, way[0]}));
    problem.goal.push_back(atom({"lies", parcel, way[1]}));
  }
  return models;
}

}  // namespace goal_alignment::benchmarks
