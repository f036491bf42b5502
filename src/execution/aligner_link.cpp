// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/aligner_link.h"

#include <fmt/format.h>
#include <ros/console.h>
#include <ros/master.h>
#include <ros/param.h>
#include <ros/this_node.h>

#include <algorithm>
#include <utility>

#include "goal_alignment/AlignAction.h"
#include "goal_alignment/GetFacts.h"
#include "goal_alignment/SetFacts.h"
#include "goal_alignment/ros_common/message_conversion.h"
#include "goal_alignment/ros_common/names.h"
#include "goal_alignment/ros_common/stamp.h"

namespace goal_alignment::execution {
namespace {

using Kind = any_message::ServiceCaller::Reply::Kind;

constexpr double kServiceSeconds = 10;   // for an answer; it is a look-up
constexpr double kLastWordSeconds = 1;   // for one that a cancel must not keep from being told
constexpr int kServiceTries = 3;         // a call may break off when a connection does
constexpr double kAlignerPatience = 10;  // seconds until the aligner's action is there, or is lost

std::string ownGoals() {
  return ros::this_node::getName() + "-plans-anew-";
}

std::vector<GroundName> atomsOf(const std::vector<Fluent>& fluents) {
  std::vector<GroundName> atoms;
  for (const Fluent& fluent : fluents)
    atoms.push_back(ros_common::toLiteral(fluent).atom);
  std::sort(atoms.begin(), atoms.end());
  return atoms;
}

}  // namespace

AlignerLink::AlignerLink(ros::NodeHandle node, const std::string& aligner,
                         any_message::ServiceCaller& services, any_message::WaitPoint& wait)
    : node_(std::move(node)),
      aligner_(node_.resolveName(aligner) + "/"),
      services_(services),
      wait_(wait),
      align_(node_, aligner_ + ros_common::kAlignAction,
             {ros::message_traits::datatype<AlignActionGoal>(),
              ros::message_traits::md5sum<AlignActionGoal>(),
              ros::message_traits::definition<AlignActionGoal>()},
             wait) {}

std::string AlignerLink::parameter(const std::string& key) const {
  std::string value;
  return ros::param::get(aligner_ + key, value) ? value : "";
}

template <typename Service>
std::optional<typename Service::Response> AlignerLink::ask(const std::string& name,
                                                           const typename Service::Request& request,
                                                           Kind& kind) {
  for (int i = 0; i < kServiceTries; ++i) {
    const auto end = any_message::deadlineIn(hangs_ ? kLastWordSeconds : kServiceSeconds);
    auto response = services_.call<Service>(name, request, 0, end, &kind);
    if (kind != Kind::Interrupted) hangs_ = kind == Kind::TimedOut || kind == Kind::TooMany;
    if (response || kind != Kind::Failed) return response;
  }
  return std::nullopt;
}

std::string AlignerLink::life() const {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue address;  // its port is another one after each start
  request[0] = ros::this_node::getName();
  request[1] = aligner_ + ros_common::kSetFactsService;
  const bool is_there = ros::master::execute("lookupService", request, response, address, false);
  return is_there && address.getType() == XmlRpc::XmlRpcValue::TypeString
             ? static_cast<std::string&>(address)
             : "";
}

AlignerLink::Facts AlignerLink::facts() {
  Facts facts;
  Kind kind = Kind::Failed;
  const auto response = ask<GetFacts>(aligner_ + ros_common::kGetFactsService, {}, kind);
  if (!response) {
    facts.message = fmt::format("{}{} does not answer", aligner_, ros_common::kGetFactsService);
    return facts;
  }
  facts.known = response->known != 0;
  facts.message = response->message;
  facts.session_id = response->session_id;
  facts.world = {atomsOf(response->facts), atomsOf(response->unknown)};
  return facts;
}

bool AlignerLink::set(const std::vector<Literal>& changes, std::string& refusal) {
  SetFacts::Request request;
  for (const Literal& change : changes) {
    Fluent fluent;
    fluent.name = change.atom.name;
    fluent.args = change.atom.arguments;
    fluent.negated = change.negated;
    request.facts.push_back(fluent);
  }
  Kind kind = Kind::Failed;
  const std::string service = aligner_ + ros_common::kSetFactsService;
  auto response = ask<SetFacts>(service, request, kind);
  // A cancel ends the plan, but what the steps have changed stays so.
  if (kind == Kind::Interrupted) {
    response =
        services_.call<SetFacts>(service, request, 0, any_message::deadlineIn(kLastWordSeconds),
                                 &kind, any_message::ServiceCaller::On::End);
  }
  if (response && !response->accepted) refusal = response->message;
  return response.has_value();
}

bool AlignerLink::tell(const std::vector<Literal>& changes) {
  if (changes.empty()) return true;
  std::string refusal;
  if (!set(changes, refusal)) return false;
  if (refusal.empty()) return true;
  // All or none are taken, so that the others now go one by one.
  for (const Literal& change : changes) {
    refusal.clear();
    if (!set({change}, refusal)) return false;
    if (!refusal.empty()) ROS_DEBUG("%s: %s", change.text().c_str(), refusal.c_str());
  }
  return true;
}

bool AlignerLink::isOwnGoal(const std::string& goal_id) {
  return goal_id.rfind(ownGoals(), 0) == 0;
}

std::optional<AlignResult> AlignerLink::replan(const std::string& session_id, double cancel_timeout,
                                               std::string& why_not) {
  using EndKind = any_message::ActionClient::End::Kind;
  AlignGoal goal;
  goal.continue_session = session_id;
  goal.max_questions = -1;
  goal.unsure_policy = AlignGoal::KEEP;
  any_message::Bytes bytes(ros::serialization::serializationLength(goal));
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(out, goal);
  // The clock may stand still, and an earlier run of this node may have sent goals, too.
  const std::string id =
      fmt::format("{}{}-{}", ownGoals(), ros_common::stampNow().toNSec(), ++goals_sent_);
  const auto end = align_.run(bytes, ros_common::stampNow(),
                              {kAlignerPatience, cancel_timeout, any_message::TimeLimit()}, id);
  if (end.kind == EndKind::NoServer) {
    why_not = "there is no aligner to plan anew";
  } else if (end.kind != EndKind::Ended || !end.result) {
    why_not = "the aligner gave no answer";
  } else {
    AlignResult result;
    ros::serialization::IStream in(const_cast<std::uint8_t*>(end.result->data()),
                                   static_cast<std::uint32_t>(end.result->size()));
    ros::serialization::deserialize(in, result);
    if (result.outcome == AlignResult::SUCCESS) return result;
    why_not = fmt::format("there is no new plan ({}): {}", result.outcome, result.message);
  }
  return std::nullopt;
}

}  // namespace goal_alignment::execution
