// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "child_process.h"
#include "generators/single_call.h"
#include "goal_alignment/session/session.h"
#include "record.h"

namespace goal_alignment::benchmarks {

/// What one piece of work may use; the process around it gets a little more, so that it can say
/// itself that it ran out.
struct MeasureLimits {
  double seconds = 60;
  std::size_t mebibytes = 2048;

  HardLimits hard() const { return {seconds + 5, mebibytes + mebibytes / 4 + 256}; }
  Limits soft() const;
};

/// One planning call into `record`: status (`solved`, `unsolvable`, `limit: …`), cost, steps,
/// objects, facts, operators, expanded, evaluated, evaluations_per_s, the times of parse, ground,
/// mutexes, search and total, checks, checks_unknown.
void measureCall(const pddl::Source& domain, const pddl::Source& problem, CallKind kind,
                 const MeasureLimits& limits, Record& record);

/// How the alignments go about it; conflicts as the node's default has it.
struct DialogueOptions {
  std::string policy = "auto";
  session::ConflictMode conflicts = session::ConflictMode::Lazy;
  int threads = 1;
};

struct AlignmentWork {
  session::Input input;
  std::vector<Literal> true_goal;
  DialogueOptions dialogue;
};

/// One alignment into `record`: status (the outcome's word), objects, operators (the robot's),
/// candidates, candidates_static, questions, conflicts, the times of the session's phases,
/// first_question (until it stands, or the outcome where none is asked), longest_step (from an
/// answer to the next question or the outcome), checks (planner calls), checks_unknown (conflicts
/// that are still only suspected at the end). Saves at every question.
void measureAlignment(const AlignmentWork& work, const MeasureLimits& limits, Record& record,
                      const Save& save);

}  // namespace goal_alignment::benchmarks
