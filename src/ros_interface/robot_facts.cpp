// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/robot_facts.h"

#include <fmt/format.h>

#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

#include "goal_alignment/ros_interface/message_conversion.h"

namespace goal_alignment::ros_interface {

using session::Receipt;

namespace {

Fluent toMessage(const GroundName& atom) {
  Fluent message;
  message.name = atom.name;
  message.args = atom.arguments;
  return message;
}

}  // namespace

Receipt RobotFacts::set(const std::vector<Fluent>& facts, const whereabouts::Rules* rules) {
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
    if (world_.model && !world_.model->resolve(literal.atom, &why_not)) {
      return {false, fmt::format("facts[{}]: the robot's model can't have {}: {}", i,
                                 literal.atom.text(), why_not)};
    }
    const auto [known, is_new] = changes.emplace(literal.atom, !literal.negated);
    if (!is_new && known->second == literal.negated) {
      return {false, fmt::format("facts[{}]: {} is both true and false", i, literal.atom.text())};
    }
  }
  std::string left_to_tf;
  for (auto change = changes.begin(); change != changes.end();) {
    const whereabouts::Rule* const owner = rules ? rules->ownerOf(change->first) : nullptr;
    const bool is_left = owner != nullptr && owner->unknown == whereabouts::Unknown::Fail;
    if (is_left) {
      left_to_tf += fmt::format("{}{} comes from tf ({})", left_to_tf.empty() ? "" : ", ",
                                change->first.text(), owner->place);
    }
    change = is_left ? changes.erase(change) : std::next(change);
  }
  if (changes.empty()) return {false, left_to_tf + ": it can't be set"};
  for (const auto& [atom, holds] : changes)
    all_[atom] = world_.set[atom] = holds;
  ++version_;
  if (!left_to_tf.empty()) return {true, "taken, but " + left_to_tf};
  return {true,
          world_.model ? "" : "taken; no robot's model is known yet that could have it or not"};
}

void RobotFacts::beginSession(const std::string& session_id, bool earlier_hold) {
  const std::lock_guard<std::mutex> lock(mutex_);
  world_ = {session_id, earlier_hold ? all_ : Changes{}, nullptr};
  ++version_;
}

void RobotFacts::setModel(const pddl::Model& model) {
  auto copy = std::make_shared<const pddl::Model>(model);
  const std::lock_guard<std::mutex> lock(mutex_);
  world_.model = std::move(copy);
}

// What is made of it may be large, so that nobody should wait meanwhile.
RobotFacts::World RobotFacts::world() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return world_;
}

std::vector<GroundName> RobotFacts::state(const whereabouts::Observation& seen,
                                          std::vector<GroundName>& left_out) const {
  return stateOf(world(), seen, left_out);
}

std::vector<GroundName> RobotFacts::stateOf(const World& world,
                                            const whereabouts::Observation& seen,
                                            std::vector<GroundName>& left_out) {
  std::set<GroundName> atoms;
  for (const pddl::Atom& atom : world.model->init)
    atoms.insert(world.model->name(atom));
  for (const auto& [atom, holds] : world.set) {
    if (!world.model->resolve(atom)) {
      left_out.push_back(atom);
    } else if (holds) {
      atoms.insert(atom);
    } else {
      atoms.erase(atom);
    }
  }
  seen.overlay(atoms);
  return {atoms.begin(), atoms.end()};
}

GetFacts::Response RobotFacts::tell(const whereabouts::Observation& seen) const {
  const World now = world();
  GetFacts::Response response;
  response.session_id = now.session_id;
  if (now.session_id.empty()) {
    response.message = "no task was given yet";
  } else if (!now.model) {
    response.message = "the robot's model of this task is not read yet, or can't be read";
  } else {
    response.known = 1;
    std::vector<GroundName> left_out;
    for (const GroundName& atom : stateOf(now, seen, left_out))
      response.facts.push_back(toMessage(atom));
    for (const GroundName& atom : seen.unknown())
      response.unknown.push_back(toMessage(atom));
    response.message = seen.lament();
  }
  return response;
}

}  // namespace goal_alignment::ros_interface
