// SPDX-License-Identifier: BSD-3-Clause
// speech_dialogue: what it says, what it hears, and what it does not want to hear.
#include <ros/package.h>
#include <roscpp/SetLoggerLevel.h>
#include <rosgraph_msgs/Log.h>
#include <signal.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <list>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "aligner_calls.h"
#include "goal_alignment/AskHuman.h"
#include "program.h"

namespace goal_alignment::test {
namespace {

constexpr const char* kNode = "/speech_dialogue";

/// Calls ask_human as no aligner would, in a thread of its own.
class Asker {
 public:
  Asker(std::uint32_t question_id, const std::vector<Fluent>& fluents) {
    Question& question = call_.request.question;
    question.header.stamp = ros::Time::now();
    question.question_id = question_id;
    question.fluents = fluents;
    question.text = "Does it matter to you?";
    thread_ = std::thread([this] { has_reply_ = callService("/ask_human", call_); });
  }
  ~Asker() { thread_.join(); }
  Asker(const Asker&) = delete;
  Asker& operator=(const Asker&) = delete;

  bool hasReply() const { return has_reply_; }
  /// Once there is one.
  const AskHuman::Response& reply() const { return call_.response; }

 private:
  AskHuman call_;
  std::atomic<bool> has_reply_{false};
  std::thread thread_;
};

class Speech : public Scenario {
 protected:
  Speech()
      : said_(node_, std::string(kNode) + "/said"),
        log_(node_, "/rosout"),
        recogniser_(node_.advertise<std_msgs::String>("/recognised_speech", 100)) {}

  void SetUp() override {
    Scenario::SetUp();
    set("say_command",
        std::vector<std::string>{ros::package::getPath("goal_alignment") + "/test/ros/fake_say.sh",
                                 folder_.path(), "{text}", "{voice}", "{rate}"});
    set("echo_time", 0.05);
    set("reply_timeout", 600.0);
  }

  void TearDown() override {
    release();
    Scenario::TearDown();
    dialogue_.reset();
    askers_.clear();  // nobody is there any more whom they could wait for
    ros::param::del(kNode);
  }

  template <typename Value>
  static void set(const std::string& key, const Value& value) {
    ros::param::set(std::string(kNode) + "/" + key, value);
  }

  std::unique_ptr<Program> program() const {
    return std::make_unique<Program>(NODE_FOLDER "/speech_dialogue", std::vector<std::string>{},
                                     std::map<std::string, std::string>{}, output());
  }

  void start() {
    dialogue_ = program();
    ASSERT_TRUE(isOffered("/ask_human"));
    ASSERT_TRUE(eventually([this] { return recogniser_.getNumSubscribers() == 1; }));
    ASSERT_TRUE(eventually([this] { return said_.isHeard(); }));
    // So that we learn what it did not listen to.
    roscpp::SetLoggerLevel call;
    call.request.logger = "ros";
    call.request.level = "debug";
    ASSERT_TRUE(
        eventually([&] { return callService(std::string(kNode) + "/set_logger_level", call); }));
    // Until its log reaches us.
    ASSERT_TRUE(speakUntil("testing", [this] { return wasNotListenedTo("testing"); }));
    ASSERT_TRUE(isNotListenedTo("tested"));
  }

  Asker& ask(std::uint32_t question_id, const std::vector<Fluent>& fluents) {
    return askers_.emplace_back(question_id, fluents);
  }

  void speak(const std::string& text) {
    std_msgs::String message;
    message.data = text;
    recogniser_.publish(message);
  }

  /// Until it is listened to.
  bool speakUntil(const std::string& text, const std::function<bool()>& holds) {
    return eventually([&] {
      if (holds()) return true;
      speak(text);
      ros::WallDuration(0.05).sleep();
      return holds();
    });
  }

  bool isOver() { return align_.getState().isDone(); }

  /// Says it, and returns when the dialogue has heard it and did not listen.
  bool isNotListenedTo(const std::string& text) {
    speak(text);
    return eventually([&] { return wasNotListenedTo(text); });
  }

  bool wasNotListenedTo(const std::string& text) const {
    for (const rosgraph_msgs::Log& line : log_.all())
      if (line.name == kNode && line.msg == "not listening: " + text) return true;
    return false;
  }

  bool says(const std::string& part) {
    return said_
        .waitFor(
            [&](const std_msgs::String& text) { return text.data.find(part) != std::string::npos; })
        .has_value();
  }

  /// How often it has said something with this in it.
  std::size_t timesSaid(const std::string& part) const {
    std::size_t count = 0;
    for (const std_msgs::String& text : said_.all())
      count += text.data.find(part) != std::string::npos ? 1 : 0;
    return count;
  }

  void hold() const { writeText(file("hold"), ""); }
  void release() const { std::filesystem::remove(file("hold")); }
  std::string file(const std::string& name) const { return folder_.path() + "/" + name; }
  std::string output() const { return file("output"); }

  TemporaryFolder folder_;
  Topic<std_msgs::String> said_;
  Topic<rosgraph_msgs::Log> log_;
  ros::Publisher recogniser_;
  std::unique_ptr<Program> dialogue_;
  std::list<Asker> askers_;
};

std::string answererOf(const AlignResult& result, const std::string& name) {
  for (const Candidate& candidate : result.candidates)
    if (candidate.fluent.name == name) return candidate.answered_by;
  return "";
}

TEST_F(Speech, saysTheQuestionAloudAndTakesTheAnswer) {
  set("voice", std::string("en-gb"));
  start();
  const Question question = sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(says(question.text));
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(file("pid.0")); }));
  EXPECT_EQ(textOf(file("said.0")), question.text + "\nen-gb\n160\n");
  EXPECT_TRUE(speakUntil("No, thank you.", [this] { return isOver(); }));
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_EQ(answererOf(result, "quiet"), "Ann") << "whom the question is for";
}

TEST_F(Speech, answersForItsPersonWhereTheQuestionNamesNobody) {
  set("person", std::string("somebody at home"));
  start();
  AlignGoal goal = sweepHall();
  goal.task.person.clear();
  sendAndAwaitQuestion(goal);
  EXPECT_TRUE(speakUntil("no", [this] { return isOver(); }));
  EXPECT_EQ(answererOf(awaitResult(), "quiet"), "somebody at home");
}

TEST_F(Speech, doesNotHearItself) {
  start();
  hold();
  sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(file("pid.0")); }));
  // The answer yes would end it without a plan.
  EXPECT_TRUE(isNotListenedTo("yes"));
  release();
  EXPECT_TRUE(speakUntil("no", [this] { return isOver(); }));
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

TEST_F(Speech, doesNotHearWhatIsSaidOutsideOfAQuestion) {
  start();
  EXPECT_TRUE(isNotListenedTo("yes"));
  sendAndAwaitQuestion(sweepHall());
  EXPECT_TRUE(speakUntil("no", [this] { return isOver(); }));
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  EXPECT_TRUE(isNotListenedTo("no"));
}

TEST_F(Speech, saysSorryWhereItDoesNotUnderstandAndGivesItsReason) {
  start();
  const Question question = sendAndAwaitQuestion(sweepHall());
  ASSERT_FALSE(question.why.empty());
  EXPECT_TRUE(speakUntil("bananas", [this] { return timesSaid("Sorry? ") > 0; }));
  EXPECT_TRUE(says("Sorry? " + question.text));
  EXPECT_TRUE(speakUntil("why?", [&] { return timesSaid(question.why) > 0; }));
  EXPECT_TRUE(speakUntil("say that again",
                         [&] { return timesSaid(question.text) > 1 + timesSaid("Sorry? "); }));
  EXPECT_TRUE(speakUntil("yes", [this] { return isOver(); }));
  EXPECT_EQ(awaitResult().outcome, AlignResult::EXPECTATION_UNACHIEVABLE);
}

TEST_F(Speech, asksAgainAfterSilenceAndThenOnlyListens) {
  set("reply_timeout", 0.1);
  set("retries", 1);
  start();
  const Question question = sendAndAwaitQuestion(sweepHall());
  EXPECT_TRUE(eventually([&] { return timesSaid(question.text) == 2; }));
  EXPECT_FALSE(eventually([&] { return timesSaid(question.text) > 2; }, 0.5));
  EXPECT_TRUE(speakUntil("no", [this] { return isOver(); }));
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

TEST_F(Speech, saysThatItHasAPlanAndListensNoMore) {
  start();
  sendAndAwaitQuestion(sweepHall());
  EXPECT_TRUE(speakUntil("whatever", [this] { return isOver(); }));
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS);
  EXPECT_TRUE(says(result.message));
  EXPECT_TRUE(says("It is one step: "));
  EXPECT_TRUE(isNotListenedTo("no"));
}

TEST_F(Speech, takesUpTheAlternativeThatIsSaid) {
  start();
  sendAndAwaitQuestion(sweepHall());
  EXPECT_TRUE(speakUntil("yeah sure", [this] { return isOver(); }));
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::EXPECTATION_UNACHIEVABLE);
  EXPECT_TRUE(says(result.message + " Shall I do that?"));
  EXPECT_TRUE(speakUntil("bananas", [this] { return timesSaid("Sorry? ") > 0; }));
  EXPECT_TRUE(speakUntil("okay, do that", [this] { return timesSaid("All right.") > 0; }));
  EXPECT_TRUE(states_.waitFor([&](const AlignmentState& state) {
    return state.session_id == result.session_id && state.phase == AlignmentState::DONE &&
           state.outcome == AlignResult::SUCCESS;
  }));
}

TEST_F(Speech, speaksAndUnderstandsGermanFromTheQuestionToTheEnd) {
  writeText(file("phrases.yaml"), R"(language: de
predicates:
  clean: {affirmative: "{0} ist sauber", that: "{0} sauber ist"}
  quiet:
    affirmative: "{0} bleibt leise"
    that: "{0} leise bleibt"
objects: {hall: {name: "der Flur", akk: "den Flur"}}
actions: {sweep: "{0:akk} fegen"}
)");
  const Parameter phrases("phrases", file("phrases.yaml"));
  set("vocabulary", ros::package::getPath("goal_alignment") + "/config/vocabulary/de.yaml");
  start();
  const Question question = sendAndAwaitQuestion(sweepHall());
  EXPECT_EQ(question.text,
            "Wenn ich fertig bin: Ist es Ihnen dann wichtig, dass der Flur leise bleibt?");
  EXPECT_TRUE(speakUntil("Bananen", [this] { return timesSaid("Wie bitte? ") > 0; }));
  EXPECT_TRUE(speakUntil("Wieso?", [&] { return timesSaid(question.why) > 0; }));
  EXPECT_TRUE(speakUntil("Ja, klar.", [this] { return isOver(); }));
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::EXPECTATION_UNACHIEVABLE);
  EXPECT_TRUE(says(result.message + " Soll ich das tun?"));
  EXPECT_TRUE(speakUntil("Meinetwegen!", [this] { return timesSaid("In Ordnung.") > 0; }));
  EXPECT_TRUE(says("Er hat einen Schritt: den Flur fegen."));
}

TEST_F(Speech, leavesItWhereNoAlternativeIsWanted) {
  start();
  sendAndAwaitQuestion(sweepHall());
  EXPECT_TRUE(speakUntil("yes", [this] { return isOver(); }));
  EXPECT_EQ(awaitResult().outcome, AlignResult::EXPECTATION_UNACHIEVABLE);
  EXPECT_TRUE(says("Shall I do that?"));
  EXPECT_TRUE(speakUntil("no thanks", [this] { return timesSaid("leave it at that") > 0; }));
  EXPECT_TRUE(isNotListenedTo("yes"));
}

TEST_F(Speech, takesNumbersAndNamesForAGroup) {
  const Parameter groups("max_group_size", 2);
  start();
  for (const char* answer : {"the first one", "hall"}) {
    const Question question = sendAndAwaitQuestion(sweepBothRooms());
    ASSERT_EQ(question.fluents.size(), 2U);
    EXPECT_TRUE(says("Which of these matter to you? one: "));
    const std::string wanted =
        answer == std::string("hall") ? "hall" : question.fluents.at(0).args.at(0);
    EXPECT_TRUE(speakUntil(answer, [this] { return isOver(); }));
    for (const Candidate& candidate : awaitResult().candidates) {
      if (candidate.fluent.name != "quiet") continue;
      const bool is_wanted = candidate.fluent.args.at(0) == wanted;
      EXPECT_EQ(int{candidate.state}, is_wanted ? Candidate::WANTED : Candidate::NOT_WANTED)
          << answer << ": " << candidate.fluent.args.at(0);
    }
    // What was said too often must not answer the next question.
    EXPECT_TRUE(isNotListenedTo(std::string("enough of ") + answer));
  }
}

TEST_F(Speech, leavesAQuestionWithoutAProperFluentUnansweredAndTakesTheNext) {
  start();
  Fluent with_text;
  with_text.text = "nothing in particular";
  for (const Fluent& bad : {Fluent(), with_text, fluent("quiet", {"a room"})}) {
    Asker& asker = ask(5, {fluent("quiet", {"hall"}), bad});
    ASSERT_TRUE(eventually([&] { return asker.hasReply(); }));
    EXPECT_EQ(int{asker.reply().answer}, AskHuman::Response::NONE);
    EXPECT_EQ(asker.reply().question_id, 5U);
  }
  EXPECT_TRUE(log_.waitFor([](const rosgraph_msgs::Log& line) {
    return line.name == kNode && line.level == rosgraph_msgs::Log::WARN &&
           line.msg.find("question 5 is left unanswered: question.fluents[1]: ") == 0;
  }));
  sendAndAwaitQuestion(sweepHall());
  EXPECT_TRUE(speakUntil("no", [this] { return isOver(); }));
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

TEST_F(Speech, saysTheNameOfAFluentThatHasNoText) {
  start();
  Asker& asker = ask(5, {fluent("quiet", {"hall"}), fluent("lit", {"a1"})});
  EXPECT_TRUE(says("(lit a1)"));
  ASSERT_TRUE(speakUntil("the first one", [&] { return asker.hasReply(); }));
  EXPECT_EQ(int{asker.reply().answer}, AskHuman::Response::YES);
  EXPECT_EQ(asker.reply().fluents, std::vector<std::string>{"(quiet hall)"});
}

TEST_F(Speech, hearsWhileManyAskersWait) {
  start();
  hold();
  constexpr std::uint32_t kAskers = 4;
  for (std::uint32_t id = 1; id <= kAskers; ++id)
    ask(id, {fluent("quiet", {"hall"})});
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(file("pid.0")); }));
  ros::WallDuration(0.5).sleep();  // until the others wait; were they late, this would show less
  EXPECT_TRUE(isNotListenedTo("too early"));
  release();
  ASSERT_TRUE(speakUntil("no", [this] {
    return std::all_of(askers_.begin(), askers_.end(),
                       [](const Asker& asker) { return asker.hasReply(); });
  }));
  std::uint32_t id = 0;
  for (const Asker& asker : askers_) {
    EXPECT_EQ(int{asker.reply().answer}, AskHuman::Response::NO);
    EXPECT_EQ(asker.reply().question_id, ++id);
  }
}

TEST_F(Speech, fallsSilentWhenSomebodyElseHasAnswered) {
  start();
  hold();
  const Question question = sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(file("pid.0")); }));
  const pid_t speaker = std::stoi(textOf(file("pid.0")));
  EXPECT_TRUE(answer(Answer::Request::NO, question.question_id).accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  EXPECT_TRUE(eventually([&] { return kill(speaker, 0) != 0 && errno == ESRCH; }));
}

TEST_F(Speech, takesItsProgramWithItWhenItIsToldToEnd) {
  const std::string alive = folder_.path() + "/alive";
  set("say_command",
      std::vector<std::string>{"sh", "-c", "while true; do echo >> " + alive + "; sleep 0.05; done",
                               "{text}"});
  start();
  ask(5, {fluent("served", {"tea"})});
  ASSERT_TRUE(eventually([&] { return !textOf(alive).empty(); }));
  dialogue_->signal(SIGTERM);
  EXPECT_EQ(dialogue_->exitStatus(), 0);
  const std::string last = textOf(alive);
  ros::WallDuration(0.5).sleep();
  EXPECT_EQ(textOf(alive), last) << "nobody speaks any more";
}

TEST_F(Speech, goesOnWithAProgramThatFails) {
  set("say_command", std::vector<std::string>{"false", "{text}"});
  start();
  align_.sendGoal(sweepHall());
  EXPECT_TRUE(speakUntil("no", [this] { return isOver(); }));
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  EXPECT_TRUE(log_.waitFor([](const rosgraph_msgs::Log& line) {
    return line.name == kNode && line.msg.find("false ended with status 1") != std::string::npos;
  }));
}

TEST_F(Speech, goesOnWithoutAProgramThatSpeaksAndWarnsOnce) {
  set("say_command", std::vector<std::string>{"no-such-program-to-speak-with", "{text}"});
  start();
  align_.sendGoal(sweepBothRooms());
  EXPECT_TRUE(speakUntil("no", [this] { return isOver(); }));
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  EXPECT_TRUE(eventually([this] { return said_.all().size() >= 2; }));
  const auto is_warning = [](const rosgraph_msgs::Log& line) {
    return line.name == kNode && line.level == rosgraph_msgs::Log::WARN &&
           line.msg.find("no-such-program-to-speak-with") != std::string::npos;
  };
  EXPECT_TRUE(log_.waitFor(is_warning));
  EXPECT_TRUE(isNotListenedTo("that is all")) << "what came before has arrived";
  std::size_t warnings = 0;
  for (const rosgraph_msgs::Log& line : log_.all())
    warnings += is_warning(line) ? 1 : 0;
  EXPECT_EQ(warnings, 1U);
}

TEST_F(Speech, refusesWrongParametersAndSaysWhich) {
  set("rate", 1);
  EXPECT_EQ(program()->exitStatus(), 1);
  EXPECT_NE(textOf(output()).find("/speech_dialogue/rate: expected"), std::string::npos);
  set("rate", 160);
  writeText(file("words.yaml"), "'yes': ['yes']\n'no': 'no'\n");
  set("vocabulary", file("words.yaml"));
  EXPECT_EQ(program()->exitStatus(), 1);
  EXPECT_NE(textOf(output()).find("words.yaml:2:7: expected a list"), std::string::npos)
      << textOf(output());
}

}  // namespace
}  // namespace goal_alignment::test
