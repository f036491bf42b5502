// SPDX-License-Identifier: BSD-3-Clause
#include "robot_facts.h"

#include <fmt/format.h>

#include <set>
#include <stdexcept>
#include <utility>

#include "goal_alignment/ros_common/message_conversion.h"

namespace goal_alignment::aligner {

using session::SubmitResult;

namespace {

Fluent fluentOf(const GroundName& atom) {
  Fluent message;
  message.name = atom.name;
  message.args = atom.arguments;
  return message;
}

}  // namespace

std::string RobotFacts::follow(const FactScope& scope, double expiry) {
  if (file_ == nullptr) return "";
  const std::lock_guard<std::mutex> keeping(keeping_);
  const bool changed = scope.models != scope_.models;
  scope_ = scope;
  if (std::exchange(followed_, true)) {
    file_->setScope(scope);
    if (changed) keep();
    return "";
  }
  const auto kept = file_->open(scope, expiry);
  bool already_said = false;  // while the models could not be read
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    already_said = said_.size() > 0;
    if (kept) said_.putBefore(kept->facts);
  }
  if (already_said) keep();
  return kept ? kept->line : "";
}

void RobotFacts::keep() const {
  if (file_ == nullptr) return;
  std::unique_lock<std::mutex> lock(mutex_);
  const SaidFacts now = said_;
  lock.unlock();
  file_->write(now);
}

SubmitResult RobotFacts::set(const std::vector<Fluent>& facts, const spatial_facts::Rules* rules) {
  const std::lock_guard<std::mutex> keeping(keeping_);
  Changes changes;
  std::string left_to_tf;
  std::size_t left = 0;
  bool news = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::string why_not = read(facts, world_.model.get(), "the robot's", changes);
    if (!why_not.empty()) return {false, why_not};
    for (const auto& [atom, holds] : changes) {
      const spatial_facts::Rule* const owner = rules ? rules->ownerOf(atom) : nullptr;
      const bool is_left = owner != nullptr && owner->unknown == spatial_facts::Unknown::Fail;
      news = said_.setRobot(atom, holds, is_left) || news;
      if (!is_left) {
        world_.set[atom] = holds;
        continue;
      }
      left_to_tf += fmt::format("{}{} comes from tf ({})", left++ == 0 ? "" : ", ", atom.text(),
                                owner->place);
    }
    if (left < changes.size()) ++version_;
  }
  if (news) keep();
  if (left == changes.size()) return {false, left_to_tf + ": it can't be set"};
  if (left > 0) return {true, "taken, but " + left_to_tf};
  return {true, world().model ? "" : "taken; it can't be checked yet, as no robot model is loaded"};
}

SubmitResult RobotFacts::setHuman(const std::vector<Fluent>& facts, const pddl::Model* human) {
  Changes changes;
  const std::string why_not = read(facts, human, "the person's", changes);
  if (!why_not.empty()) return {false, why_not};
  const std::lock_guard<std::mutex> keeping(keeping_);
  bool news = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& [atom, holds] : changes)
      news = said_.setHuman(atom, holds) || news;
  }
  if (news) keep();
  return {true, ""};
}

// Why they can't be taken; empty: nothing speaks against it.
std::string RobotFacts::read(const std::vector<Fluent>& facts, const pddl::Model* model,
                             const std::string& whose, Changes& changes) {
  std::vector<Literal> literals;
  try {
    literals = ros_common::toLiterals(facts, "facts");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  if (literals.empty()) return "no fact is given";
  for (std::size_t i = 0; i < literals.size(); ++i) {
    const Literal& literal = literals[i];
    std::string why_not;
    if (model != nullptr && !model->resolve(literal.atom, &why_not)) {
      return fmt::format("facts[{}]: {} model can't have {}: {}", i, whose, literal.atom.text(),
                         why_not);
    }
    const auto [known, is_new] = changes.emplace(literal.atom, !literal.negated);
    if (!is_new && known->second == literal.negated)
      return fmt::format("facts[{}]: {} is both true and false", i, literal.atom.text());
  }
  return {};
}

std::vector<session::HumanFact> RobotFacts::believed(bool follows) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return said_.ofHuman(follows);
}

std::size_t RobotFacts::forget() {
  const std::lock_guard<std::mutex> keeping(keeping_);
  std::size_t count = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    count = said_.size();
    said_ = {};
    world_.set.clear();
    ++version_;
  }
  keep();
  return count;
}

void RobotFacts::beginSession(const std::string& session_id, bool earlier_hold) {
  const std::lock_guard<std::mutex> lock(mutex_);
  world_ = {session_id, earlier_hold ? said_.ofRobot() : Changes{}, nullptr};
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

std::vector<GroundName> RobotFacts::state(const spatial_facts::Observation& seen,
                                          std::vector<GroundName>& left_out) const {
  return stateOf(world(), seen, left_out);
}

std::vector<GroundName> RobotFacts::stateOf(const World& world,
                                            const spatial_facts::Observation& seen,
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

GetFacts::Response RobotFacts::tell(const spatial_facts::Observation& seen) const {
  const World now = world();
  GetFacts::Response response;
  response.session_id = now.session_id;
  if (now.session_id.empty()) {
    response.message = "no task was given yet";
  } else if (!now.model) {
    response.message = "the robot's model of this task is not loaded yet, or can't be read";
  } else {
    response = told(now, seen);
  }
  return response;
}

GetFacts::Response RobotFacts::tellBefore(const std::shared_ptr<const pddl::Model>& model,
                                          const std::string& why_not,
                                          const spatial_facts::Observation& seen) const {
  GetFacts::Response response;
  if (model) {
    std::unique_lock<std::mutex> lock(mutex_);
    const World next = {"", said_.ofRobot(), model};
    lock.unlock();
    response = told(next, seen);
  } else {
    response.message =
        "no task was given yet, and the models of the next one can't be read: " + why_not;
  }
  return response;
}

GetFacts::Response RobotFacts::told(const World& world, const spatial_facts::Observation& seen) {
  GetFacts::Response response;
  response.known = 1;
  response.session_id = world.session_id;
  std::vector<GroundName> left_out;
  for (const GroundName& atom : stateOf(world, seen, left_out))
    response.facts.push_back(fluentOf(atom));
  for (const GroundName& atom : seen.unknown())
    response.unknown.push_back(fluentOf(atom));
  response.message = seen.unknownFactsMessage();
  return response;
}

}  // namespace goal_alignment::aligner
