// SPDX-License-Identifier: BSD-3-Clause
// Where a task's models may come from, how large they may be, and what is refused. After every
// refusal the next goal is served.
#include <std_msgs/String.h>
#include <sys/stat.h>

#include <map>
#include <random>

#include "aligner_calls.h"
#include "own_aligner.h"

namespace goal_alignment::test {
namespace {

using State = actionlib::SimpleClientGoalState;
using XmlRpc::XmlRpcValue;

AlignGoal asText(AlignGoal goal) {
  goal.source = AlignGoal::TEXT;
  for (std::string* model :
       {&goal.robot_domain, &goal.robot_problem, &goal.human_domain, &goal.human_problem}) {
    *model = textOf(*model);
  }
  return goal;
}

// Always the same ones, and never the byte that begins PDDL.
std::string rubbish(std::size_t bytes) {
  std::mt19937 random(1);
  std::string text;
  while (text.size() < bytes) {
    const char byte = static_cast<char>(random() % 256);
    if (byte != '(' && byte != ';') text += byte;
  }
  return text;
}

class Input : public Scenario {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    writeText(pathOf(name), text);
    return pathOf(name);
  }

  std::string pathOf(const std::string& name) const { return folder_.path() + "/" + name; }

  AlignResult expectRefused(const AlignGoal& goal, int outcome = AlignResult::INVALID_MODEL) {
    align_.sendGoal(goal);
    const AlignResult result = awaitResult();
    EXPECT_EQ(result.outcome, outcome) << result.message;
    const auto state = align_.getState();
    EXPECT_TRUE(state == State::REJECTED || state == State::ABORTED) << state.toString();
    expectServed();
    return result;
  }

  void expectServed() {
    align_.sendGoal(sweepSilently());
    EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  }

  // Every question is answered NO.
  AlignResult align(const AlignGoal& goal, Question& question) {
    question = sendAndAwaitQuestion(goal);
    EXPECT_TRUE(answer(Answer::Request::NO, question.question_id).accepted);
    return awaitResult();
  }

  const TemporaryFolder folder_;
};

TEST_F(Input, parametersFilesAndTextGiveTheSameResult) {
  const AlignGoal files = sweepHall();
  const Parameter robot_domain("robot_domain", files.robot_domain);
  const Parameter robot_problem("robot_problem", files.robot_problem);
  const Parameter human_domain("human_domain", files.human_domain);
  const Parameter human_problem("human_problem", files.human_problem);
  AlignGoal parameters = files;
  parameters.source = AlignGoal::PARAMS;
  for (std::string* unused : {&parameters.robot_domain, &parameters.robot_problem,
                              &parameters.human_domain, &parameters.human_problem}) {
    unused->clear();
  }

  Question expected_question;
  const AlignResult expected = align(files, expected_question);
  ASSERT_EQ(expected.outcome, AlignResult::SUCCESS) << expected.message;
  for (const AlignGoal& goal : {parameters, asText(files)}) {
    Question question;
    const AlignResult result = align(goal, question);
    EXPECT_EQ(question.text, expected_question.text);
    EXPECT_EQ(question.why, expected_question.why);
    EXPECT_EQ(question.probabilities, expected_question.probabilities);
    EXPECT_EQ(result.outcome, expected.outcome);
    EXPECT_EQ(result.message, expected.message);
    EXPECT_EQ(result.questions, expected.questions);
    EXPECT_EQ(result.planner_calls, expected.planner_calls);
    EXPECT_EQ(textsOf(result.plan.guaranteed), textsOf(expected.plan.guaranteed));
    EXPECT_EQ(textsOf(result.plan.kept_unasked), textsOf(expected.plan.kept_unasked));
    EXPECT_EQ(textsOf(result.plan.not_wanted), textsOf(expected.plan.not_wanted));
    ASSERT_EQ(result.plan.steps.size(), expected.plan.steps.size());
    for (std::size_t i = 0; i < result.plan.steps.size(); ++i)
      EXPECT_EQ(result.plan.steps[i].name, expected.plan.steps[i].name);
    ASSERT_EQ(result.candidates.size(), expected.candidates.size());
    for (std::size_t i = 0; i < result.candidates.size(); ++i) {
      EXPECT_EQ(textOf(result.candidates[i].fluent), textOf(expected.candidates[i].fluent));
      EXPECT_EQ(int{result.candidates[i].state}, int{expected.candidates[i].state});
      EXPECT_EQ(result.candidates[i].probability, expected.candidates[i].probability);
    }
  }
}

TEST_F(Input, megabytesOfTextAndStepsAreServed) {
  AlignGoal goal = asText(sweepHall());
  const std::string comment = "; the quick brown fox jumps over the lazy dog\n";
  for (int i = 0; i < 40000; ++i)
    goal.human_domain += comment;
  std::string things;
  for (int i = 0; i < 100000; ++i)
    things += " thing-" + std::to_string(i) + (i % 10 == 0 ? "\n" : "");
  goal.robot_problem.insert(goal.robot_problem.find("hall"), things + " ");
  ASSERT_GT(goal.human_domain.size() + goal.robot_problem.size(), 3000000U);
  goal.task.plan.assign(20000, step("sweep", {"hall"}));

  Question question;
  const AlignResult result = align(goal, question);
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_EQ(result.plan.steps.size(), 20000U) << "the person's own plan is the one to prefer";
}

TEST_F(Input, whatIsNoRegularFileIsNotWaitedFor) {
  const std::string fifo = pathOf("fifo");
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  for (const std::string& file :
       {std::string("/dev/zero"), fifo, folder_.path(), pathOf("nowhere.pddl")}) {
    AlignGoal goal = sweepHall();
    goal.robot_problem = file;
    const std::string message = expectRefused(goal).message;
    EXPECT_NE(message.find(file), std::string::npos) << message;
  }
}

TEST_F(Input, aParameterThatNamesNoFileIsRefused) {
  AlignGoal goal = sweepHall();
  goal.source = AlignGoal::PARAMS;
  EXPECT_NE(expectRefused(goal).message.find("~robot_domain"), std::string::npos);
  const Parameter domain("robot_domain", std::string("/dev/zero"));
  EXPECT_NE(expectRefused(goal).message.find("/dev/zero"), std::string::npos);
}

TEST_F(Input, rubbishIsRefusedInEveryField) {
  const std::string file = write("rubbish.pddl", rubbish(100000));
  const AlignGoal text = asText(sweepHall());
  for (const auto field : {&AlignGoal::robot_domain, &AlignGoal::robot_problem,
                           &AlignGoal::human_domain, &AlignGoal::human_problem}) {
    AlignGoal goal = sweepHall();
    goal.*field = file;
    EXPECT_NE(expectRefused(goal).message.find(file + ":1:"), std::string::npos);
    goal = text;
    goal.*field = "";
    expectRefused(goal);
    goal.*field = "no PDDL, but a sentence.";
    expectRefused(goal);
  }
}

TEST_F(Input, aByteOfZerosInAFileOrATextIsRefused) {
  std::string domain = textOf(sweepHall().robot_domain);
  domain.insert(domain.find("(clean ?r)"), std::string(3, '\0'));
  AlignGoal goal = sweepHall();
  goal.robot_domain = write("zeros.pddl", domain);
  EXPECT_NE(expectRefused(goal).message.find("zeros.pddl:5:"), std::string::npos);
  goal = asText(sweepHall());
  goal.robot_domain = domain;
  EXPECT_EQ(expectRefused(goal).message.find("robot_domain:5:"), 0U);
}

TEST_F(Input, whatTheTaskNamesMustFitThePersonsModel) {
  const auto withGoal = [](const Fluent& wanted) {
    AlignGoal goal = sweepHall();
    goal.task.goal = {wanted};
    return goal;
  };
  EXPECT_NE(expectRefused(withGoal(fluent("polished", {"hall"}))).message.find("polished"),
            std::string::npos);
  EXPECT_NE(expectRefused(withGoal(fluent("clean", {"hall", "hall"}))).message.find("clean"),
            std::string::npos);
  expectRefused(withGoal(fluent("clean", {})));

  AlignGoal plan = sweepHall();
  plan.task.plan = {step("sweep", {"hall"}), step("sweep", {"hall", "hall"})};
  EXPECT_EQ(expectRefused(plan, AlignResult::HUMAN_PLAN_INVALID).failing_step, 1);
  plan.task.plan = {step("sweep", {})};
  EXPECT_EQ(expectRefused(plan, AlignResult::HUMAN_PLAN_INVALID).failing_step, 0);
}

TEST_F(Input, goalsThatDifferAreRefusedUnlessTheTaskSaysWhich) {
  AlignGoal goal = asText(sweepHall());
  const std::string asked = "(:goal (clean hall))";
  goal.robot_problem.replace(goal.robot_problem.find(asked), asked.size(), "(:goal (quiet hall))");
  const std::string message = expectRefused(goal).message;
  EXPECT_NE(message.find("robot_problem"), std::string::npos) << message;
  EXPECT_NE(message.find("human_problem"), std::string::npos) << message;

  goal.task.goal = {fluent("clean", {"hall"})};
  Question question;
  EXPECT_EQ(align(goal, question).outcome, AlignResult::SUCCESS);
}

TEST_F(Input, anEmptyPlanMeansThatThePersonWantsWhatIsSoNow) {
  AlignGoal goal = sweepHall();
  goal.task.goal = {fluent("quiet", {"hall"})};
  goal.task.plan.clear();
  align_.sendGoal(goal);
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_EQ(result.questions, 0U);
  EXPECT_EQ(textsOf(result.plan.kept_unasked), std::vector<std::string>{"(room hall)"});
  expectRefused(
      [] {
        AlignGoal missed = sweepHall();
        missed.task.plan.clear();
        return missed;
      }(),
      AlignResult::GOAL_NOT_EXPECTED);
}

TEST_F(Input, aGoalThatIsTrueAlreadyGivesAnEmptyPlan) {
  AlignGoal goal = sweepHall();
  goal.task.goal = {fluent("quiet", {"hall"})};  // and the plan sweeps
  Question question;
  const AlignResult result = align(goal, question);
  EXPECT_EQ(textsOf(question.fluents), std::vector<std::string>{"(clean hall)"});
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_TRUE(result.plan.steps.empty());
  EXPECT_GT(result.plan.plan_id, 0);
  EXPECT_EQ(result.plan.session_id, result.session_id);
}

TEST_F(Input, parametersOfTheWrongTypeAreNamedWithTheirNamespace) {
  XmlRpcValue list;
  list[0] = 1;
  const std::map<std::string, XmlRpcValue> wrong = {{"robot_domain", XmlRpcValue(3)},
                                                    {"robot_problem", XmlRpcValue(true)},
                                                    {"human_domain", list},
                                                    {"human_problem", XmlRpcValue(1.5)},
                                                    {"phrases", XmlRpcValue(7)},
                                                    {"policy", XmlRpcValue(1)},
                                                    {"seed", XmlRpcValue("many")},
                                                    {"belief", XmlRpcValue(0.5)},
                                                    {"beta", XmlRpcValue("one")},
                                                    {"kappa", list},
                                                    {"conflicts", XmlRpcValue(true)},
                                                    {"unsure_policy", XmlRpcValue(2)},
                                                    {"plan", XmlRpcValue(false)},
                                                    {"costs", XmlRpcValue("yes")},
                                                    {"static_candidates", XmlRpcValue(1)},
                                                    {"time_limit", XmlRpcValue("long")},
                                                    {"memory_limit", XmlRpcValue(512.5)},
                                                    {"max_questions", XmlRpcValue(2.5)},
                                                    {"ask_timeout", XmlRpcValue(true)},
                                                    {"ask_retries", XmlRpcValue(0.5)},
                                                    {"journal_expiry", XmlRpcValue("a week")},
                                                    {"diagnostic_period", XmlRpcValue("often")}};
  for (const auto& [key, value] : wrong) {
    XmlRpcValue before;
    const bool was_set = ros::param::get("/goal_alignment/" + key, before);
    AlignResult result;
    {
      const Parameter parameter(key, value);
      align_.sendGoal(sweepSilently());
      result = awaitResult();
      EXPECT_EQ(result.outcome, AlignResult::INVALID_MODEL) << key;
      EXPECT_EQ(align_.getState(), State::REJECTED) << key;
      EXPECT_NE(result.message.find(parameter.name()), std::string::npos) << result.message;
      EXPECT_NE(result.message.find("expected"), std::string::npos) << result.message;
    }
    if (was_set) ros::param::set("/goal_alignment/" + key, before);
    expectServed();
  }
}

TEST_F(Input, brokenPhrasesAreToldAndTheTaskGoesOn) {
  Topic<std_msgs::String> events(node_, "/goal_alignment/events");
  ASSERT_TRUE(eventually([] { return reachesUs("/goal_alignment", "/goal_alignment/events"); }));
  Question expected;
  align(sweepHall(), expected);
  const std::string yaml = write("broken.yaml", "predicates: {clean: \"{0} is clean\n");
  const std::string shape = write("shape.yaml", "predicates: [1, 2]\n");
  const std::string random = write("rubbish.yaml", rubbish(5000));
  for (const std::string& file :
       {yaml, shape, random, std::string("/dev/zero"), pathOf("nowhere.yaml"), folder_.path()}) {
    const Parameter phrases("phrases", file);
    Question question;
    EXPECT_EQ(align(sweepHall(), question).outcome, AlignResult::SUCCESS) << file;
    EXPECT_EQ(question.text, expected.text);
    EXPECT_TRUE(events.waitFor([&](const std_msgs::String& line) {
      return line.data.find("no phrases: ") == 0 && line.data.find(file) != std::string::npos;
    })) << file;
  }
}

}  // namespace
}  // namespace goal_alignment::test
