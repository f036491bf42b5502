// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/graph_view.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpc.h>

#include <chrono>
#include <future>
#include <memory>
#include <thread>
#include <vector>

#include "goal_alignment/common/quote.h"
#include "goal_alignment/pddl/near_name.h"

namespace goal_alignment::execution {
namespace {

using XmlRpc::XmlRpcValue;

constexpr std::chrono::seconds kPingPatience{3};
constexpr std::size_t kMaxNamed = 3;
constexpr const char* kResult = "/result";
constexpr const char* kResultType = "ActionResult";

/// What the master answers; invalid: nothing.
XmlRpcValue askMaster(const std::string& method, const std::string& argument = "") {
  XmlRpcValue request;
  XmlRpcValue response;
  XmlRpcValue answer;
  request[0] = ros::this_node::getName();
  if (!argument.empty()) request[1] = argument;
  if (!ros::master::execute(method, request, response, answer, false)) return {};
  return answer;
}

std::string textOf(XmlRpcValue& value) {
  return value.getType() == XmlRpcValue::TypeString ? static_cast<std::string&>(value) : "";
}

bool isList(XmlRpcValue& value, int length) {
  return value.getType() == XmlRpcValue::TypeArray && value.size() >= length;
}

/// The text without that end; "": it does not end so.
std::string without(const std::string& text, const std::string& end) {
  const bool fits =
      text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
  return fits ? text.substr(0, text.size() - end.size()) : "";
}

// The call has no time-out, so that it is made on a thread that can be left.
bool isAlive(const std::string& node) {
  XmlRpcValue uri = askMaster("lookupNode", node);
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(textOf(uri), host, port)) return false;
  const auto answer = std::make_shared<std::promise<bool>>();
  std::future<bool> is_alive = answer->get_future();
  std::thread([answer, host, port, caller = ros::this_node::getName()] {
    XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
    XmlRpcValue request;
    XmlRpcValue response;
    request[0] = caller;
    answer->set_value(client.execute("getPid", request, response));
  }).detach();
  return is_alive.wait_for(kPingPatience) == std::future_status::ready && is_alive.get();
}

}  // namespace

std::optional<GraphView> GraphView::now() {
  XmlRpcValue state = askMaster("getSystemState");
  XmlRpcValue types = askMaster("getTopicTypes");
  if (!isList(state, 3) || types.getType() != XmlRpcValue::TypeArray) return std::nullopt;
  std::map<std::string, std::string> type_of;
  for (int i = 0; i < types.size(); ++i) {
    if (isList(types[i], 2)) type_of[textOf(types[i][0])] = textOf(types[i][1]);
  }
  GraphView view;
  XmlRpcValue& published = state[0];
  for (int i = 0; i < published.size(); ++i) {
    const std::string topic = textOf(published[i][0]);
    const std::string name = without(topic, kResult);
    const std::string type = without(type_of[topic], kResultType);
    if (!name.empty() && !type.empty()) view.actions[name] = type;
  }
  XmlRpcValue& services = state[2];
  for (int i = 0; i < services.size(); ++i)
    view.services.insert(textOf(services[i][0]));
  return view;
}

std::string GraphView::nearAction(const std::string& name, const std::string& type) const {
  const auto found = actions.find(name);
  if (found != actions.end() && found->second == type)
    return "; it is registered, but can't be reached";
  if (found != actions.end())
    return fmt::format("; what is there by that name is a {}", found->second);
  std::vector<std::string> same_type;
  std::vector<std::string> names;
  for (const auto& [each, its_type] : actions) {
    names.push_back(each);
    if (its_type == type) same_type.push_back(each);
  }
  std::string near = pddl::suggestion(name, same_type);
  if (near.empty()) near = pddl::suggestion(name, names);
  if (!near.empty() || same_type.empty()) return near;
  same_type.resize(std::min(same_type.size(), kMaxNamed));
  return fmt::format("; of that type there is {}", fmt::join(same_type, ", "));
}

std::string GraphView::nearService(const std::string& name) const {
  if (services.count(name) > 0) return "; it is registered, but can't be reached";
  return pddl::suggestion(name, {services.begin(), services.end()});
}

std::string GraphView::lackOf(const StepRule& rule, const std::string& name) const {
  if (rule.action) {
    const auto found = actions.find(name);
    if (found != actions.end() && found->second == rule.action->type) return "";
    return fmt::format("nobody offers the action {} of type {}{}", name, rule.action->type,
                       nearAction(name, rule.action->type));
  }
  if (!rule.service || services.count(name) > 0) return "";
  return fmt::format("nobody offers the service {}{}", name, nearService(name));
}

std::optional<std::string> otherPublisher(const std::string& topic) {
  XmlRpcValue state = askMaster("getSystemState");
  if (!isList(state, 3)) return std::nullopt;
  XmlRpcValue& published = state[0];
  for (int i = 0; i < published.size(); ++i) {
    if (textOf(published[i][0]) != topic) continue;
    XmlRpcValue& nodes = published[i][1];
    for (int j = 0; j < nodes.size(); ++j) {
      const std::string node = textOf(nodes[j]);
      if (node != ros::this_node::getName() && isAlive(node)) return node;
    }
  }
  return std::nullopt;
}

}  // namespace goal_alignment::execution
