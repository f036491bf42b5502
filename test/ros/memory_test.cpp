// SPDX-License-Identifier: BSD-3-Clause
// What is remembered between tasks whose models come from parameters, and after a crash.
#include <std_srvs/Trigger.h>

#include <filesystem>

#include "aligner_calls.h"
#include "own_aligner.h"

namespace goal_alignment::test {
namespace {

namespace fs = std::filesystem;
using Texts = std::vector<std::string>;

class Memory : public OwnAligner {
 protected:
  void SetUp() override {
    writeText(problemFile(), textOf(model("one_room.pddl")));
    OwnAligner::SetUp();
  }

  std::string problemFile() const { return home_.path() + "/robot_problem.pddl"; }

  void restart() {
    killAligner();
    startAligner();
    ASSERT_TRUE(isOffered("/goal_alignment/get_facts"));
  }

  // The robot makes a noise, which the person does not know.
  static AlignGoal sweep() {
    AlignGoal goal;
    goal.task.task_id = "sweep";
    goal.task.person = "Ann";
    goal.task.plan = {step("sweep", {"hall"})};
    goal.max_questions = -1;
    return goal;
  }

  // As an executor reports it when the hall is swept.
  static void reportSwept() {
    EXPECT_TRUE(setFacts({fluent("clean", {"hall"}), negated(fluent("quiet", {"hall"}))}).accepted);
  }

  static SetFacts::Response setHumanFacts(const std::vector<Fluent>& facts) {
    SetFacts::Request request;
    request.facts = facts;
    return callAligner<SetFacts>("set_human_facts", request);
  }

  // Whether the person is asked about the silence: whether they believe that it is there.
  bool asksAboutSilence(const AlignGoal& goal = sweep()) {
    const auto asked = [this] {
      std::uint32_t newest = 0;
      for (const Question& question : questions_.all())
        newest = std::max(newest, question.question_id);
      return newest;
    };
    const std::uint32_t before = asked();
    align_.sendGoal(goal);
    EXPECT_TRUE(eventually([&] { return align_.getState().isDone() || asked() > before; }));
    if (!align_.getState().isDone()) answer(Answer::Request::NO, asked());
    const AlignResult result = awaitResult();
    EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
    return result.questions > 0;
  }

  bool wasWarned(const std::string& text) {
    return eventually([&] { return alignersOutput().find(text) != std::string::npos; });
  }

  std::size_t factFiles(const std::string& extension) const {
    std::size_t count = 0;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(home_.path() + "/goal_alignment/facts", none))
      count += entry.path().extension() == extension ? 1 : 0;
    return count;
  }

  const Parameter robot_domain_{"robot_domain", model("robot_domain.pddl")};
  const Parameter human_domain_{"human_domain", model("human_domain.pddl")};
  const Parameter robot_problem_{"robot_problem", problemFile()};
  const Parameter human_problem_{"human_problem", model("one_room.pddl")};
};

TEST_F(Memory, thePersonKnowsWhatWasCarriedOut) {
  EXPECT_TRUE(asksAboutSilence());
  EXPECT_TRUE(asksAboutSilence()) << "nobody has swept yet";
  reportSwept();
  EXPECT_FALSE(asksAboutSilence());
  {
    const Parameter follows("human_state_follows", false);
    EXPECT_TRUE(asksAboutSilence());
  }
  AlignGoal own_models = sweepHall();
  EXPECT_TRUE(asksAboutSilence(own_models)) << "it says itself what is so";
  EXPECT_FALSE(asksAboutSilence());
}

TEST_F(Memory, whatThePersonIsToldCounts) {
  reportSwept();
  EXPECT_TRUE(setHumanFacts({fluent("quiet", {"hall"})}).accepted);
  // The robot knows better, so there is nothing that it could spoil.
  EXPECT_EQ(textsOf(getFacts().facts), (Texts{"(clean hall)", "(room hall)"}));
  align_.sendGoal(sweep());
  const Question question = awaitQuestionAfter(0);
  EXPECT_EQ(textsOf(question.fluents), Texts{"(quiet hall)"});
  EXPECT_TRUE(answer(Answer::Request::NO, question.question_id).accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);

  const auto refused = setHumanFacts({fluent("quiet", {"hall"}), fluent("quiet", {"cellar"})});
  EXPECT_FALSE(refused.accepted);
  EXPECT_NE(refused.message.find("facts[1]: the person's model"), std::string::npos)
      << refused.message;
}

TEST_F(Memory, factsSurviveACrashWithALine) {
  reportSwept();
  EXPECT_TRUE(setHumanFacts({fluent("clean", {"hall"})}).accepted);
  EXPECT_EQ(factFiles(".json"), 1U);
  restart();
  EXPECT_TRUE(events_.waitFor([](const std_msgs::String& line) {
    return line.data.find("facts from before the restart (2 of the robot's world, 1 of what") == 0;
  }));
  const GetFacts::Response before_any_task = getFacts();
  EXPECT_TRUE(before_any_task.known);
  EXPECT_EQ(before_any_task.session_id, "");
  EXPECT_EQ(textsOf(before_any_task.facts), (Texts{"(clean hall)", "(room hall)"}));
  EXPECT_FALSE(asksAboutSilence());
  EXPECT_EQ(textsOf(getFacts().facts), (Texts{"(clean hall)", "(room hall)"}));
}

TEST_F(Memory, factsAreTakenBeforeTheFirstTask) {
  EXPECT_TRUE(setFacts({negated(fluent("quiet", {"hall"})), fluent("dark", {"hall"})}).accepted);
  EXPECT_EQ(textsOf(getFacts().facts), Texts{"(room hall)"});
  EXPECT_FALSE(asksAboutSilence());
  EXPECT_TRUE(events_.waitFor([](const std_msgs::String& line) {
    return line.data.find("a fact is left out") == 0 &&
           line.data.find("\"dark\" holds for hall") != std::string::npos;
  }));
}

TEST_F(Memory, aProblemFileThatHasChangedSaysAnewWhatIsSo) {
  reportSwept();
  killAligner();
  writeText(problemFile(), textOf(model("one_room.pddl")) + "; mended\n");
  startAligner();
  EXPECT_TRUE(wasWarned("are left out, since these have changed: robot_problem"));
  EXPECT_EQ(textsOf(getFacts().facts), (Texts{"(quiet hall)", "(room hall)"}));
  EXPECT_TRUE(asksAboutSilence());
}

TEST_F(Memory, withoutFactsExpiryOrInAnotherWorldNothingIsTakenUp) {
  reportSwept();
  const Texts as_in_the_file = {"(quiet hall)", "(room hall)"};
  {
    const Parameter off("facts_expiry", 0.0);
    restart();
    EXPECT_EQ(textsOf(getFacts().facts), as_in_the_file);
  }
  {
    const Parameter world("world", std::string("another"));
    restart();
    EXPECT_EQ(textsOf(getFacts().facts), as_in_the_file);
  }
  restart();
  EXPECT_NE(textsOf(getFacts().facts), as_in_the_file) << "they are there still";
}

TEST_F(Memory, aDamagedFileOfFactsIsSetAside) {
  reportSwept();
  killAligner();
  writeText(home_.path() + "/goal_alignment/facts/goal_alignment.json", "{\"version\":");
  startAligner();
  EXPECT_TRUE(wasWarned("is damaged and set aside as"));
  EXPECT_EQ(factFiles(".damaged"), 1U);
  EXPECT_EQ(textsOf(getFacts().facts), (Texts{"(quiet hall)", "(room hall)"}));
}

TEST_F(Memory, forgetFactsLeavesWhatTheFilesSay) {
  reportSwept();
  EXPECT_FALSE(asksAboutSilence());
  const auto forgotten = callAligner<std_srvs::Trigger>("forget_facts");
  EXPECT_TRUE(forgotten.success);
  EXPECT_EQ(forgotten.message.find("all facts that were set are forgotten (2)"), 0U)
      << forgotten.message;
  EXPECT_EQ(factFiles(".json"), 0U);
  EXPECT_EQ(textsOf(getFacts().facts), (Texts{"(quiet hall)", "(room hall)"}));
  EXPECT_TRUE(asksAboutSilence());
}

TEST_F(Memory, aTaskThatWasUnderWayInACrashIsToldOf) {
  const Question question = sendAndAwaitQuestion(sweep());
  restart();
  const auto lost = states_.waitFor([&](const AlignmentState& state) {
    return state.session_id == question.session_id && state.phase == AlignmentState::DONE;
  });
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->outcome, AlignResult::CANCELED);
  EXPECT_EQ(lost->task_id, "sweep");
  EXPECT_EQ(lost->person, "Ann");
  const std::string said =
      "the aligner was restarted while the task sweep of Ann was under way: send it again to "
      "continue";
  EXPECT_EQ(lost->message, said);
  EXPECT_TRUE(events_.waitFor([&](const std_msgs::String& line) { return line.data == said; }));
  EXPECT_TRUE(waitForEnd(align_));
  EXPECT_EQ(align_.getState(), actionlib::SimpleClientGoalState::LOST);

  EXPECT_TRUE(asksAboutSilence()) << "it is served";
  restart();
  EXPECT_EQ(int{currentState().phase}, AlignmentState::IDLE) << "that one had ended";
}

}  // namespace
}  // namespace goal_alignment::test
