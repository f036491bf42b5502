// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include "drawing.h"
#include "families.h"

namespace goal_alignment::benchmarks {
namespace {

DomainParts survey() {
  return {
      "survey",
      typed("probe site sample"),
      {{"passable", typed("?p - probe ?a ?b - site")},
       {"base-in-sight", typed("?s - site")},
       {"stays", typed("?p - probe ?s - site")},
       {"found-at", typed("?x - sample ?s - site")},
       {"tray-empty", typed("?p - probe")},
       {"in-tray", typed("?x - sample ?p - probe")},
       {"examined", typed("?x - sample ?p - probe")},
       {"reported", typed("?x - sample")}},
      {{"travel",
        typed("?p - probe ?from ?to - site"),
        {"(stays ?p ?from)", "(passable ?p ?from ?to)"},
        {"(stays ?p ?to)"},
        {"(stays ?p ?from)"}},
       {"scoop",
        typed("?x - sample ?p - probe ?s - site"),
        {"(found-at ?x ?s)", "(stays ?p ?s)", "(tray-empty ?p)"},
        {"(in-tray ?x ?p)"},
        {"(found-at ?x ?s)", "(tray-empty ?p)"}},
       {"examine", typed("?x - sample ?p - probe"), {"(in-tray ?x ?p)"}, {"(examined ?x ?p)"}, {}},
       {"put-back",
        typed("?x - sample ?p - probe ?s - site"),
        {"(in-tray ?x ?p)", "(stays ?p ?s)"},
        {"(found-at ?x ?s)", "(tray-empty ?p)"},
        {"(in-tray ?x ?p)"}},
       {"report",
        typed("?x - sample ?p - probe ?s - site"),
        {"(examined ?x ?p)", "(stays ?p ?s)", "(base-in-sight ?s)"},
        {"(reported ?x)"},
        {}}}};
}

}  // namespace

Models probes(int size, RandomSource& random) {
  Models models = {survey(), {}, {"found-at"}};
  ProblemParts& problem = models.problem;
  const auto sites = problem.addObjects("site", size + 3, "site");
  for (const std::string& probe : problem.addObjects("probe", 1 + size / 4, "probe")) {
    // Each probe's roads form a tree over all the sites: there is always a way.
    const auto order = shuffled(sites, random);
    for (std::size_t i = 1; i < order.size(); ++i) {
      const std::string& other = order[random.below(i)];
      problem.init.push_back(atom({"passable", probe, order[i], other}));
      problem.init.push_back(atom({"passable", probe, other, order[i]}));
    }
    problem.init.push_back(atom({"stays", probe, oneOf(sites, random)}));
    problem.init.push_back(atom({"tray-empty", probe}));
  }
  problem.init.push_back(atom({"base-in-sight", oneOf(sites, random)}));
  for (const std::string& sample : problem.addObjects("sample", size, "sample")) {
    problem.init.push_back(atom({"found-at", sample, oneOf(sites, random)}));
    problem.goal.push_back(atom({"reported", sample}));
  }
  problem.goal.push_back(atom({"tray-empty", "probe0"}));
  return models;
}

}  // namespace goal_alignment::benchmarks
