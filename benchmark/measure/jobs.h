// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "measurement.h"

namespace goal_alignment::benchmarks {

/// One thing to measure. The work is done in a process of its own, making or reading the task
/// included.
struct Job {
  std::string suite;  ///< a family, a folder, or what a series lets grow
  std::string task;
  std::string kind;  ///< `first`, `optimal`, `align`
  std::function<void(const MeasureLimits& limits, Record& record, const Save& save)> work;
};

/// Every family at every size, `first`; those with a plan `optimal` too.
std::vector<Job> familyCalls(std::uint64_t seed);

/// Alignments of the families with a plan, whose models differ in actions only and in everything,
/// under three truths.
std::vector<Job> familyAlignments(std::uint64_t seed, const DialogueOptions& dialogue);

/// Households in which one of the numbers of objects, operators and candidates grows (the suite's
/// name), as far as possible alone, and the large home.
std::vector<Job> householdGrowth(std::uint64_t seed, const DialogueOptions& dialogue);

/// What stands at the path and below: alignments in instance folders (cli/instance.h), else
/// planning tasks: each problem with `<problem>-domain.pddl`, `domain-<problem>.pddl` (with or
/// without
/// `-problem` in its own name), or the folder's `domain.pddl`. Sorted by path. Throws
/// pddl::InputError where there is nothing.
std::vector<Job> jobsBelow(const std::string& path, const DialogueOptions& dialogue);

/// The job in a process of its own.
Record run(const Job& job, const MeasureLimits& limits);

}  // namespace goal_alignment::benchmarks
