// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <exception>
#include <utility>

#include "implementation.h"

/// What there could be instead, where a dialogue ends without a plan. Nobody is left with nothing
/// to choose as long as some plan is known for what was asked for.
namespace goal_alignment::session {

using achievability::AchievedSets;
using achievability::CandidateSet;
using questions::Knowledge;

namespace {

/// More alternatives than a person reads.
constexpr std::size_t kMaxAlternatives = 10;

/// Who has ended a dialogue does not wait long for what they could choose.
constexpr double kSecondsToOffer = 3;

/// How often what was answered YES is given up all the same: as rarely as a belief is wrong that is
/// as sure as beliefs get.
constexpr double kTakenBack = 0.02;

double probabilityOf(const CandidateSet& given_up, const std::vector<double>& beliefs) {
  double product = 1;
  for (const std::size_t f : achievability::members(given_up))
    product *= 1 - beliefs[f];
  return product;
}

bool hasTime(OutcomeCode code) {
  return code != OutcomeCode::TimeLimit && code != OutcomeCode::MemoryLimit;
}

bool leavesAChoice(OutcomeCode code) {
  switch (code) {
    case OutcomeCode::ExpectationUnachievable:
    case OutcomeCode::TimeLimit:
    case OutcomeCode::MemoryLimit:
    case OutcomeCode::BudgetLimit:
    case OutcomeCode::Declined:
    case OutcomeCode::QuestionLimit:
    case OutcomeCode::UnsureBlocks:
      return true;
    default:
      return false;
  }
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

}  // namespace

/// Everything not answered NO but as little as will do to have the rest; after a proof that what
/// was answered YES can't be had, the same of that. The likeliest first.
std::vector<Alternative> Session::Implementation::alternativesAfter(OutcomeCode code) {
  std::vector<Alternative> result;
  if (!leavesAChoice(code) || !robot_analysis_.achievability || beliefs_.empty()) return result;
  const std::vector<double> beliefs = answeredBeliefs();
  for (const CandidateSet& given_up : setsToGiveUp(code, beliefs)) {
    if (given_up.any()) result.push_back({fluents(given_up), probabilityOf(given_up, beliefs)});
  }
  return result;
}

std::vector<CandidateSet> Session::Implementation::setsToGiveUp(
    OutcomeCode code, const std::vector<double>& beliefs) {
  const bool of_wanted = code == OutcomeCode::ExpectationUnachievable;
  const CandidateSet all =
      of_wanted ? dialogue_.with(Knowledge::Wanted) : ~dialogue_.with(Knowledge::NotWanted);
  std::vector<CandidateSet> sets;
  try {
    if (hasTime(code)) {
      const Limits own = of_wanted ? limits() : limits().withSeconds(kSecondsToOffer);
      sets = robot().alternatives(all, beliefs, kMaxAlternatives, own);
      if (!sets.empty() && sets.front().none()) sets = {costlySet(all)};
    }
    if (sets.empty()) sets = knownSetsToGiveUp(all);
  } catch (const std::exception&) {
    return {};  // an outcome must not get lost for what could be said besides
  }
  return likeliest(std::move(sets), beliefs);
}

/// What the plans that are known leave out: more than is needed, perhaps.
std::vector<CandidateSet> Session::Implementation::knownSetsToGiveUp(
    const CandidateSet& all) const {
  std::vector<CandidateSet> sets;
  for (const AchievedSets::Achieved& achieved : robot().achieved())
    sets.push_back(all - achieved.set);
  return sets;
}

/// Where all can be had, but the person would have been asked whether it is worth what it costs.
CandidateSet Session::Implementation::costlySet(const CandidateSet& all) {
  CandidateSet result(all.size());
  const task::Plan* plan = knownPlanFor(all);
  if (!costsMatter() || plan == nullptr) return result;
  const CandidateSet kept =
      dialogue_.with(Knowledge::Wanted) | (dialogue_.with(Knowledge::Unsure) & dialogue_.assumed());
  for (const Dialogue::AskedCandidate& posed : tooCostly(kept, all - kept, *plan, all.size()))
    result.set(posed.candidate);
  return result;
}

/// Null where none is remembered.
const task::Plan* Session::Implementation::knownPlanFor(const CandidateSet& set) const {
  for (const AchievedSets::Achieved& achieved : robot().achieved()) {
    if (set.is_subset_of(achieved.set)) return &achieved.plan;
  }
  return nullptr;
}

/// What the beliefs become with the answers.
std::vector<double> Session::Implementation::answeredBeliefs() const {
  std::vector<double> result = beliefs_;
  for (const std::size_t f : achievability::members(dialogue_.with(Knowledge::Wanted)))
    result[f] = 1 - kTakenBack * (1 - beliefs_[f]);
  return result;
}

}  // namespace goal_alignment::session
