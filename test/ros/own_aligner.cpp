// SPDX-License-Identifier: BSD-3-Clause
#include "own_aligner.h"

#include <csignal>

namespace goal_alignment::test {
namespace {

constexpr const char* kAligner = "/goal_alignment";

}  // namespace

OwnAligner::OwnAligner() : events_(node_, "/goal_alignment/events") {}

void OwnAligner::SetUp() {
  ASSERT_NO_FATAL_FAILURE(startAligner());
  Scenario::SetUp();
}

void OwnAligner::TearDown() {
  if (HasFailure()) std::cout << alignersOutput();
  if (aligner_) killAligner();
}

void OwnAligner::startAligner() {
  aligner_ = std::make_unique<Program>(
      NODE_FOLDER "/goal_alignment_node", std::vector<std::string>{},
      std::map<std::string, std::string>{{"ROS_HOME", home_.path()}}, home_.path() + "/output");
  for (const char* topic : {"question", "state", "plan", "events"})
    ASSERT_TRUE(eventually([&] {
      return reachesUs(kAligner, std::string(kAligner) + "/" + topic);
    })) << topic
        << alignersOutput();
  ASSERT_TRUE(isLinked(align_, kAligner, "/goal_alignment/align"));
  ASSERT_TRUE(isOffered("/goal_alignment/answer"));
  ASSERT_TRUE(isOffered("/goal_alignment/forget"));
}

void OwnAligner::killAligner() {
  aligner_->signal(SIGKILL);
  awaitAlignersEnd();
}

int OwnAligner::awaitAlignersEnd() {
  const int status = aligner_->exitStatus();
  EXPECT_NE(status, -1) << "the aligner does not end";
  aligner_.reset();
  EXPECT_TRUE(eventually([this] { return !align_.isServerConnected(); }));
  return status;
}

void OwnAligner::shutDownByName(const std::string& node) {
  EXPECT_TRUE(callNode(node, "shutdown", "killed by the scenario").valid());
}

std::string OwnAligner::alignersOutput() const {
  return textOf(home_.path() + "/output");
}

}  // namespace goal_alignment::test
