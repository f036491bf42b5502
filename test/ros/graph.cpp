// SPDX-License-Identifier: BSD-3-Clause
#include "graph.h"

#include <ros/network.h>
#include <xmlrpcpp/XmlRpc.h>

namespace goal_alignment::test {

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
