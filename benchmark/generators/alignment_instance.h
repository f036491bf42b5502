// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "families.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/session/session.h"
#include "misreading.h"

namespace goal_alignment::benchmarks {

/// A whole alignment: what a session is given, and what the person really wants.
struct AlignmentInstance {
  Models robot;
  Models human;
  std::vector<GroundName> human_plan;
  std::vector<Literal> true_goal;

  session::Input input() const;
};

/// What the person wants besides the goal.
struct Truth {
  /// Negative: the one atom that their goal leaves out (the paper's protocol). Else each fluent
  /// that they expect is wanted with this probability.
  double wanted = -1;
};

/// The instance that a robot's models and a person's reading of them give. The person's goal is the
/// models' but for one atom at random; their plan is one that our own planner finds, in their
/// model, for all of it. Where it finds none within a fixed number of states (a displaced thing can
/// make the goal impossible), the person is drawn anew. Throws Exception after many draws.
AlignmentInstance alignmentOf(const Models& robot, const Misreading& misreading, const Truth& truth,
                              RandomSource& random);

/// The household with a person who doesn't know what it takes: that a stand bears one dish only,
/// that some places are too high and some dishes too heavy, where each dish is. They know of the
/// first `known` dishes only, so that the number of candidates and the number of operators grow
/// apart. Their goal names half of the dishes to be laid out.
AlignmentInstance householdAlignment(const HouseholdSize& size, int known, const Truth& truth,
                                     RandomSource& random);

/// A home of home.h. The person's goal names half of what the robot can do; with the person's plan
/// they expect all of it, also what lies upstairs or high up. size: things that lie about.
AlignmentInstance homeAlignment(int size, const Truth& truth, RandomSource& random);

/// A home as it may be: 10 rooms, 200 things in it, at least 20,000 operators, at least 100
/// candidates.
AlignmentInstance largeHome(std::uint64_t seed);

/// Makes the folder and writes the files that doc/command-line.md names. Throws
/// std::filesystem_error or pddl::InputError.
void write(const AlignmentInstance& instance, const std::string& folder);

/// The same with domain.pddl and problem.pddl.
void write(const Models& models, const std::string& folder);

}  // namespace goal_alignment::benchmarks
