// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/robot_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "goal_alignment/ros_interface/message_conversion.h"

namespace goal_alignment::ros_interface {

using session::Receipt;

Receipt RobotFacts::set(const std::vector<Fluent>& facts) {
  std::vector<Literal> literals;
  try {
    literals = toLiterals(facts, "facts");
  } catch (const std::invalid_argument& error) {
    return {false, error.what()};
  }
  if (literals.empty()) return {false, "no fact is given"};

  const std::lock_guard<std::mutex> lock(mutex_);
  Changes changes;
  for (std::size_t i = 0; i < literals.size(); ++i) {
    const Literal& literal = literals[i];
    std::string why_not;
    if (model_ && !model_->resolve(literal.atom, &why_not)) {
      return {false, fmt::format("facts[{}]: the robot's model can't have {}: {}", i,
                                 literal.atom.text(), why_not)};
    }
    const auto [known, is_new] = changes.emplace(literal.atom, !literal.negated);
    if (!is_new && known->second == literal.negated) {
      return {false, fmt::format("facts[{}]: {} is both true and false", i, literal.atom.text())};
    }
  }
  for (const auto& [atom, holds] : changes)
    all_[atom] = session_[atom] = holds;
  ++version_;
  return {true, ""};
}

void RobotFacts::beginSession(bool earlier_hold) {
  const std::lock_guard<std::mutex> lock(mutex_);
  session_ = earlier_hold ? all_ : Changes{};
  ++version_;
  model_.reset();
}

void RobotFacts::setModel(const pddl::Model& model) {
  auto copy = std::make_shared<pddl::Model>(model);
  copy->init.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  model_ = std::move(copy);
}

std::vector<GroundName> RobotFacts::overlaid(std::vector<GroundName> state,
                                             std::vector<GroundName>& left_out) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::set<GroundName> atoms(std::make_move_iterator(state.begin()),
                             std::make_move_iterator(state.end()));
  for (const auto& [atom, holds] : session_) {
    if (model_ && !model_->resolve(atom)) {
      left_out.push_back(atom);
    } else if (holds) {
      atoms.insert(atom);
    } else {
      atoms.erase(atom);
    }
  }
  return {atoms.begin(), atoms.end()};
}

}  // namespace goal_alignment::ros_interface
