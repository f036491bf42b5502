// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/executor_options.h"

#include <gtest/gtest.h>

#include "samples.h"

namespace goal_alignment::execution::test {
namespace {

std::string faultWith(const std::string& key, const XmlRpc::XmlRpcValue& value) {
  XmlRpc::XmlRpcValue values;
  values[key] = value;
  return faultOfCall([&] { ExecutorOptions::read(values, "/e"); });
}

TEST(ExecutorOptions, haveDefaults) {
  const ExecutorOptions options = ExecutorOptions::read({}, "/e");
  EXPECT_EQ(options.aligner, "goal_alignment");
  EXPECT_TRUE(options.watch);
  EXPECT_FALSE(options.auto_execute);
  EXPECT_EQ(options.max_replans, 3);
  EXPECT_EQ(options.clock, any_message::ClockKind::Wall);
}

TEST(ExecutorOptions, nameTheKeyThatIsWrong) {
  EXPECT_EQ(faultWith("step_duration", -1.0),
            "parameter /e/step_duration: expected a number from 0 to 3600, not -1");
  EXPECT_EQ(faultWith("failure_probability", 2),
            "parameter /e/failure_probability: expected a number from 0 to 1, not 2");
  EXPECT_EQ(faultWith("watch", "no"),
            "parameter /e/watch: expected true or false, not the text 'no'");
  EXPECT_EQ(faultWith("max_replans", 1.5),
            "parameter /e/max_replans: expected a whole number from 0 to 1000, not 1.5");
  EXPECT_EQ(faultWith("clock", "sundial").substr(0, 19), "parameter /e/clock:");
  for (const char* name : {"", "my-robot", "~aligner", "1st"}) {
    EXPECT_EQ(faultWith("aligner", name),
              "parameter /e/aligner: expected the name of the aligner's node");
  }
}

TEST(ExecutorOptions, warnOfUnknownParameters) {
  XmlRpc::XmlRpcValue values;
  values["step_duraton"] = 1;
  EXPECT_EQ(ExecutorOptions::read(values, "/e").warnings,
            std::vector<std::string>{"unknown parameter /e/step_duraton"});
}

TEST(ExecutorOptions, formerNamesOfParametersStillCount) {
  XmlRpc::XmlRpcValue values;
  values["facts_patience"] = 7.0;
  values["cancel_patience"] = 8.0;
  values["servers_patience"] = 9.0;
  const ExecutorOptions options = ExecutorOptions::read(values, "/e");
  EXPECT_EQ(options.facts_timeout, 7);
  EXPECT_EQ(options.cancel_timeout, 8);
  EXPECT_EQ(options.servers_timeout, 9);
  EXPECT_EQ(options.warnings.size(), 3U);
}

}  // namespace
}  // namespace goal_alignment::execution::test
