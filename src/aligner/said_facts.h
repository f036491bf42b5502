// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::aligner {

/// What was said to be so since the problem files were written: of the robot's world by ~set_facts,
/// of what the person believes by ~set_human_facts. Who carries plans out reports what has changed,
/// and the person follows that; of one atom the later word counts for them. What is said again,
/// unchanged, is no news, so that a report that is repeated after a restart overrules nobody.
class SaidFacts {
 public:
  struct Said {
    bool holds = false;
    std::uint64_t order = 0;  ///< a larger one was said later
    bool left_to_tf = false;  ///< the robot knows it from tf instead; the person follows it
  };
  using Facts = std::map<GroundName, Said>;

  SaidFacts() = default;
  /// As they were kept.
  SaidFacts(Facts robot, Facts human);

  /// They return whether that is news.
  bool setRobot(const GroundName& atom, bool holds, bool left_to_tf);
  bool setHuman(const GroundName& atom, bool holds);
  /// These were said before all that is known here.
  void putBefore(const SaidFacts& earlier);

  /// What holds for the robot, or not.
  std::map<GroundName, bool> ofRobot() const;
  /// What holds for the person, or not; `follows`: also what the robot reported.
  std::vector<session::HumanFact> ofHuman(bool follows) const;

  const Facts& robot() const { return robot_; }
  const Facts& human() const { return human_; }
  std::size_t size() const { return robot_.size() + human_.size(); }

 private:
  Facts robot_;
  Facts human_;
  std::uint64_t last_ = 0;
};

}  // namespace goal_alignment::aligner
