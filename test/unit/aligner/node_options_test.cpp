// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/node_options.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace goal_alignment::aligner {
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
  } catch (const ros_common::ParameterError& error) {
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
  EXPECT_TRUE(options.session.assumed_wanted_predicates.empty());
  EXPECT_TRUE(options.session.assumed_unwanted_predicates.empty());
  EXPECT_EQ(options.session.max_extra_cost, std::numeric_limits<double>::infinity());
  EXPECT_EQ(options.ask_timeout, 0);
  EXPECT_TRUE(options.robot_domain.empty());
  EXPECT_TRUE(options.warnings.empty());
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
  values["assumed_wanted_predicates"] = listOf({"Robot-At", "dusty"});
  values["assumed_unwanted_predicates"] = listOf({});
  values["max_extra_cost"] = 0;
  NodeOptions options = read(values);
  EXPECT_EQ(options.session.max_group_size, 255U);
  EXPECT_TRUE(options.session.negative_candidates);
  EXPECT_EQ(options.session.assumed_wanted_predicates,
            (std::vector<std::string>{"robot-at", "dusty"}));
  EXPECT_TRUE(options.session.assumed_unwanted_predicates.empty());
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
  EXPECT_EQ(faultOf("assumed_wanted_predicates", "dusty"),
            "parameter /robot/aligner/assumed_wanted_predicates: expected a list of names, not the "
            "text 'dusty'");
  EXPECT_EQ(faultOf("assumed_unwanted_predicates", listOf({"ok", "(dusty)"})),
            "parameter /robot/aligner/assumed_unwanted_predicates: expected a list of names, not "
            "'(dusty)'");
  EXPECT_NE(faultOf("assumed_wanted_predicates", listOf({""})), "");
}

TEST(NodeOptions, aPredicateCantBeAssumedBothWays) {
  XmlRpcValue values;
  values["assumed_wanted_predicates"] = listOf({"dusty"});
  values["assumed_unwanted_predicates"] = listOf({"at", "Dusty"});
  EXPECT_THROW(read(values), ros_common::ParameterError);
}

TEST(NodeOptions, faultsNameKeyAndNamespace) {
  EXPECT_EQ(faultOf("beta", -1.0),
            "parameter /robot/aligner/beta: expected a number from 0 to 1000, not -1");
  EXPECT_EQ(faultOf("beta", "much"),
            "parameter /robot/aligner/beta: expected a number from 0 to 1000, not the text 'much'");
  EXPECT_EQ(faultOf("seed", 1.5),
            "parameter /robot/aligner/seed: expected a whole number from 0 to 2147483647, not 1.5");
  EXPECT_EQ(faultOf("costs", 1), "parameter /robot/aligner/costs: expected true or false, not 1");
  EXPECT_EQ(faultOf("phrases", 7), "parameter /robot/aligner/phrases: expected a text, not 7");
  EXPECT_EQ(faultOf("beta", true),
            "parameter /robot/aligner/beta: expected a number from 0 to 1000, not true");
  EXPECT_EQ(faultOf("tf_facts", listOf({"a", "b"})),
            "parameter /robot/aligner/tf_facts: expected a text, not a list");
  EXPECT_NE(faultOf("marker_frames", 3).find(", not 3"), std::string::npos);
  EXPECT_NE(faultOf("policy", 2).find(", not 2"), std::string::npos);
  EXPECT_NE(faultOf("policy", "guess").find("expected one of "), std::string::npos);
  EXPECT_NE(faultOf("policy", "guess").find("paper"), std::string::npos);
  EXPECT_NE(faultOf("ask_timeout", -0.5), "");
  EXPECT_NE(faultOf("time_limit", 0.0), "");
  EXPECT_NE(faultOf("max_questions", -2), "");
}

// YAML's 1e3 comes from rosparam as a text, and 2048.0 is no int.
TEST(NodeOptions, numbersAreReadInEverySpelling) {
  XmlRpcValue values;
  values["time_limit"] = "1e3";
  values["memory_limit"] = 2048.0;
  values["seed"] = "2e2";
  values["max_questions"] = "-1";
  values["beta"] = "1.5E-1";
  values["tf_timeout"] = "+3";
  const NodeOptions options = read(values);
  EXPECT_EQ(options.session.time_limit, 1000);
  EXPECT_EQ(options.session.memory_limit, std::size_t{2048} << 20U);
  EXPECT_EQ(options.session.seed, 200U);
  EXPECT_EQ(options.session.max_questions, -1);
  EXPECT_EQ(options.session.belief.beta, 0.15);
  EXPECT_EQ(options.tf_timeout, 3);
}

TEST(NodeOptions, whatIsNoNumberIsRefusedByWhatItIs) {
  for (const char* text :
       {"", "abc", "1e", "e3", "1 000", " 1", "1,5", "0x10", "nan", "inf", "1-2"})
    EXPECT_NE(faultOf("time_limit", text).find("not the text '" + std::string(text) + "'"),
              std::string::npos)
        << text;
  EXPECT_NE(faultOf("time_limit", "1e9"), "") << "out of its range";
  EXPECT_NE(faultOf("memory_limit", 2048.5).find("not 2048.5"), std::string::npos);
  EXPECT_NE(faultOf("seed", 1e300), "");
  EXPECT_NE(faultOf("seed", std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(NodeOptions, aTaskWaitsWhileAPlanIsCarriedOutUnlessItIsToBeRefused) {
  EXPECT_EQ(read(XmlRpcValue()).busy_policy, BusyPolicy::Wait);
  XmlRpcValue values;
  values["busy_policy"] = "refuse";
  EXPECT_EQ(read(values).busy_policy, BusyPolicy::Refuse);
  EXPECT_NE(faultOf("busy_policy", "later"), "");
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
  EXPECT_EQ(read(values).warnings,
            std::vector<std::string>{"unknown parameter /robot/aligner/polcy"});
}

TEST(NodeOptions, formerNamesOfParametersStillCount) {
  XmlRpcValue values;
  values["tf_patience"] = 7.0;
  values["hidden_wanted"] = listOf({"dusty"});
  values["hidden_not_wanted"] = listOf({"dark"});
  values["assumed_unwanted_predicates"] = listOf({"light"});
  const NodeOptions options = read(values);
  EXPECT_EQ(options.tf_timeout, 7);
  EXPECT_EQ(options.session.assumed_wanted_predicates, std::vector<std::string>{"dusty"});
  EXPECT_EQ(options.session.assumed_unwanted_predicates, std::vector<std::string>{"light"})
      << "the new name counts where both are given";
  ASSERT_EQ(options.warnings.size(), 3U);
  EXPECT_EQ(
      options.warnings.back(),
      "parameter /robot/aligner/tf_patience is now called /robot/aligner/tf_timeout; the name "
      "tf_patience will be removed in the next release");
  EXPECT_EQ(faultOf("tf_patience", -1),
            "parameter /robot/aligner/tf_patience: expected a number from 0 to 3600, not -1");
}

}  // namespace
}  // namespace goal_alignment::aligner
