// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "aligner/session_record.h"
#include "unit/alignment/samples.h"

/// A session record over the task of unit/alignment/samples.h, for the parts of the aligner's loop.
namespace goal_alignment::aligner::samples {

inline SessionRecord deskRecord() {
  using namespace goal_alignment::samples;
  session::Input input;
  input.robot_domain = {"robot_domain.pddl", kDeskRobotDomain};
  input.robot_problem = {"robot_problem.pddl", kDeskProblem};
  input.human_domain = {"human_domain.pddl", kDeskHumanDomain};
  input.human_problem = {"human_problem.pddl", kDeskProblem};
  input.human_plan = deskPlan();
  SessionRecord record;
  record.labels = {"s1", "Ann", "desk", "identity"};
  record.human_plan = deskPlan();
  record.session = std::make_shared<session::Session>(session::Options{});
  record.session->begin(std::move(input));
  return record;
}

/// Until there is a question or an outcome.
inline void think(SessionRecord& record) {
  while (record.session->step() == session::State::Analysing) {
  }
  record.models_loaded = record.session->robotModel() != nullptr;
}

}  // namespace goal_alignment::aligner::samples
