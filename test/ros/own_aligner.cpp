// SPDX-License-Identifier: BSD-3-Clause
#include "own_aligner.h"

#include <ros/network.h>
#include <xmlrpcpp/XmlRpc.h>

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
  for (const char* topic : {"question", "state", "plan", "events", "align/result", "align/status"})
    ASSERT_TRUE(eventually([&] {
      return reachesUs(kAligner, std::string(kAligner) + "/" + topic);
    })) << topic
        << alignersOutput();
  ASSERT_TRUE(eventually([this] { return align_.isServerConnected(); }));
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

XmlRpc::XmlRpcValue callNode(const std::string& node, const std::string& method,
                             const std::string& argument) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue uri;
  request[0] = ros::this_node::getName();
  request[1] = node;
  if (!ros::master::execute("lookupNode", request, response, uri, false)) return {};
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(static_cast<std::string&>(uri), host, port)) return {};
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue arguments;
  arguments[0] = ros::this_node::getName();
  if (!argument.empty()) arguments[1] = argument;
  if (!client.execute(method.c_str(), arguments, response)) return {};
  return response;
}

bool reaches(const std::string& listener, const std::string& node, const std::string& topic) {
  XmlRpc::XmlRpcValue answer = callNode(node, "getBusInfo");
  if (!answer.valid() || answer.size() < 3) return false;
  XmlRpc::XmlRpcValue& connections = answer[2];
  for (int i = 0; i < connections.size(); ++i) {
    XmlRpc::XmlRpcValue& connection = connections[i];
    if (static_cast<std::string&>(connection[1]) == listener &&
        static_cast<std::string&>(connection[2]) == "o" &&
        static_cast<std::string&>(connection[4]) == topic) {
      return true;
    }
  }
  return false;
}

bool reachesUs(const std::string& node, const std::string& topic) {
  return reaches(ros::this_node::getName(), node, topic);
}

}  // namespace goal_alignment::test
