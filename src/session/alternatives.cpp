// SPDX-License-Identifier: BSD-3-Clause
#include "alternatives.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "extra_cost.h"
#include "fluents.h"

namespace goal_alignment::session {

using achievability::CandidateSet;
using questions::Knowledge;

namespace {

/// More alternatives than a person reads.
constexpr std::size_t kMaxAlternatives = 10;

/// Who has ended a dialogue does not wait long for what they could choose.
constexpr double kMaxSeconds = 3;

/// How often what was answered YES is given up all the same: as rarely as a belief is wrong that is
/// as sure as beliefs get.
constexpr double kTakenBack = 0.02;

double probabilityOf(const CandidateSet& given_up, const std::vector<double>& beliefs) {
  double product = 1;
  for (const std::size_t f : achievability::members(given_up))
    product *= 1 - beliefs[f];
  return product;
}

/// None of which is more than another.
std::vector<CandidateSet> likeliest(std::vector<CandidateSet> sets,
                                    const std::vector<double>& beliefs) {
  std::stable_sort(sets.begin(), sets.end(), [&](const CandidateSet& a, const CandidateSet& b) {
    const double of_a = probabilityOf(a, beliefs);
    const double of_b = probabilityOf(b, beliefs);
    return of_a != of_b ? of_a > of_b : a.count() < b.count();
  });
  std::vector<CandidateSet> result;
  for (const CandidateSet& set : sets) {
    if (result.size() == kMaxAlternatives) break;
    const bool is_more =
        std::any_of(result.begin(), result.end(),
                    [&](const CandidateSet& likelier) { return likelier.is_subset_of(set); });
    if (!is_more) result.push_back(set);
  }
  return result;
}

/// What the beliefs become with the answers.
std::vector<double> answeredBeliefs(const Dialogue& dialogue, const Analysis& analysis) {
  std::vector<double> result = analysis.beliefs();
  for (const std::size_t f : achievability::members(dialogue.with(Knowledge::Wanted)))
    result[f] = 1 - kTakenBack * (1 - analysis.beliefs()[f]);
  return result;
}

/// What the plans that are known leave out: more than is needed, perhaps.
std::vector<CandidateSet> leftOutByKnownPlans(const CandidateSet& all, const Analysis& analysis) {
  std::vector<CandidateSet> sets;
  for (const achievability::AchievedSets::Achieved& achieved : analysis.robot().achieved())
    sets.push_back(all - achieved.set);
  return sets;
}

/// Where all can be had, but the person would have been asked whether it is worth what it costs.
CandidateSet costlySet(const CandidateSet& all, const Dialogue& dialogue, Analysis& analysis,
                       const Options& options) {
  CandidateSet result(all.size());
  const task::Plan* plan = analysis.knownPlanFor(all);
  if (!costsMatter(options) || plan == nullptr) return result;
  const CandidateSet kept =
      dialogue.with(Knowledge::Wanted) | (dialogue.with(Knowledge::Unsure) & dialogue.assumed());
  const auto costly =
      tooCostly(analysis, kept, all - kept, *plan, options.max_extra_cost, all.size());
  for (const Dialogue::AskedCandidate& posed : costly)
    result.set(posed.candidate);
  return result;
}

/// One empty set where nothing needs to be given up and costs don't matter.
std::vector<CandidateSet> searchSets(const CandidateSet& all, const std::vector<double>& beliefs,
                                     const Limits& limits, const Dialogue& dialogue,
                                     Analysis& analysis, const Options& options) {
  std::vector<CandidateSet> sets =
      analysis.robot().alternatives(all, beliefs, kMaxAlternatives, limits);
  if (!sets.empty() && sets.front().none()) sets = {costlySet(all, dialogue, analysis, options)};
  return sets;
}

std::vector<CandidateSet> setsToGiveUp(OutcomeCode code, const std::vector<double>& beliefs,
                                       const Dialogue& dialogue, Analysis& analysis,
                                       const Options& options) {
  const bool of_wanted = code == OutcomeCode::ExpectationUnachievable;
  const CandidateSet all =
      of_wanted ? dialogue.with(Knowledge::Wanted) : ~dialogue.with(Knowledge::NotWanted);
  std::vector<CandidateSet> sets;
  if (outcomeTraits(code).alternatives == AlternativesFrom::ShortSearch) {
    const Limits whole = analysis.budget().limits();
    const Limits own = of_wanted ? whole : whole.withSeconds(kMaxSeconds);
    sets = searchSets(all, beliefs, own, dialogue, analysis, options);
  }
  return sets.empty() ? leftOutByKnownPlans(all, analysis) : sets;
}

}  // namespace

std::vector<Alternative> alternativesAfter(OutcomeCode code, const Dialogue& dialogue,
                                           Analysis& analysis, const Options& options) {
  const bool none = outcomeTraits(code).alternatives == AlternativesFrom::Nothing;
  if (none || !analysis.hasRobot() || analysis.beliefs().empty()) return {};
  const std::vector<double> beliefs = answeredBeliefs(dialogue, analysis);
  std::vector<CandidateSet> sets;
  try {
    sets = setsToGiveUp(code, beliefs, dialogue, analysis, options);
  } catch (const std::exception&) {
    return {};  // an outcome must not get lost for what could be said besides
  }
  std::vector<Alternative> result;
  for (const CandidateSet& given_up : likeliest(std::move(sets), beliefs)) {
    if (given_up.none()) continue;
    result.push_back({fluentsOf(analysis.problem(), given_up), probabilityOf(given_up, beliefs)});
  }
  return result;
}

}  // namespace goal_alignment::session
