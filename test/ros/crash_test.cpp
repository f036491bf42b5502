// SPDX-License-Identifier: BSD-3-Clause
// Processes that die at every moment, and the others that live on.
#include <csignal>
#include <future>
#include <thread>

#include "generated_tasks.h"
#include "goal_alignment/AskHuman.h"
#include "goal_alignment/ExecutePlanAction.h"
#include "own_aligner.h"

namespace goal_alignment::test {
namespace {

using State = actionlib::SimpleClientGoalState;

constexpr const char* kAsked = "I was asked";

class Crash : public OwnAligner {
 protected:
  void TearDown() override {
    OwnAligner::TearDown();
    dialogue_.reset();
    ros::param::del("/scripted_dialogue");
  }

  // The three ways to end a node that it hears of.
  std::vector<std::function<void()>> politeEnds() {
    return {[this] { aligner_->signal(SIGTERM); }, [this] { aligner_->signal(SIGINT); },
            [] { shutDownByName("/goal_alignment"); }};
  }

  void expectServed() {
    align_.sendGoal(sweepSilently());
    EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
    EXPECT_EQ(align_.getState(), State::SUCCEEDED);
  }

  void expectCanceledByShutdown() {
    const AlignResult result = awaitResult();
    EXPECT_EQ(result.outcome, AlignResult::CANCELED);
    EXPECT_EQ(result.message, "the node shuts down");
    EXPECT_EQ(result.failing_step, -1);
    EXPECT_EQ(align_.getState(), State::PREEMPTED);
  }

  void sendAndAwaitAnalysis(const AlignGoal& goal) {
    const auto before = states_.all().size();
    align_.sendGoal(goal);
    EXPECT_TRUE(eventually([&] {
      const auto now = states_.all();
      return now.size() > before && now.back().phase == AlignmentState::ANALYSING &&
             now.back().progress > 0.3;
    }));
  }

  // It says NO to everything.
  void startDialogue(double delay) {
    XmlRpc::XmlRpcValue nothing;
    nothing.setSize(0);
    ros::param::set("/scripted_dialogue/true_goal", nothing);
    ros::param::set("/scripted_dialogue/delay", delay);
    dialogue_ = start("scripted_dialogue");
    EXPECT_TRUE(isOffered("/ask_human"));
  }

  // It hears when a question is over.
  static bool dialogueListens() {
    return eventually([] {
      return reaches("/scripted_dialogue", "/goal_alignment", "/goal_alignment/question");
    });
  }

  std::unique_ptr<Program> start(const std::string& node) {
    return std::make_unique<Program>(NODE_FOLDER "/" + node, std::vector<std::string>{},
                                     std::map<std::string, std::string>{},
                                     home_.path() + "/" + node);
  }

  // Asks the dialogue as an aligner would. A future of std::async would wait for its answer.
  static std::future<AskHuman> ask(const Question& question) {
    std::packaged_task<AskHuman()> task([question] {
      AskHuman call;
      call.request.question = question;
      callService("/ask_human", call);
      return call;
    });
    auto answered = task.get_future();
    std::thread(std::move(task)).detach();
    return answered;
  }

  // Runs one of the tests below that only play a part, in a process that can be killed.
  std::unique_ptr<Program> startOther(const std::string& test) {
    return std::make_unique<Program>(
        "/proc/self/exe",
        std::vector<std::string>{"--gtest_also_run_disabled_tests", "--gtest_filter=" + test,
                                 "__name:=other"},
        std::map<std::string, std::string>{}, home_.path() + "/other");
  }

  std::string othersOutput() const { return textOf(home_.path() + "/other"); }

  std::unique_ptr<Program> dialogue_;
};

bool isReady(const std::future<AskHuman>& asker) {
  return asker.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

TEST_F(Crash, ofTheIdleAlignerLeavesClientsAbleToGoOn) {
  expectServed();
  killAligner();
  startAligner();
  expectServed();
}

TEST_F(Crash, ofTheAlignerThatAnalysesLeavesClientsAbleToGoOn) {
  sendAndAwaitAnalysis(longToAnalyse());
  killAligner();
  startAligner();
  EXPECT_TRUE(waitForEnd(align_));
  EXPECT_EQ(align_.getState(), State::LOST) << "the client learns that nobody works on its goal";
  expectServed();
}

TEST_F(Crash, ofTheAlignerWithAQuestionOpenMakesTheDialogueLeaveIt) {
  startDialogue(3600);
  ASSERT_TRUE(dialogueListens());
  const Question question = sendAndAwaitQuestion(sweepHall());
  auto asker = ask(question);
  killAligner();
  EXPECT_FALSE(isReady(asker));
  startAligner();
  ASSERT_TRUE(eventually([&] { return isReady(asker); })) << "a new aligner shows no question";
  EXPECT_EQ(int{asker.get().response.answer}, AskHuman::Response::NONE);
  EXPECT_TRUE(waitForEnd(align_));
  EXPECT_EQ(align_.getState(), State::LOST);

  const Question next = sendAndAwaitQuestion(sweepHall());
  EXPECT_GT(next.question_id, question.question_id);
  EXPECT_FALSE(answer(Answer::Request::NO, question.question_id).accepted) << "of the dead aligner";
  EXPECT_TRUE(answer(Answer::Request::NO, next.question_id).accepted);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

TEST_F(Crash, noneWhereTheIdleAlignerIsToldToEnd) {
  for (const auto& end : politeEnds()) {
    expectServed();
    end();
    EXPECT_EQ(awaitAlignersEnd(), 0);
    startAligner();
  }
}

TEST_F(Crash, noneWhereTheAlignerThatAnalysesIsToldToEnd) {
  for (const auto& end : politeEnds()) {
    sendAndAwaitAnalysis(longToAnalyse());
    end();
    expectCanceledByShutdown();
    EXPECT_EQ(awaitAlignersEnd(), 0);
    startAligner();
  }
  expectServed();
}

TEST_F(Crash, noneWhereTheAlignerIsToldToEndWithAQuestionOpen) {
  startDialogue(3600);
  for (const auto& end : politeEnds()) {
    ASSERT_TRUE(dialogueListens());
    const Question question = sendAndAwaitQuestion(sweepHall());
    auto asker = ask(question);
    end();
    expectCanceledByShutdown();
    EXPECT_EQ(awaitAlignersEnd(), 0) << "a dialogue that takes an hour does not hold it up";
    EXPECT_TRUE(questionIsClosed()) << "nobody shall go on thinking about it";
    ASSERT_TRUE(eventually([&] { return isReady(asker); }));
    EXPECT_EQ(int{asker.get().response.answer}, AskHuman::Response::NONE);
    startAligner();
  }
  expectServed();
}

TEST_F(Crash, ofTheDialogueMakesTheAlignerAskTheNextOne) {
  auto hanging = startOther("Other.DISABLED_dialogueThatHangs");
  ASSERT_TRUE(isOffered("/ask_human"));
  sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(eventually([this] { return othersOutput().find(kAsked) != std::string::npos; }));
  hanging->signal(SIGKILL);
  EXPECT_EQ(hanging->exitStatus(), 128 + SIGKILL);
  EXPECT_FALSE(align_.getState().isDone());
  startDialogue(0);
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_EQ(result.questions, 1U);
  for (const Candidate& candidate : result.candidates) {
    if (candidate.state != Candidate::NOT_WANTED) continue;
    EXPECT_EQ(candidate.answered_by, "scripted_dialogue");
  }
}

TEST_F(Crash, ofAClientWithAQuestionOpenLeavesTheQuestionToBeAnswered) {
  Topic<AlignActionResult> results(node_, "/goal_alignment/align/result");
  auto client = startOther("Other.DISABLED_clientThatWaits");
  const Question question = awaitQuestionAfter(0);
  client->signal(SIGKILL);
  EXPECT_EQ(client->exitStatus(), 128 + SIGKILL);
  EXPECT_TRUE(answer(Answer::Request::NO, question.question_id).accepted);
  EXPECT_TRUE(results.waitFor([](const AlignActionResult& result) {
    return result.result.outcome == AlignResult::SUCCESS;
  }));
  expectServed();
}

TEST_F(Crash, ofAClientLeavesTheNextClientToDisplaceItsGoal) {
  auto client = startOther("Other.DISABLED_clientThatWaits");
  awaitQuestionAfter(0);
  client->signal(SIGKILL);
  EXPECT_EQ(client->exitStatus(), 128 + SIGKILL);
  expectServed();
}

TEST_F(Crash, ofTheExecutorDoesNotTouchTheAligner) {
  auto executor = start("simulated_executor");
  ActionClient<ExecutePlanAction> execution(node_, "/execute_plan");
  ASSERT_TRUE(eventually([&] { return execution.isServerConnected(); }));
  const Question question = sendAndAwaitQuestion(sweepHall());
  executor->signal(SIGKILL);
  EXPECT_EQ(executor->exitStatus(), 128 + SIGKILL);
  EXPECT_TRUE(eventually([&] { return !execution.isServerConnected(); }));
  EXPECT_TRUE(answer(Answer::Request::NO, question.question_id).accepted);
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS);

  executor = start("simulated_executor");
  ASSERT_TRUE(eventually([] { return reachesUs("/simulated_executor", "/execute_plan/result"); }));
  ASSERT_TRUE(eventually([&] { return execution.isServerConnected(); }));
  ExecutePlanGoal goal;
  goal.plan = result.plan;
  execution.sendGoal(goal);
  ASSERT_TRUE(eventually([&] { return execution.getState().isDone(); }));
  EXPECT_EQ(execution.getResult()->outcome, ExecutePlanResult::SUCCESS);
  expectServed();
}

TEST(Other, DISABLED_clientThatWaits) {
  ros::NodeHandle node;
  AlignClient client(node, "/goal_alignment/align");
  ASSERT_TRUE(eventually([&] { return client.isServerConnected(); }));
  client.sendGoal(sweepHall());
  ros::waitForShutdown();
}

TEST(Other, DISABLED_dialogueThatHangs) {
  using Callback = boost::function<bool(AskHuman::Request&, AskHuman::Response&)>;
  const Callback hang = [](AskHuman::Request&, AskHuman::Response&) {
    std::cout << kAsked << std::endl;
    ros::waitForShutdown();
    return false;
  };
  const auto server =
      ros::NodeHandle().advertiseService<AskHuman::Request, AskHuman::Response>("/ask_human", hang);
  ros::waitForShutdown();
}

}  // namespace
}  // namespace goal_alignment::test
