// SPDX-License-Identifier: BSD-3-Clause
#include "said_facts.h"

#include <algorithm>
#include <utility>

namespace goal_alignment::aligner {
namespace {

using Facts = SaidFacts::Facts;

std::uint64_t lastOf(const Facts& facts) {
  std::uint64_t last = 0;
  for (const auto& fact : facts)
    last = std::max(last, fact.second.order);
  return last;
}

// Those that are there already are later ones.
void addEarlier(Facts& facts, const Facts& earlier, std::uint64_t later_by) {
  for (auto& fact : facts)
    fact.second.order += later_by;
  facts.insert(earlier.begin(), earlier.end());
}

}  // namespace

SaidFacts::SaidFacts(Facts robot, Facts human)
    : robot_(std::move(robot)),
      human_(std::move(human)),
      last_(std::max(lastOf(robot_), lastOf(human_))) {}

bool SaidFacts::setRobot(const GroundName& atom, bool holds, bool left_to_tf) {
  const auto [known, is_new] = robot_.try_emplace(atom);
  Said& said = known->second;
  const bool same_owner = std::exchange(said.left_to_tf, left_to_tf) == left_to_tf;
  if (!is_new && said.holds == holds) return !same_owner;
  said.holds = holds;
  said.order = ++last_;
  return true;
}

// It may overrule what the robot has reported since.
bool SaidFacts::setHuman(const GroundName& atom, bool holds) {
  const auto reported = robot_.find(atom);
  const std::uint64_t reported_at = reported == robot_.end() ? 0 : reported->second.order;
  Said& said = human_[atom];
  if (said.holds == holds && said.order > reported_at) return false;
  said = {holds, ++last_};
  return true;
}

void SaidFacts::putBefore(const SaidFacts& earlier) {
  addEarlier(robot_, earlier.robot_, earlier.last_);
  addEarlier(human_, earlier.human_, earlier.last_);
  last_ += earlier.last_;
}

std::map<GroundName, bool> SaidFacts::ofRobot() const {
  std::map<GroundName, bool> facts;
  for (const auto& [atom, said] : robot_) {
    if (!said.left_to_tf) facts.emplace(atom, said.holds);
  }
  return facts;
}

std::vector<session::HumanFact> SaidFacts::ofHuman(bool follows) const {
  std::vector<session::HumanFact> facts;
  for (const auto& [atom, said] : human_) {
    const auto reported = robot_.find(atom);
    const bool overruled =
        follows && reported != robot_.end() && reported->second.order > said.order;
    if (!overruled) facts.push_back({{atom, !said.holds}, false});
  }
  if (!follows) return facts;
  for (const auto& [atom, said] : robot_) {
    const auto told = human_.find(atom);
    const bool overruled = told != human_.end() && told->second.order > said.order;
    if (!overruled) facts.push_back({{atom, !said.holds}, true});
  }
  return facts;
}

}  // namespace goal_alignment::aligner
