// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/String.h>

#include <memory>
#include <string>

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

/// Calls the XML-RPC interface that every node has; an invalid value where nobody is there.
XmlRpc::XmlRpcValue callNode(const std::string& node, const std::string& method,
                             const std::string& argument = "");

/// Whether messages of the node on the topic reach the listener. A subscriber itself can't tell: it
/// counts a publisher that died until the master says so.
bool reaches(const std::string& listener, const std::string& node, const std::string& topic);
bool reachesUs(const std::string& node, const std::string& topic);

}  // namespace goal_alignment::test
