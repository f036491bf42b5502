// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/node_options.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace goal_alignment::ros_interface {
namespace {

using XmlRpc::XmlRpcValue;

NodeOptions read(XmlRpcValue values) {
  return NodeOptions::read(values, "/robot/aligner");
}

std::string faultOf(const std::string& key, const XmlRpcValue& value) {
  XmlRpcValue values;
  values[key] = value;
  try {
    read(values);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "";
}

TEST(NodeOptions, defaultsWhereNothingIsSet) {
  const NodeOptions options = read(XmlRpcValue());
  EXPECT_EQ(options.session.policy, "auto");
  EXPECT_EQ(options.session.conflicts, session::ConflictMode::Lazy);
  EXPECT_EQ(options.session.time_limit, 300);
  EXPECT_EQ(options.session.memory_limit, std::size_t{2048} << 20U);
  EXPECT_EQ(options.session.max_questions, -1);
  EXPECT_EQ(options.session.max_group_size, 1U);
  EXPECT_FALSE(options.session.negative_candidates);
  EXPECT_TRUE(options.session.hidden_wanted.empty());
  EXPECT_TRUE(options.session.hidden_not_wanted.empty());
  EXPECT_EQ(options.session.max_extra_cost, std::numeric_limits<double>::infinity());
  EXPECT_EQ(options.ask_timeout, 0);
  EXPECT_TRUE(options.robot_domain.empty());
  EXPECT_TRUE(options.unknown.empty());
}

TEST(NodeOptions, valuesAreTakenOver) {
  XmlRpcValue values;
  values["robot_domain"] = "a.pddl";
  values["policy"] = "paper";
  values["belief"] = "flat:0.25";
  values["beta"] = 2;  // a whole number where a fraction may stand
  values["conflicts"] = "full";
  values["unsure_policy"] = "abort";
  values["plan"] = "anytime";
  values["threads"] = 3;
  values["static_candidates"] = false;
  values["memory_limit"] = 64;
  values["ask_timeout"] = 1.5;
  const NodeOptions options = read(values);
  EXPECT_EQ(options.robot_domain, "a.pddl");
  EXPECT_EQ(options.session.policy, "paper");
  EXPECT_EQ(options.session.belief.mode, alignment::BeliefMode::Flat);
  EXPECT_EQ(options.session.belief.flat, 0.25);
  EXPECT_EQ(options.session.belief.beta, 2);
  EXPECT_EQ(options.session.conflicts, session::ConflictMode::Full);
  EXPECT_EQ(options.session.unsure_policy, session::UnsurePolicy::Abort);
  EXPECT_EQ(options.session.plan, session::PlanMode::Anytime);
  EXPECT_EQ(options.session.threads, 3);
  EXPECT_FALSE(options.session.static_candidates);
  EXPECT_EQ(options.session.memory_limit, std::size_t{64} << 20U);
  EXPECT_EQ(options.ask_timeout, 1.5);
}

XmlRpcValue listOf(const std::vector<std::string>& texts) {
  XmlRpcValue list;
  list.setSize(static_cast<int>(texts.size()));
  for (std::size_t i = 0; i < texts.size(); ++i)
    list[static_cast<int>(i)] = texts[i];
  return list;
}

TEST(NodeOptions, whatIsAskedAboutIsTakenOver) {
  XmlRpcValue values;
  values["max_group_size"] = 255;
  values["negative_candidates"] = true;
  values["hidden_wanted"] = listOf({"Robot-At", "dusty"});
  values["hidden_not_wanted"] = listOf({});
  values["max_extra_cost"] = 0;
  NodeOptions options = read(values);
  EXPECT_EQ(options.session.max_group_size, 255U);
  EXPECT_TRUE(options.session.negative_candidates);
  EXPECT_EQ(options.session.hidden_wanted, (std::vector<std::string>{"robot-at", "dusty"}));
  EXPECT_TRUE(options.session.hidden_not_wanted.empty());
  EXPECT_EQ(options.session.max_extra_cost, 0);
  values["max_extra_cost"] = -1;
  EXPECT_EQ(read(values).session.max_extra_cost, std::numeric_limits<double>::infinity());
  values["max_extra_cost"] = 1e9;
  EXPECT_EQ(read(values).session.max_extra_cost, 1e9);
}

TEST(NodeOptions, whatIsAskedAboutHasItsRange) {
  EXPECT_EQ(
      faultOf("max_group_size", 0),
      "parameter /robot/aligner/max_group_size: expected a whole number from 1 to 255, not 0");
  EXPECT_NE(faultOf("max_group_size", 256), "");
  EXPECT_NE(faultOf("negative_candidates", 1), "");
  EXPECT_EQ(faultOf("max_extra_cost", -0.5),
            "parameter /robot/aligner/max_extra_cost: expected 0 or more, or -1");
  EXPECT_NE(faultOf("max_extra_cost", -2), "");
  EXPECT_NE(faultOf("max_extra_cost", 2e9), "");
  EXPECT_EQ(faultOf("hidden_wanted", "dusty"),
            "parameter /robot/aligner/hidden_wanted: expected a list of names");
  EXPECT_EQ(faultOf("hidden_not_wanted", listOf({"ok", "(dusty)"})),
            "parameter /robot/aligner/hidden_not_wanted: expected a list of names, not '(dusty)'");
  EXPECT_NE(faultOf("hidden_wanted", listOf({""})), "");
}

TEST(NodeOptions, aPredicateCantBeAssumedBothWays) {
  XmlRpcValue values;
  values["hidden_wanted"] = listOf({"dusty"});
  values["hidden_not_wanted"] = listOf({"at", "Dusty"});
  EXPECT_THROW(read(values), ParameterError);
}

TEST(NodeOptions, faultsNameKeyAndNamespace) {
  EXPECT_EQ(faultOf("beta", -1.0),
            "parameter /robot/aligner/beta: expected a number from 0 to 1000, not -1");
  EXPECT_EQ(faultOf("beta", "much"),
            "parameter /robot/aligner/beta: expected a number from 0 to 1000");
  EXPECT_EQ(faultOf("seed", 1.5),
            "parameter /robot/aligner/seed: expected a whole number from 0 to 2147483647");
  EXPECT_EQ(faultOf("costs", 1), "parameter /robot/aligner/costs: expected true or false");
  EXPECT_EQ(faultOf("phrases", 7), "parameter /robot/aligner/phrases: expected a text");
  EXPECT_NE(faultOf("policy", "guess").find("expected one of "), std::string::npos);
  EXPECT_NE(faultOf("policy", "guess").find("paper"), std::string::npos);
  EXPECT_NE(faultOf("ask_timeout", -0.5), "");
  EXPECT_NE(faultOf("time_limit", 0.0), "");
  EXPECT_NE(faultOf("max_questions", -2), "");
}

TEST(NodeOptions, beliefsThatAreNoneAreRefused) {
  for (const char* belief :
       {"flat", "flat:", "flat:2", "flat:-0.1", "flat:x", "flat:0.5x", "none"}) {
    EXPECT_NE(faultOf("belief", belief), "") << belief;
  }
  EXPECT_EQ(faultOf("belief", "raw"), "");
}

TEST(NodeOptions, unknownKeysAreListedButNamespacesAreNot) {
  XmlRpcValue values;
  values["polcy"] = "auto";
  values["align"]["status_frequency"] = 5.0;
  EXPECT_EQ(read(values).unknown, std::vector<std::string>{"polcy"});
}

}  // namespace
}  // namespace goal_alignment::ros_interface
