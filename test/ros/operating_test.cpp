// SPDX-License-Identifier: BSD-3-Clause
// What whoever runs the node sees and needs: /diagnostics, /rosout, log levels, parameters that are
// wrong, a clock that does not run, a second robot.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <roscpp/SetLoggerLevel.h>
#include <rosgraph_msgs/Log.h>

#include <csignal>
#include <map>
#include <set>

#include "aligner_calls.h"
#include "graph.h"
#include "program.h"

namespace goal_alignment::test {
namespace {

using diagnostic_msgs::DiagnosticArray;
using rosgraph_msgs::Log;
constexpr int kNo = Answer::Request::NO;

class Operating : public Scenario {
 protected:
  Operating() : log_(node_, "/rosout") {}

  void SetUp() override {
    Scenario::SetUp();
    ASSERT_TRUE(eventually([] { return reachesUs("/goal_alignment", "/rosout"); }));
  }

  static void setLogLevel(const std::string& level) {
    roscpp::SetLoggerLevel call;
    call.request.logger = "ros.goal_alignment";
    call.request.level = level;
    EXPECT_TRUE(callService("/goal_alignment/set_logger_level", call));
  }

  bool logged(int level, const std::string& part = "") {
    return log_.waitFor([&](const Log& line) { return isFrom(line, level, part); }).has_value();
  }

  std::size_t count(int level, const std::string& part = "") const {
    const auto lines = log_.all();
    return static_cast<std::size_t>(std::count_if(
        lines.begin(), lines.end(), [&](const Log& line) { return isFrom(line, level, part); }));
  }

  void serve() {
    align_.sendGoal(sweepSilently());
    EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  }

  Topic<Log> log_;

 private:
  static bool isFrom(const Log& line, int level, const std::string& part) {
    return line.name == "/goal_alignment" && line.level == level &&
           line.msg.find(part) != std::string::npos;
  }
};

// The aligner's values on /diagnostics by their keys.
std::map<std::string, std::string> valuesOf(const DiagnosticArray& message) {
  std::map<std::string, std::string> values;
  for (const auto& status : message.status) {
    if (status.name != "goal_alignment: alignment") continue;
    for (const auto& value : status.values)
      values[value.key] = value.value;
  }
  return values;
}

TEST_F(Operating, diagnosticsShowPhaseQuestionItsAgeAnswerersAndOutcome) {
  Topic<DiagnosticArray> diagnostics(node_, "/diagnostics");
  const auto shows = [&](const std::function<bool(std::map<std::string, std::string>&)>& fits) {
    return diagnostics
        .waitFor([&](const DiagnosticArray& message) {
          auto values = valuesOf(message);
          return !values.empty() && fits(values);
        })
        .has_value();
  };
  const Question question = sendAndAwaitQuestion(sweepHall());
  const std::string id = std::to_string(question.question_id) + ": ";
  EXPECT_TRUE(shows([&](auto& values) {
    return values["phase"] == "awaiting an answer" && values["session"] == question.session_id &&
           values["open question"] == id + question.text;
  }));
  EXPECT_TRUE(shows([&](auto& values) {
    return values["open question"].find(id) == 0 && std::stoi("0" + values["open for (s)"]) >= 1;
  })) << "its age grows";
  EXPECT_TRUE(answer(kNo, question.question_id).accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  EXPECT_TRUE(shows([&](auto& values) {
    return values["session"] == question.session_id && values["phase"] == "done" &&
           values["open question"] == "none" && values.count("open for (s)") == 0 &&
           values["last outcome"].find("1 (plan_found)") == 0 &&
           values["answerers seen"].find("test (") != std::string::npos;
  }));
  for (const DiagnosticArray& message : diagnostics.all())
    EXPECT_FALSE(message.header.stamp.isZero());
}

TEST_F(Operating, theLogLevelChangesAtRunTime) {
  setLogLevel("info");
  serve();
  const std::size_t before = count(Log::DEBUG);
  serve();
  EXPECT_TRUE(logged(Log::INFO, "outcome 1")) << "it reaches us";
  EXPECT_EQ(count(Log::DEBUG), before);
  setLogLevel("debug");
  serve();
  EXPECT_TRUE(logged(Log::DEBUG));
  setLogLevel("info");
}

TEST_F(Operating, aParameterThatNobodyReadsIsWarnedAboutOnce) {
  const Parameter parameter("max_question", 3);  // a slip
  serve();
  EXPECT_TRUE(logged(Log::WARN, parameter.name()));
  serve();
  const Parameter next("polici", std::string("paper"));
  serve();
  EXPECT_TRUE(logged(Log::WARN, next.name()));
  EXPECT_EQ(count(Log::WARN, parameter.name()), 1U);
}

TEST_F(Operating, aParameterOutOfRangeIsAnErrorAtTheStart) {
  const TemporaryFolder folder;
  const std::string output = folder.path() + "/output";
  Program program(NODE_FOLDER "/goal_alignment_node",
                  {"__ns:=/ill", "__name:=aligner", "_beta:=-1.5"}, {{"ROS_HOME", folder.path()}},
                  output);
  EXPECT_TRUE(eventually([&] {
    const std::string text = textOf(output);
    return text.find("ERROR") != std::string::npos &&
           text.find("/ill/aligner/beta: expected a number from 0") != std::string::npos;
  })) << textOf(output);
  EXPECT_TRUE(isOffered("/ill/aligner/get_state")) << "it starts nevertheless";
  program.signal(SIGINT);
  EXPECT_EQ(program.exitStatus(), 0);
  ros::param::del("/ill");
}

bool hasClock() {
  ros::master::V_TopicInfo topics;
  EXPECT_TRUE(ros::master::getTopics(topics));
  return std::any_of(topics.begin(), topics.end(),
                     [](const ros::master::TopicInfo& topic) { return topic.name == "/clock"; });
}

// What is later than any simulated time: the aligner keeps wall time then.
constexpr std::uint32_t kThisCentury = 1000000000;

// Without actionlib's clients, which wait for a clock.
TEST(NoClock, aTaskByTopicLeadsToAQuestionAndAPlan) {
  ASSERT_FALSE(hasClock());
  ros::NodeHandle node;
  Topic<Question> questions(node, "/goal_alignment/question");
  Topic<AlignmentState> states(node, "/goal_alignment/state");
  Topic<Plan> plans(node, "/goal_alignment/plan");
  Topic<DiagnosticArray> diagnostics(node, "/diagnostics");
  ros::Publisher tasks = node.advertise<HumanTask>("/human_task", 1);
  ASSERT_TRUE(eventually([&] { return tasks.getNumSubscribers() > 0; }));
  HumanTask task;
  task.person = "Ann";
  task.plan = {step("sweep", {"hall"}), step("sweep", {"kitchen"})};
  for (int round = 0; round < 2; ++round) {
    ros::WallDuration(0.5).sleep();  // what comes faster counts as a repeat
    std::uint32_t id = 0;
    for (const Question& question : questions.all())
      id = std::max(id, question.question_id);
    const std::size_t plans_before = plans.all().size();
    tasks.publish(task);
    for (int i = 0; i < 2; ++i) {
      const auto question =
          questions.waitFor([&](const Question& shown) { return shown.question_id > id; });
      ASSERT_TRUE(question);
      EXPECT_GT(question->header.stamp.sec, kThisCentury) << "a zero stamp counts as none";
      id = question->question_id;
      Answer call;
      call.request.question_id = id;
      call.request.answer = Answer::Request::NO;
      ASSERT_TRUE(callService("/goal_alignment/answer", call));
      EXPECT_TRUE(call.response.accepted) << call.response.message;
    }
    EXPECT_TRUE(eventually([&] { return plans.all().size() > plans_before; }));
    EXPECT_EQ(plans.last()->steps.size(), 2U);
    EXPECT_GT(plans.last()->header.stamp.sec, kThisCentury);
    EXPECT_TRUE(eventually([&] { return states.last()->phase == AlignmentState::DONE; }));
  }
  EXPECT_TRUE(diagnostics.waitFor([](const DiagnosticArray&) { return true; }));
  EXPECT_FALSE(hasClock());
}

class Robot {
 public:
  explicit Robot(const std::string& ns)
      : ns_(ns),
        questions_(node_, ns + "/goal_alignment/question"),
        states_(node_, ns + "/goal_alignment/state"),
        plans_(node_, ns + "/goal_alignment/plan"),
        align_(node_, ns + "/goal_alignment/align") {}

  bool isThere() {
    return eventually([this] { return align_.isServerConnected(); }) &&
           isOffered(ns_ + "/ask_human") && isOffered(ns_ + "/goal_alignment/answer") &&
           eventually([this] { return questions_.last().has_value(); });
  }

  // Ann asks the same of both; what she answered one of them is no answer to the other.
  void send() { align_.sendGoal(sweepBothRooms()); }

  AlignResult result() {
    EXPECT_TRUE(waitForEnd(align_));
    const auto result = align_.getResult();
    if (result) sessions_.insert(result->session_id);
    return result ? *result : AlignResult{};
  }

  std::uint32_t awaitQuestionAfter(std::uint32_t id) {
    const auto question =
        questions_.waitFor([&](const Question& shown) { return shown.question_id > id; });
    EXPECT_TRUE(question);
    return question ? question->question_id : 0;
  }

  Answer::Response answer(std::uint32_t id) {
    Answer call;
    call.request.question_id = id;
    call.request.answer = Answer::Request::YES;
    EXPECT_TRUE(callService(ns_ + "/goal_alignment/answer", call));
    return call.response;
  }

  std::uint32_t newestQuestion() const {
    std::uint32_t newest = 0;
    for (const Question& question : questions_.all())
      newest = std::max(newest, question.question_id);
    return newest;
  }

  std::multiset<std::uint32_t> questionIds() const {
    std::multiset<std::uint32_t> ids;
    for (const Question& question : questions_.all()) {
      if (question.question_id != 0) ids.insert(question.question_id);
    }
    return ids;
  }

  // Whether all that its topics carried is of its own sessions.
  bool spokeOnlyOfItsOwn() const {
    const auto own = [this](const auto& messages) {
      return std::all_of(messages.begin(), messages.end(), [this](const auto& message) {
        return message.session_id.empty() || sessions_.count(message.session_id) > 0;
      });
    };
    return own(questions_.all()) && own(states_.all()) && own(plans_.all());
  }

 private:
  ros::NodeHandle node_;
  const std::string ns_;
  Topic<Question> questions_;
  Topic<AlignmentState> states_;
  Topic<Plan> plans_;
  AlignClient align_;
  std::set<std::string> sessions_;
};

TEST(TwoRobots, areAlignedAtTheSameTimeAndNothingCrosses) {
  Robot a("/a");
  Robot b("/b");
  ASSERT_TRUE(a.isThere());
  ASSERT_TRUE(b.isThere());
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t before_a = a.newestQuestion();
    const std::uint32_t before_b = b.newestQuestion();
    a.send();
    b.send();
    const std::uint32_t of_a = a.awaitQuestionAfter(before_a);
    const std::uint32_t of_b = b.awaitQuestionAfter(before_b);
    // Whether it is open still or over: it is none of the other's.
    EXPECT_FALSE(b.answer(of_a).accepted);
    EXPECT_FALSE(a.answer(of_b).accepted);

    const AlignResult silent = a.result();
    EXPECT_EQ(silent.outcome, AlignResult::SUCCESS) << silent.message;
    EXPECT_EQ(textsOf(silent.plan.not_wanted),
              (std::vector<std::string>{"(quiet hall)", "(quiet kitchen)"}));
    const AlignResult loud = b.result();
    EXPECT_EQ(loud.outcome, AlignResult::EXPECTATION_UNACHIEVABLE) << loud.message;
    EXPECT_EQ(textsOf(loud.conflict), std::vector<std::string>{"(quiet kitchen)"});
    EXPECT_NE(silent.session_id, loud.session_id);
  }
  EXPECT_TRUE(a.spokeOnlyOfItsOwn());
  EXPECT_TRUE(b.spokeOnlyOfItsOwn());
  const auto ids_of_b = b.questionIds();
  for (const std::uint32_t id : a.questionIds())
    EXPECT_EQ(ids_of_b.count(id), 0U) << "both use one $ROS_HOME";
}

}  // namespace
}  // namespace goal_alignment::test
