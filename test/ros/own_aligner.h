// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/String.h>

#include <memory>
#include <string>

#include "graph.h"
#include "program.h"
#include "scenario.h"

namespace goal_alignment::test {

/// A graph without an aligner: every scenario starts one, with a $ROS_HOME of its own, and may kill
/// it and start another.
class OwnAligner : public Scenario {
 protected:
  OwnAligner();
  void SetUp() override;
  void TearDown() override;

  /// Returns when it hears us and we hear it.
  void startAligner();
  /// With kill -9, and returns when we see that it is gone.
  void killAligner();
  /// After the aligner was told to end: its exit status, -1 where it does not.
  int awaitAlignersEnd();
  /// What `rosnode kill` does.
  static void shutDownByName(const std::string& node);

  std::string alignersOutput() const;
  std::string journalFolder() const { return home_.path() + "/goal_alignment/journal"; }

  TemporaryFolder home_;
  Topic<std_msgs::String> events_;
  std::unique_ptr<Program> aligner_;
};

}  // namespace goal_alignment::test
