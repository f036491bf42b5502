// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "goal_alignment/dialogues/speech_options.h"
#include "goal_alignment/dialogues/speech_process.h"
#include "goal_alignment/ros_common/parameter_reader.h"

namespace goal_alignment::dialogues {
namespace {

using XmlRpc::XmlRpcValue;

std::string faultOf(const std::string& key, const XmlRpcValue& value) {
  XmlRpcValue values;
  values[key] = value;
  try {
    SpeechOptions::read(values, "/speech");
  } catch (const ros_common::ParameterError& error) {
    return error.what();
  }
  return "";
}

XmlRpcValue list(const std::vector<std::string>& texts) {
  XmlRpcValue value;
  value.setSize(static_cast<int>(texts.size()));
  for (int i = 0; i < value.size(); ++i)
    value[i] = texts[static_cast<std::size_t>(i)];
  return value;
}

TEST(SpeechOptions, fillTheCommandInWithoutAShell) {
  XmlRpcValue values;
  values["voice"] = "de";
  values["rate"] = 120;
  const SpeechOptions options = SpeechOptions::read(values, "/speech");
  EXPECT_EQ(options.commandFor("$(rm -r x); \"yes\" {voice}"),
            (std::vector<std::string>{"espeak-ng", "-v", "de", "-s", "120", "--",
                                      "$(rm -r x); \"yes\" {voice}"}));
}

TEST(SpeechOptions, mayBeSilent) {
  XmlRpcValue values;
  values["say_command"] = list({});
  EXPECT_TRUE(SpeechOptions::read(values, "/speech").commandFor("text").empty());
}

TEST(SpeechOptions, faultsNameKeyAndNamespace) {
  EXPECT_EQ(faultOf("rate", 10),
            "parameter /speech/rate: expected a whole number from 80 to 450, not 10");
  EXPECT_NE(faultOf("say_command", "espeak-ng"), "");
  EXPECT_NE(faultOf("say_command", list({"espeak-ng"})).find("{text}"), std::string::npos);
  EXPECT_NE(faultOf("say_command", list({"", "{text}"})), "");
  EXPECT_NE(faultOf("say_command", list({"{text}"})), "");
  EXPECT_NE(faultOf("voice", ""), "");
  EXPECT_NE(faultOf("person", ""), "");
  EXPECT_NE(faultOf("reply_timeout", 0.0), "");
  EXPECT_NE(faultOf("echo_time", -1.0), "");
  EXPECT_NE(faultOf("retries", 101), "");
  EXPECT_NE(faultOf("say_timeout", 0.5), "");
  EXPECT_NE(faultOf("vocabulary", 3), "");
}

TEST(SpeechOptions, warnOfUnknownParameters) {
  XmlRpcValue values;
  values["reply_timout"] = 3.0;
  EXPECT_EQ(SpeechOptions::read(values, "/speech").warnings,
            std::vector<std::string>{"unknown parameter /speech/reply_timout"});
}

bool eventuallyEnds(SpeechProcess& process) {
  for (int i = 0; i < 4000 && process.isRunning(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return !process.isRunning();
}

TEST(SpeechProcess, runsAProgramToItsEnd) {
  SpeechProcess process;
  EXPECT_FALSE(process.isRunning());
  ASSERT_TRUE(process.start({"sh", "-c", "exit 3"}));
  EXPECT_TRUE(eventuallyEnds(process));
  EXPECT_EQ(process.lastStatus(), 3);
  ASSERT_TRUE(process.start({"/bin/true"}));
  EXPECT_TRUE(eventuallyEnds(process));
  EXPECT_EQ(process.lastStatus(), 0);
}

TEST(SpeechProcess, thereMayBeNoSuchProgram) {
  SpeechProcess process;
  EXPECT_FALSE(process.start({"no-such-program-to-speak-with", "text"}));
  EXPECT_FALSE(process.start({"/no/such/program", "text"}));
  EXPECT_FALSE(process.isRunning());
}

TEST(SpeechProcess, aProgramThatMayNotRunIsAnError) {
  const std::string file =
      (std::filesystem::path(testing::TempDir()) / "speech_test_no_program").string();
  std::ofstream(file) << "no program";
  ASSERT_EQ(chmod(file.c_str(), 0600), 0);
  SpeechProcess process;
  EXPECT_THROW(process.start({file}), std::system_error);
  std::filesystem::remove(file);
}

TEST(SpeechProcess, isStoppedWithAllThatItStarted) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string file =
      (std::filesystem::path(testing::TempDir()) / "speech_test_child").string();
  std::filesystem::remove(file);
  {
    SpeechProcess process;
    ASSERT_TRUE(process.start(
        {"sh", "-c", "sleep 600 & echo $! > \"$0.part\"; mv \"$0.part\" \"$0\"; wait", file}));
    for (int i = 0; i < 4000 && !std::filesystem::exists(file); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_TRUE(process.isRunning());
  }
  pid_t child = 0;
  std::ifstream(file) >> child;
  ASSERT_GT(child, 0);
  bool gone = false;
  for (int i = 0; i < 4000 && !gone; ++i) {
    // A zombie that nobody has reaped yet is gone as well.
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    std::string id;
    std::string name;
    std::string state;
    gone = !(stat >> id >> name >> state) || state == "Z";
    if (!gone) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_TRUE(gone);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(300));
  std::filesystem::remove(file);
}

TEST(SpeechProcess, goesByForceWhereItDoesNotListen) {
  SpeechProcess process;
  ASSERT_TRUE(process.start({"sh", "-c", "trap '' TERM; while :; do sleep 1; done"}));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  process.stop();
  EXPECT_FALSE(process.isRunning());
}

}  // namespace
}  // namespace goal_alignment::dialogues
