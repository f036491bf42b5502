// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::aligner {

/// The models that the parameters name, for who asks while no task is under way that has read them.
/// Read anew where a file has changed. Thread-safe.
class ParameterModels {
 public:
  using Model = std::shared_ptr<const pddl::Model>;

  explicit ParameterModels(ros::NodeHandle private_node) : private_node_(std::move(private_node)) {}

  /// Null where they can't be read, or not within seconds; `why_not` then says so.
  Model robot(std::string& why_not);
  Model human(std::string& why_not);

 private:
  struct Read {
    std::string domain;  // texts
    std::string problem;
    Model model;
    std::string why_not;
  };

  using File = pddl::Source session::Input::*;

  Model read(Read& last, File domain, File problem, std::string& why_not);
  Model of(Read& last, const pddl::Source& domain, const pddl::Source& problem,
           std::string& why_not);

  const ros::NodeHandle private_node_;
  std::mutex mutex_;  // guards the two below
  Read robot_;
  Read human_;
};

}  // namespace goal_alignment::aligner
