// SPDX-License-Identifier: BSD-3-Clause
#include "analysis.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "goal_alignment/common/exceptions.h"
#include "human_state.h"

namespace goal_alignment::session {

using achievability::CandidateSet;
using achievability::Conflict;
using achievability::Verdict;

namespace {

/// How many states one search for a belief may generate. A belief only orders questions, so where
/// it is not cheap its bound from π^H will do; Algorithm 1 asks for the optimal cost.
constexpr std::uint64_t kBeliefStates = 2'000;
constexpr std::uint64_t kPaperBeliefStates = 100'000;

/// Searches for beliefs, which have bounds to fall back on, take at most this share of the time
/// limit.
constexpr double kShareOfBeliefs = 0.1;

/// This share of the time limit is not spent on finding all conflicts.
constexpr double kShareOfDialogue = 0.75;

/// A dialogue that does not wait for all conflicts does not wait long for proofs, either.
constexpr std::uint64_t kLazySteps = 5'000'000;

std::vector<pddl::Atom> resolved(const std::vector<GroundName>& atoms, const pddl::Model& robot) {
  std::vector<pddl::Atom> result;
  for (const GroundName& name : atoms) {
    std::string why_not;
    auto atom = robot.resolve(name, &why_not);
    if (!atom) {
      throw pddl::SemanticError(robot.problem_source, {},
                                "the robot's model can't have " + name.text() + ": " + why_not);
    }
    result.push_back(std::move(*atom));
  }
  return result;
}

std::string countsOf(const std::vector<Conflict>& conflicts) {
  const auto proven = std::count_if(conflicts.begin(), conflicts.end(),
                                    [](const Conflict& conflict) { return conflict.proven; });
  const auto suspected = static_cast<std::ptrdiff_t>(conflicts.size()) - proven;
  return std::to_string(proven) + " proven, " + std::to_string(suspected) + " suspected";
}

}  // namespace

void Analysis::read(const Input& input) {
  pddl::Model robot = pddl::readModel(input.robot_domain, input.robot_problem, budget_.limits());
  pddl::Model human = pddl::readModel(input.human_domain, input.human_problem, budget_.limits());
  applyHumanFacts(input.human_facts, input.human_plan, robot, human, budget_.limits());
  unit_costs_ = !(options_.costs && robot.has_costs && human.has_costs);
  auto problem = std::make_unique<alignment::Problem>(alignment::makeProblem(
      std::move(robot), std::move(human), input.goal, input.human_plan, budget_.limits()));
  if (options_.negative_candidates) alignment::addNegativeCandidates(*problem, budget_.limits());
  problem_ = std::move(problem);
}

void Analysis::analyseRobot() {
  achievability::SearchBudget budget;
  budget.threads = options_.threads;
  if (options_.conflicts == ConflictMode::Lazy) budget.symbolic = kLazySteps;
  robot_ = alignment::analyseRobot(*problem_, unit_costs_, budget, budget_.limits());
  policy_ = questions::makePolicy(options_.policy, policyContext());
  conflicts_ended_.clear();
}

void Analysis::believe() {
  if (!beliefs_.empty()) return;
  std::vector<double> differences(robot().candidateCount(), 0);
  if (options_.belief.mode != alignment::BeliefMode::Flat) {
    alignment::CostOptions cheap{true, kBeliefStates, true};
    cheap.search_seconds = kShareOfBeliefs * budget_.seconds();
    differences = costDifferences(cheap);
  }
  beliefs_ = alignment::beliefs(*problem_, differences, options_.belief);
}

std::vector<double> Analysis::costDifferences(alignment::CostOptions options) {
  options.unit_costs = unit_costs_;
  options.threads = options_.threads;
  alignment::CostDifferences differences =
      alignment::costDifferences(*problem_, options, budget_.limits());
  belief_calls_ += differences.planner_calls;
  return std::move(differences.values);
}

void Analysis::findConflicts(const CandidateSet& wished) {
  // What was given up since they were sought first may have made them needless.
  if (knownPlanFor(wished) != nullptr) return;
  const Limits own = budget_.limits(kShareOfDialogue);
  if (robot().findAllConflicts(own) || own.interruption() == LimitReason::Cancelled) return;
  conflicts_ended_ = std::string("finding all conflicts stopped: ") +
                     toString(robot().lastLimit()) + " (" + countsOf(robot().conflicts()) + ")";
}

questions::PolicyContext Analysis::policyContext() {
  questions::PolicyContext context;
  for (const alignment::Candidate& candidate : problem_->candidates)
    context.is_static.push_back(candidate.is_static);
  context.ask_static = options_.static_candidates;
  context.seed = options_.seed;
  context.paper_beliefs = [this] {
    return alignment::paperBeliefs(costDifferences({true, kPaperBeliefStates}),
                                   options_.belief.beta);
  };
  context.unachievable_alone = [this] { return unachievableAlone(); };
  // The deadline is looked at after each decision, so that a seed replays.
  context.poll = [this] {
    if (budget_.cancelOnly().interruption() == LimitReason::Cancelled)
      throw LimitReached(LimitReason::Cancelled, "choosing a question");
  };
  return context;
}

std::vector<bool> Analysis::unachievableAlone() {
  std::vector<bool> result;
  for (const Verdict verdict : robot().reachableAlone(budget_.limits())) {
    if (verdict == Verdict::Unknown)
      throw LimitReached(robot().lastLimit(), "a check of Algorithm 1");
    result.push_back(verdict == Verdict::Unachievable);
  }
  return result;
}

void Analysis::setRobotState(const std::vector<GroundName>& atoms) {
  if (!problem_) throw std::logic_error("there is no task yet whose robot could have a state");
  problem_->robot.init = resolved(atoms, problem_->robot);
  if (hasRobot()) earlier_robot_calls_ += robot().plannerCalls();
  robot_ = {};
}

std::vector<GroundName> Analysis::robotState() const {
  std::vector<GroundName> atoms;
  if (!problem_) return atoms;
  atoms.reserve(problem_->robot.init.size());
  for (const pddl::Atom& atom : problem_->robot.init)
    atoms.push_back(problem_->robot.name(atom));
  return atoms;
}

questions::Situation Analysis::situation(const std::vector<questions::Knowledge>& knowledge) const {
  return {knowledge, beliefs_, robot().conflicts()};
}

const task::Plan* Analysis::knownPlanFor(const CandidateSet& set) const {
  for (const achievability::AchievedSets::Achieved& achieved : robot().achieved()) {
    if (set.is_subset_of(achieved.set)) return &achieved.plan;
  }
  return nullptr;
}

std::size_t Analysis::plannerCalls() const {
  return belief_calls_ + earlier_robot_calls_ + (hasRobot() ? robot().plannerCalls() : 0);
}

}  // namespace goal_alignment::session
