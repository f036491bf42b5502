// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>

#include "scenario.h"

/// What only the nodes themselves can tell: who is linked with whom.
namespace goal_alignment::test {

/// Calls the XML-RPC interface that every node has; an invalid value where nobody is there.
XmlRpc::XmlRpcValue callNode(const std::string& node, const std::string& method,
                             const std::string& argument = "");

/// Whether messages of the node on the topic reach the listener. A subscriber itself can't tell: it
/// counts a publisher that died until the master says so, and one that does not know it yet.
bool reaches(const std::string& listener, const std::string& node, const std::string& topic);
bool reachesUs(const std::string& node, const std::string& topic);

/// Waits until the node's action server hears the client, and the client all that it says.
template <typename Client>
bool isLinked(const Client& client, const std::string& node, const std::string& action) {
  return eventually([&] {
    return client.isServerConnected() && reachesUs(node, action + "/result") &&
           reachesUs(node, action + "/feedback") && reachesUs(node, action + "/status");
  });
}

}  // namespace goal_alignment::test
