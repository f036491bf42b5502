// SPDX-License-Identifier: BSD-3-Clause
// Facts from where things are, in a graph whose frames the scenarios move about.
#include <std_msgs/String.h>

#include "aligner_calls.h"
#include "frames.h"
#include "program.h"

namespace goal_alignment::test {
namespace {

constexpr int kNo = Answer::Request::NO;

// The hall lies from 0 to 4 along x, the kitchen from 4 to 8.
constexpr const char* kRooms = R"(
regions:
  hall: {box: {xyz: [2, 0, 0], size: [4, 4]}}
  kitchen: {box: {xyz: [6, 0, 0], size: [4, 4]}}
)";
constexpr double kHall = 2;
constexpr double kKitchen = 6;

std::string rulesFor(const std::string& frame, const std::string& more = "") {
  return "frames: {robot: " + frame + "}\n" + kRooms + R"(
rules:
  - fact: (at ?who ?room)
    when: ?who in ?room
    for: {who: robot, room: [hall, kitchen]}
    exactly_one: room
)" + more;
}

// On a loaded machine nobody may hear of a frame for longer than the 2 s of the default.
constexpr const char* kHowEverOld = "    max_age: 60\n";

std::string domain(const std::string& effect) {
  return R"((define (domain house)
  (:predicates (at ?who ?room) (next ?a ?b) (clean ?r) (quiet ?r))
  (:action go :parameters (?a ?b)
    :precondition (and (at robot ?a) (next ?a ?b))
    :effect (and (at robot ?b) (not (at robot ?a))))
  (:action sweep :parameters (?r)
    :precondition (at robot ?r)
    :effect (and (clean ?r))" +
         effect + R"())
  (:constants robot)))";
}

constexpr const char* kProblem = R"((define (problem p) (:domain house)
  (:objects hall kitchen)
  (:init (at robot hall) (next hall kitchen) (next kitchen hall) (quiet hall) (quiet kitchen))
  (:goal (clean hall))))";

// Sweep the hall; the problem file says that the robot is there.
AlignGoal sweepTheHall() {
  AlignGoal goal;
  goal.source = AlignGoal::TEXT;
  goal.robot_domain = goal.human_domain = domain("");
  goal.robot_problem = goal.human_problem = kProblem;
  goal.task.plan = {step("sweep", {"hall"})};
  goal.max_questions = -1;
  return goal;
}

// The same with a robot that is loud, so that there is a question.
AlignGoal sweepLoudly() {
  AlignGoal goal = sweepTheHall();
  goal.robot_domain = domain(" (not (quiet ?r))");
  return goal;
}

class TfFacts : public Scenario {
 protected:
  TfFacts() {
    static int number = 0;
    // tf remembers frames, so that each scenario has its own.
    robot_ = "base_link_" + std::to_string(++number);
    follow(rulesFor(robot_));
  }

  void follow(const std::string& rules) { writeText(file(), rules); }
  std::string file() const { return folder_.path() + "/rules.yaml"; }

  AlignResult align(const AlignGoal& goal, int outcome) {
    align_.sendGoal(goal);
    return expectEnd(outcome);
  }

  AlignResult resume(const AlignResult& before, int outcome) {
    AlignGoal goal;
    goal.continue_session = before.session_id;
    goal.max_questions = -1;
    return align(goal, outcome);
  }

  AlignResult expectEnd(int outcome) {
    AlignResult result = awaitResult();
    EXPECT_EQ(result.outcome, outcome) << result.message;
    return result;
  }

  static bool isSo(const std::string& text) {
    const auto told = getFacts();
    const auto texts = textsOf(told.facts);
    return told.known && std::count(texts.begin(), texts.end(), text) == 1;
  }

  static void expectSays(const std::string& message, const std::vector<std::string>& parts) {
    for (const std::string& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
  }

  TemporaryFolder folder_;
  std::string robot_;
  Frames frames_;
  const Parameter rules_{"tf_facts", file()};
  // A loaded machine may keep a transform waiting; what is to be missed is missed sooner.
  std::optional<Parameter> patience_{std::in_place, "tf_timeout", kPatience};
  const Parameter period_{"tf_period", 0.05};
};

TEST_F(TfFacts, sayWhereTheRobotIsWhateverTheProblemFileSays) {
  follow(rulesFor(robot_, kHowEverOld));
  frames_.place(robot_, kKitchen);
  const AlignResult far = align(sweepTheHall(), AlignResult::SUCCESS);
  ASSERT_EQ(far.plan.steps.size(), 2U);
  EXPECT_EQ(far.plan.steps[0].name, "go");
  EXPECT_TRUE(isSo("(at robot kitchen)"));
  EXPECT_FALSE(isSo("(at robot hall)"));
  EXPECT_TRUE(isSo("(quiet hall)")) << "the file still says all the rest";

  frames_.place(robot_, kHall);
  EXPECT_TRUE(eventually([] { return isSo("(at robot hall)"); })) << "without a goal, too";
  EXPECT_EQ(align(sweepTheHall(), AlignResult::SUCCESS).plan.steps.size(), 1U);
}

TEST_F(TfFacts, areLookedAtAnewWhenASessionGoesOn) {
  frames_.place(robot_, kHall);
  const AlignResult before = align(sweepTheHall(), AlignResult::SUCCESS);
  EXPECT_EQ(before.plan.steps.size(), 1U);
  frames_.place(robot_, kKitchen);
  EXPECT_TRUE(eventually([] { return isSo("(at robot kitchen)"); }));
  const AlignResult after = resume(before, AlignResult::SUCCESS);
  EXPECT_EQ(after.session_id, before.session_id);
  EXPECT_EQ(after.plan.steps.size(), 2U);
  EXPECT_EQ(after.questions, 0U);
}

TEST_F(TfFacts, areAwaitedWhenAGoalBegins) {
  align_.sendGoal(sweepTheHall());
  EXPECT_TRUE(states_.waitFor([&](const AlignmentState& state) {
    return state.message.find("waiting for tf: ") == 0 &&
           state.message.find(robot_) != std::string::npos;
  })) << currentState();
  frames_.place(robot_, kKitchen);
  EXPECT_EQ(expectEnd(AlignResult::SUCCESS).plan.steps.size(), 2U);
}

TEST_F(TfFacts, endAGoalWithTheFrameThatIsMissing) {
  patience_.emplace("tf_timeout", 0.3);
  const AlignResult result = align(sweepTheHall(), AlignResult::STATE_UNKNOWN);
  EXPECT_EQ(align_.getState(), actionlib::SimpleClientGoalState::ABORTED);
  expectSays(result.message, {"(at robot hall)", "frame " + robot_, "in map", "does not exist"});
  EXPECT_EQ(currentState().message, result.message);
  const auto told = getFacts();
  EXPECT_TRUE(told.known);
  EXPECT_EQ(textsOf(told.unknown),
            (std::vector<std::string>{"(at robot hall)", "(at robot kitchen)"}));
  EXPECT_FALSE(isSo("(at robot hall)"));
  expectSays(told.message, {robot_});

  patience_.emplace("tf_timeout", kPatience);
  frames_.place(robot_, kHall);
  resume(result, AlignResult::SUCCESS);
}

TEST_F(TfFacts, endAGoalWithTheAgeOfWhatIsOld) {
  patience_.emplace("tf_timeout", 0.3);
  const ros::Time old = ros::Time::now() - ros::Duration(5);
  std::string message;
  // The first goal may end before tf is heard at all.
  EXPECT_TRUE(eventually([&] {
    frames_.tellOnce(robot_, kHall, old);
    message = align(sweepTheHall(), AlignResult::STATE_UNKNOWN).message;
    return message.find("was last known") != std::string::npos;
  }));
  expectSays(message, {"frame " + robot_, " s ago, more than 2 s"});
}

TEST_F(TfFacts, endAGoalOfARobotThatIsInNoneOfTheRegions) {
  patience_.emplace("tf_timeout", 0.3);
  frames_.place(robot_, 11);
  std::string message;
  EXPECT_TRUE(eventually([&] {
    message = align(sweepTheHall(), AlignResult::STATE_UNKNOWN).message;
    return message.find("in none of hall, kitchen") != std::string::npos;
  })) << message;
  expectSays(message, {"the nearest, kitchen, is 3.00 m away"});
}

TEST_F(TfFacts, endAGoalWhoseFramesArePulledAwayAndGoOnWhenTheyAreBack) {
  patience_.emplace("tf_timeout", 3.0);  // longer than a loaded machine stands still
  frames_.place(robot_, kHall);
  const Question before = sendAndAwaitQuestion(sweepLoudly());
  frames_.pullAway(robot_);
  const AlignResult result = expectEnd(AlignResult::STATE_UNKNOWN);
  expectSays(result.message, {"(at robot hall)", "frame " + robot_, "was last known", "s ago"});
  EXPECT_TRUE(questionIsClosed());

  patience_.emplace("tf_timeout", kPatience);
  frames_.place(robot_, kKitchen);
  AlignGoal goal;
  goal.continue_session = result.session_id;
  goal.max_questions = -1;
  const Question again = sendAndAwaitQuestion(goal);
  EXPECT_EQ(textsOf(again.fluents), textsOf(before.fluents));
  EXPECT_TRUE(answer(kNo, again.question_id).accepted);
  EXPECT_EQ(expectEnd(AlignResult::SUCCESS).plan.steps.size(), 2U);
}

TEST_F(TfFacts, ofADropOutThatIsShortAreWaitedFor) {
  follow(rulesFor(robot_, "    max_age: 0.2\n"));
  frames_.place(robot_, kHall);
  const Question question = sendAndAwaitQuestion(sweepLoudly());
  frames_.pullAway(robot_);
  EXPECT_TRUE(eventually([] { return !getFacts().unknown.empty(); }));
  EXPECT_EQ(questions_.last()->question_id, question.question_id) << "the question stays";
  // No plan counts while it is not known where the robot is.
  EXPECT_TRUE(answer(kNo, question.question_id).accepted);
  EXPECT_TRUE(states_.waitFor([&](const AlignmentState& state) {
    return state.session_id == question.session_id && state.message.find("waiting for tf: ") == 0;
  }));
  frames_.place(robot_, kKitchen);
  EXPECT_EQ(expectEnd(AlignResult::SUCCESS).plan.steps.size(), 2U);
}

TEST_F(TfFacts, thatChangeLeaveAQuestionOpenThatStaysTheSame) {
  const Topic<std_msgs::String> events(node_, "/goal_alignment/events");
  EXPECT_TRUE(eventually([&] { return events.isHeard(); }));
  frames_.place(robot_, kHall);
  const Question question = sendAndAwaitQuestion(sweepLoudly());
  const auto changes = [&] {
    const auto all = events.all();
    return std::count_if(all.begin(), all.end(), [](const std_msgs::String& event) {
      return event.data.find("state has changed") != std::string::npos;
    });
  };
  const auto before = changes();
  frames_.place(robot_, kKitchen);
  EXPECT_TRUE(eventually([&] { return changes() > before; })) << "nobody noticed";
  EXPECT_TRUE(eventually([] {
    const AlignmentState state = currentState();
    return state.phase == AlignmentState::AWAITING_ANSWER;
  }));
  EXPECT_TRUE(answer(kNo, question.question_id).accepted) << "it is another question";
  EXPECT_EQ(
      questions_.last()->question_id == 0 || questions_.last()->question_id == question.question_id,
      true);
  EXPECT_EQ(expectEnd(AlignResult::SUCCESS).plan.steps.size(), 2U);
}

TEST_F(TfFacts, areCancelledWhileTheyAreAwaited) {
  align_.sendGoal(sweepTheHall());
  EXPECT_TRUE(states_.waitFor([&](const AlignmentState& state) {
    return state.message.find("waiting for tf: ") == 0 &&
           state.message.find(robot_) != std::string::npos;
  }));
  cancelKnownGoal(align_);
  expectEnd(AlignResult::CANCELED);
}

TEST_F(TfFacts, thatNobodyCanTellAreTakenFromTheFileWhereItIsTrusted) {
  follow(rulesFor(robot_, std::string(kHowEverOld) + "    unknown: trust_file\n"));
  EXPECT_EQ(align(sweepTheHall(), AlignResult::SUCCESS).plan.steps.size(), 1U);
  EXPECT_TRUE(isSo("(at robot hall)"));
  EXPECT_TRUE(getFacts().unknown.empty());
  EXPECT_TRUE(
      setFacts({fluent("at", {"robot", "kitchen"}), negated(fluent("at", {"robot", "hall"}))})
          .accepted);
  EXPECT_TRUE(isSo("(at robot kitchen)"));
  frames_.place(robot_, kHall);
  EXPECT_TRUE(eventually([] { return isSo("(at robot hall)"); }));
  EXPECT_FALSE(isSo("(at robot kitchen)"));
}

TEST_F(TfFacts, doNotFlickerOnABorder) {
  // (next kitchen kitchen) shows on which side of the border tf sees the robot.
  follow(rulesFor(robot_, std::string(kHowEverOld) +
                              "    margin: 0.5\n"
                              "  - {fact: (next kitchen kitchen), when: robot in kitchen, "
                              "margin: 0, max_age: 60}\n"));
  frames_.place(robot_, 3.9);
  align(sweepTheHall(), AlignResult::SUCCESS);
  const auto expectAfterMoveTo = [&](double x, const std::string& room) {
    frames_.place(robot_, x);
    EXPECT_TRUE(eventually([x] { return isSo("(next kitchen kitchen)") == (x >= 4); })) << x;
    EXPECT_TRUE(eventually([&] { return isSo("(at robot " + room + ")"); })) << x;
  };
  expectAfterMoveTo(4.3, "hall");
  expectAfterMoveTo(3.8, "hall");
  expectAfterMoveTo(4.6, "kitchen");
  expectAfterMoveTo(3.7, "kitchen");
  expectAfterMoveTo(4.1, "kitchen");
  expectAfterMoveTo(3.3, "hall");
}

TEST_F(TfFacts, cannotBeSet) {
  follow(rulesFor(robot_, kHowEverOld));
  frames_.place(robot_, kHall);
  const AlignResult before = align(sweepTheHall(), AlignResult::SUCCESS);
  const auto refused = setFacts({fluent("at", {"robot", "kitchen"})});
  EXPECT_FALSE(refused.accepted);
  expectSays(refused.message, {"(at robot kitchen) comes from tf", "rules.yaml:8:11"});
  const auto partly =
      setFacts({fluent("at", {"robot", "kitchen"}), negated(fluent("quiet", {"hall"}))});
  EXPECT_TRUE(partly.accepted);
  expectSays(partly.message, {"(at robot kitchen) comes from tf"});
  EXPECT_TRUE(isSo("(at robot hall)"));
  EXPECT_FALSE(isSo("(quiet hall)"));
}

TEST_F(TfFacts, ofRulesThatAreBrokenRefuseTheTaskAndNoOther) {
  follow(rulesFor(robot_, "    margin: wide\n"));
  AlignResult refused = align(sweepTheHall(), AlignResult::INVALID_MODEL);
  EXPECT_EQ(align_.getState(), actionlib::SimpleClientGoalState::REJECTED);
  expectSays(refused.message, {"~tf_facts", "rules.yaml:12:13: expected margin: metres", "'wide'"});
  follow(rulesFor(robot_, "  - {fact: (at ghost hall), when: robot in hall}\n"));
  refused = align(sweepTheHall(), AlignResult::INVALID_MODEL);
  expectSays(refused.message, {"rules.yaml:12:12", "can't have (at ghost hall)"});
  ros::param::set(rules_.name(), file() + ".not_there");
  refused = align(sweepTheHall(), AlignResult::INVALID_MODEL);
  expectSays(refused.message, {"~tf_facts", "not_there"});
  ros::param::set(rules_.name(), file());
  follow(rulesFor(robot_));
  frames_.place(robot_, kKitchen);
  const AlignResult good = align(sweepTheHall(), AlignResult::SUCCESS);
  EXPECT_EQ(good.plan.steps.size(), 2U);

  follow(rulesFor(robot_, "  - {fact: (at ghost hall), when: robot in hall}\n"));
  refused = resume(good, AlignResult::INVALID_MODEL);
  EXPECT_EQ(align_.getState(), actionlib::SimpleClientGoalState::REJECTED);
  follow(rulesFor(robot_));
  EXPECT_EQ(resume(good, AlignResult::SUCCESS).plan.steps.size(), 2U);
}

TEST_F(TfFacts, areForgottenWithTheirRules) {
  frames_.place(robot_, kKitchen);
  const AlignResult before = align(sweepTheHall(), AlignResult::SUCCESS);
  EXPECT_EQ(before.plan.steps.size(), 2U);
  const Parameter none("tf_facts", std::string());
  EXPECT_EQ(resume(before, AlignResult::SUCCESS).plan.steps.size(), 1U) << "as the file says";
  EXPECT_TRUE(isSo("(at robot hall)"));
}

class TfFactsInSimulatedTime : public TfFacts {};

// The clock stands still at 1000 s, and so do the ages.
TEST_F(TfFactsInSimulatedTime, areAsOldAsTheClockSays) {
  EXPECT_TRUE(eventually([] { return ros::Time::now() == ros::Time(1000); }));
  patience_.emplace("tf_timeout", 0.3);
  std::string message;
  EXPECT_TRUE(eventually([&] {
    frames_.tellOnce(robot_, kHall, ros::Time(940));
    message = align(sweepTheHall(), AlignResult::STATE_UNKNOWN).message;
    return message.find("was last known 60.0 s ago, more than 2 s") != std::string::npos;
  })) << message;
  patience_.emplace("tf_timeout", kPatience);
  frames_.place(robot_, kKitchen);
  EXPECT_EQ(align(sweepTheHall(), AlignResult::SUCCESS).plan.steps.size(), 2U);
  EXPECT_TRUE(isSo("(at robot kitchen)"));
}

}  // namespace
}  // namespace goal_alignment::test
