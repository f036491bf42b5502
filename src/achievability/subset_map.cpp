// SPDX-License-Identifier: BSD-3-Clause
#include "subset_map.h"

#include <cadical.hpp>
#include <utility>

namespace goal_alignment::achievability {

namespace {

/// What every solver with the IPASIR interface returns.
constexpr int kSatisfiable = 10;
constexpr int kUnsatisfiable = 20;

/// A clause in the solver: its header, two watches, what points to it, and room to grow.
constexpr std::size_t kBytesPerClause = 96;

/// Ends the solver when the limits do.
class LimitTerminator : public CaDiCaL::Terminator {
 public:
  explicit LimitTerminator(const Limits& limits) : limits_(limits) {}

  bool terminate() override {
    const LimitReason now = limits_.interruption();
    if (now != LimitReason::None) reason_ = now;
    return reason_ != LimitReason::None;
  }
  LimitReason reason() const { return reason_; }

 private:
  Limits limits_;
  LimitReason reason_ = LimitReason::None;
};

}  // namespace

/// The formula. Variable i + 1: candidate i is in the set.
class SubsetMap::Solver {
 public:
  explicit Solver(std::size_t candidates)
      : candidates_(static_cast<int>(candidates)), last_variable_(candidates_) {
    // Thousands of easy calls with a few clauses more each: preprocessing would only cost time.
    solver_.configure("plain");
    solver_.set("quiet", 1);
    solver_.set("lucky", 0);
    solver_.set("walk", 0);
    solver_.reserve(candidates_);
    // With every decision positive a model is nearly always a maximal one at once.
    for (int variable = 1; variable <= candidates_; ++variable)
      solver_.phase(variable);
  }

  int newVariable() { return ++last_variable_; }

  void add(const std::vector<int>& clause) {
    for (const int literal : clause)
      solver_.add(literal);
    solver_.add(0);
  }

  enum class Status { Unsatisfiable, Satisfiable, Terminated };

  Status solve(int assumption, LimitTerminator& terminator) {
    if (terminator.terminate()) return Status::Terminated;
    solver_.connect_terminator(&terminator);
    solver_.assume(assumption);
    const int status = solver_.solve();
    solver_.disconnect_terminator();
    if (status == kSatisfiable) return Status::Satisfiable;
    return status == kUnsatisfiable ? Status::Unsatisfiable : Status::Terminated;
  }

  CandidateSet model() {
    CandidateSet set(static_cast<std::size_t>(candidates_));
    for (int variable = 1; variable <= candidates_; ++variable)
      set.set(static_cast<std::size_t>(variable) - 1, solver_.val(variable) > 0);
    return set;
  }

 private:
  CaDiCaL::Solver solver_;
  int candidates_;
  int last_variable_;
};

namespace {

std::vector<int> literals(const CandidateSet& set, int sign) {
  std::vector<int> clause;
  for (const std::size_t candidate : members(set))
    clause.push_back(sign * (static_cast<int>(candidate) + 1));
  return clause;
}

}  // namespace

SubsetMap::SubsetMap(std::size_t candidates)
    : candidates_(candidates), solver_(std::make_unique<Solver>(candidates)) {}

SubsetMap::SubsetMap(SubsetMap&&) noexcept = default;
SubsetMap::~SubsetMap() = default;

void SubsetMap::add(const std::vector<int>& clause) {
  solver_->add(clause);
  bytes_ += kBytesPerClause + clause.size() * sizeof(int);
}

void SubsetMap::blockUp(const CandidateSet& conflict) {
  add(literals(conflict, -1));
  blocked_up_.push_back(conflict);
  bytes_ += sizeof(CandidateSet) + conflict.num_blocks() * sizeof(CandidateSet::block_type);
}

void SubsetMap::blockDown(const CandidateSet& achieved) {
  add(literals(~achieved, 1));
}

/// Adds what can be added without a conflict; blocks below can't be in the way of a larger set.
CandidateSet SubsetMap::grown(CandidateSet set) const {
  CandidateSet barred(candidates_);
  const auto bar = [&] {
    for (const CandidateSet& conflict : blocked_up_) {
      const CandidateSet missing = conflict - set;
      if (missing.count() == 1) barred |= missing;
    }
  };
  bar();
  for (std::size_t next = 0; next < candidates_; ++next) {
    if (set.test(next) || barred.test(next)) continue;
    set.set(next);
    bar();
  }
  return set;
}

SubsetMap::Unexplored SubsetMap::maximal(std::size_t max_sets, const Limits& limits) {
  Unexplored found;
  LimitTerminator terminator(limits);
  // The sets found by this call exclude each other as long as this variable is assumed.
  const int different = solver_->newVariable();
  while (found.sets.size() < max_sets) {
    if (bytes_ > limits.bytes) found.limit = LimitReason::Memory;
    if (bytes_ > limits.bytes) break;
    const Solver::Status status = solver_->solve(different, terminator);
    if (status == Solver::Status::Terminated) found.limit = terminator.reason();
    if (status != Solver::Status::Satisfiable) break;
    CandidateSet set = grown(solver_->model());
    std::vector<int> clause = literals(~set, 1);
    clause.push_back(-different);
    add(clause);
    found.sets.push_back(std::move(set));
  }
  add({-different});
  return found;
}

}  // namespace goal_alignment::achievability
