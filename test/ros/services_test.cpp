// SPDX-License-Identifier: BSD-3-Clause
// The services: what they say and refuse, that they agree with the topics, and that none of them
// waits for the solver.
#include <std_srvs/Trigger.h>

#include <atomic>
#include <map>
#include <random>
#include <set>
#include <thread>

#include "aligner_calls.h"
#include "generated_tasks.h"

namespace goal_alignment::test {
namespace {

constexpr int kNo = Answer::Request::NO;
constexpr int kYes = Answer::Request::YES;
constexpr int kWhyNot = Explain::Request::WHY_NOT;
constexpr int kWhatIf = Explain::Request::WHAT_IF;

using Texts = std::vector<std::string>;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Without what follows from the answers.
std::string reasonOf(const Question& question) {
  return question.why.substr(0, question.why.find(" If "));
}

class FreshAligner : public Scenario {};

class Services : public Scenario {
 protected:
  Question ask() { return last_ = awaitQuestionAfter(last_.question_id); }

  Question begin(const AlignGoal& goal) { return last_ = sendAndAwaitQuestion(goal); }

  // As soon as there are candidates the first search is under way.
  void sendAndAwaitAnalysis(const AlignGoal& goal) {
    align_.sendGoal(goal);
    EXPECT_TRUE(eventually([&] {
      const AlignmentState state = currentState();
      return state.phase == AlignmentState::ANALYSING && !state.candidates.empty();
    }));
  }

  void reply(const Question& question, int value) {
    const Answer::Response response = answer(value, question.question_id);
    EXPECT_TRUE(response.accepted) << response.message;
  }

  static void expectKnown(const Explain::Response& response, const std::string& part,
                          const std::vector<Texts>& conflicts) {
    EXPECT_TRUE(response.known);
    EXPECT_TRUE(contains(response.text, part)) << response.text;
    ASSERT_EQ(response.conflicts.size(), conflicts.size()) << response.text;
    for (std::size_t i = 0; i < conflicts.size(); ++i)
      EXPECT_EQ(textsOf(response.conflicts[i].fluents), conflicts[i]);
  }

  Question last_;
};

TEST_F(FreshAligner, hasNothingToExplainReviseForgetOrAnswer) {
  const auto nothing = explain({});
  EXPECT_FALSE(nothing.known);
  EXPECT_EQ(nothing.text, "No task was given yet.");
  EXPECT_FALSE(explain({"(quiet hall)"}).known);
  for (const int kind : {kWhyNot, kWhatIf})
    EXPECT_EQ(explain({"(quiet hall)"}, kind).text, "No task was given yet.");
  const auto facts = getFacts();
  EXPECT_FALSE(facts.known);
  EXPECT_TRUE(contains(facts.message, "no task was given yet")) << facts.message;
  EXPECT_TRUE(contains(facts.message, "~robot_domain names no file")) << facts.message;
  EXPECT_TRUE(facts.session_id.empty());
  EXPECT_EQ(answer(kNo).message, "no alignment is under way");
  EXPECT_FALSE(reviseAnswer(kNo, {"(quiet hall)"}).accepted);
  EXPECT_EQ(int{currentState().phase}, AlignmentState::IDLE);
  EXPECT_TRUE(currentState().session_id.empty());
  EXPECT_FALSE(callAligner<std_srvs::Trigger>("forget").success);
}

TEST_F(Services, explainWhyTheOpenQuestionIsAsked) {
  const Question question = begin(seatGuests(3));
  const auto why = explain({});
  expectKnown(why, question.why, {textsOf(question.conflict)});
  EXPECT_TRUE(why.conflicts.at(0).proven);
  reply(question, kNo);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  expectKnown(explain({}), "No question is open.", {});
}

TEST_F(Services, explainEveryKindOfFluent) {
  const Question first = begin(sweepBothRooms());
  const std::string open = textOf(first.fluents.at(0));
  const std::string other = open == "(quiet hall)" ? "(quiet kitchen)" : "(quiet hall)";
  expectKnown(explain({open}), reasonOf(first), {{open}});
  expectKnown(explain({"(clean hall)"}), "You asked that", {});
  expectKnown(explain({"(quiet cellar)"}), "You don't expect that \"quiet\" holds for cellar", {});
  expectKnown(explain({"(not (quiet hall))"}),
              "You don't expect that \"quiet\" does not hold for hall", {});
  reply(first, kNo);
  const Question second = ask();
  expectKnown(explain({open}), "answered no by test", {{open}});
  expectKnown(explain({other}), reasonOf(second), {{other}});
  expectKnown(explain({other, "(CLEAN Kitchen)"}), "You asked that", {{other}});
  reply(second, kYes);
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::EXPECTATION_UNACHIEVABLE);
  expectKnown(explain({}), reasonOf(second), {textsOf(result.conflict)});
  expectKnown(explain({other}), "answered yes by test", {{other}});
  expectKnown(explain({"(room hall)"}), "can't change what I do", {});
}

TEST_F(Services, explainWhyThereIsNoPlan) {
  reply(begin(seatGuests(3)), kYes);
  reply(ask(), kYes);
  EXPECT_EQ(awaitResult().outcome, AlignResult::EXPECTATION_UNACHIEVABLE);
  expectKnown(explain({}), "I can't have", {{"(seated g1)", "(seated g2)"}});
}

TEST_F(Services, explainWhySomethingIsNotAsked) {
  const Question first = begin(lightLamps());
  const std::string lamp = textOf(first.fluents.at(0));
  expectKnown(explain({lamp}, kWhyNot), "I do ask", {textsOf(first.conflict)});
  expectKnown(explain({"(checked)"}, kWhyNot), "you asked for it", {});
  expectKnown(explain({"(lit c1)"}, kWhyNot), "you don't expect it", {});
  for (const std::string& other : textsOf(first.conflict)) {
    if (other == lamp) continue;
    expectKnown(explain({other}, kWhyNot), "I have not asked yet", {textsOf(first.conflict)});
  }
  expectKnown(explain({}, kWhyNot), "Each step of your plan works for me.", {});
  reply(first, kNo);
  reply(ask(), kNo);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  expectKnown(explain({lamp}, kWhyNot), "answered no by test", {textsOf(first.conflict)});
  expectKnown(explain({"(pair a1 a2)"}, kWhyNot), "can't change what I do. My plan keeps it so.",
              {});
  expectKnown(explain({}, kWhyNot), "I chose another one", {});
}

TEST_F(Services, explainWhyTheHumanPlanIsNotFollowed) {
  const Question question = begin(seatGuests(3));
  const auto broken = explain({}, kWhyNot);
  expectKnown(broken, "Your plan does not work for me: ", {});
  EXPECT_TRUE(contains(broken.text, currentState().human_plan_break)) << broken.text;
  reply(question, kNo);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  align_.sendGoal(sweepSilently());
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  expectKnown(explain({}, kWhyNot), "I do follow your plan.", {});
}

TEST_F(Services, explainWhatWouldFollow) {
  const Question first = begin(lightLamps());
  const auto both = explain({"(lit A1)", "(lit a2)"}, kWhatIf);
  expectKnown(both, "I could not do it. I can't have both", {{"(lit a1)", "(lit a2)"}});
  EXPECT_TRUE(both.conflicts.at(0).proven);
  expectKnown(explain({"(not (lit a1))"}, kWhatIf), "If it did not matter that",
              {{"(lit b1)", "(lit b2)"}});
  expectKnown(explain({"(lit a1)", "(not (lit a2))", "(not (lit b1))"}, kWhatIf),
              "I would have a plan of 3 steps.", {});
  EXPECT_TRUE(contains(explain({"(not (checked))"}, kWhatIf).text, "You asked for this"));
  EXPECT_TRUE(contains(explain({"(lit c1)"}, kWhatIf).text, "You don't expect this"));
  EXPECT_FALSE(explain({"(lit a1)", "(not (lit a1))"}, kWhatIf).known);
  EXPECT_EQ(questions_.last()->question_id, first.question_id) << "it is still open";

  reply(first, kYes);
  const Question second = ask();
  const auto partner = textsOf(first.conflict);
  expectKnown(explain(partner, kWhatIf), "I could not do it.", {partner});
  reply(second, kYes);
  for (Question next; !align_.getState().isDone();) {
    const auto shown = questions_.last();
    if (shown && shown->question_id > std::max(second.question_id, next.question_id))
      reply(next = *shown, kYes);
    ros::WallDuration(0.01).sleep();
  }
  EXPECT_EQ(awaitResult().outcome, AlignResult::EXPECTATION_UNACHIEVABLE);
  expectKnown(explain({"(not (lit a1))", "(not (lit b1))"}, kWhatIf), "I would have a plan", {});
  expectKnown(explain({"(lit a1)", "(lit a2)"}, kWhatIf), "I could not do it.",
              {{"(lit a1)", "(lit a2)"}});
}

TEST_F(Services, suppositionsLeaveTheOpenQuestionAsItIs) {
  const Question question = begin(sweepRooms(4));
  // Each finds another conflict, so that the bound on what can follow may change.
  for (int i = 0; i < 6; ++i)
    EXPECT_TRUE(explain({"(room r0)"}, kWhatIf).known);
  EXPECT_EQ(questions_.last()->question_id, question.question_id);
  EXPECT_EQ(explain({}).text, question.why);
  reply(question, kNo);
  for (int i = 0; i < 3; ++i)
    reply(ask(), kNo);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

TEST_F(Services, suppositionsHoldUpNoAnswerNoCancelAndNoGoal) {
  std::atomic<bool> go_on{true};
  std::atomic<int> known{0};
  std::vector<std::thread> supposing;
  for (int i = 0; i < 3; ++i) {
    supposing.emplace_back([&] {
      while (go_on)
        known += explain({"(room r0)"}, kWhatIf).known ? 1 : 0;
    });
  }
  const auto talk = [this] {
    reply(begin(sweepRooms(3)), kNo);
    reply(ask(), kNo);
    reply(ask(), kNo);
    EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  };
  for (int i = 0; i < 5; ++i) {
    talk();
    begin(sweepRooms(2));
    cancelKnownGoal(align_);
    EXPECT_EQ(awaitResult().outcome, AlignResult::CANCELED);
  }
  EXPECT_TRUE(eventually([&] { return known > 20; })) << "after the last outcome it is idle";
  talk();
  go_on = false;
  for (std::thread& thread : supposing)
    thread.join();
}

TEST_F(Services, aSuppositionThatTakesLongIsNotKnownAndHoldsUpNoGoal) {
  sendAndAwaitAnalysis(longToAnalyse());
  EXPECT_TRUE(eventually([&] { return explain({}, kWhyNot).known; })) << "the search has begun";
  cancelKnownGoal(align_);
  EXPECT_EQ(awaitResult().outcome, AlignResult::CANCELED);
  const auto all = explain({"(at t3 c3)", "(at t4 c4)", "(at t5 c5)"}, kWhatIf);
  EXPECT_EQ(all.text, "Not known yet.");
  EXPECT_FALSE(all.known);

  std::atomic<bool> go_on{true};
  std::atomic<int> asked{0};
  std::vector<std::thread> supposing;
  for (int i = 0; i < 2; ++i) {
    supposing.emplace_back([&] {
      while (go_on) {
        EXPECT_FALSE(explain({"(at t3 c3)"}, kWhatIf).known);
        ++asked;
      }
    });
  }
  EXPECT_TRUE(eventually([&] { return asked > 2; }));
  align_.sendGoal(sweepSilently());
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  go_on = false;
  for (std::thread& thread : supposing)
    thread.join();
}

TEST_F(Services, explainRefusesWhatItCannotRead) {
  begin(sweepHall());
  const auto nothing = explain({}, kWhatIf);
  EXPECT_FALSE(nothing.known);
  EXPECT_TRUE(contains(nothing.text, "Name what is to be supposed")) << nothing.text;
  const auto unknown = explain({}, 9);
  EXPECT_FALSE(unknown.known);
  EXPECT_TRUE(contains(unknown.text, "9 is not a kind of explanation")) << unknown.text;
  const std::string control(3, '\x01');
  for (const std::string& rubbish :
       {std::string(), std::string("((("), std::string("quiet hall)"), control, std::string("()"),
        std::string("(quiet hall) (room hall)"), std::string(100000, '(')}) {
    for (const int kind : {int{Explain::Request::WHY}, kWhyNot, kWhatIf}) {
      const auto response = explain({"(quiet hall)", rubbish}, kind);
      EXPECT_FALSE(response.known) << rubbish.substr(0, 60);
      EXPECT_TRUE(contains(response.text, "fluents[1]")) << response.text.substr(0, 200);
      EXPECT_LT(response.text.size(), 1000U);
    }
  }
  reply(last_, kNo);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

TEST_F(Services, setFactsRefusesWhatCannotBeSoAndTakesNothingOfIt) {
  const Question question = begin(seatGuests(3));
  const Fluent fits = fluent("free", {"spare"});  // would make the question needless
  const auto expectRefused = [](const std::vector<Fluent>& facts, const std::string& part) {
    const auto response = setFacts(facts);
    EXPECT_FALSE(response.accepted);
    EXPECT_TRUE(contains(response.message, part)) << response.message;
  };
  expectRefused({}, "no fact");
  expectRefused({fits, fluent("flies", {"g0"})}, "facts[1]");
  expectRefused({fits, fits, fluent("free", {"c77"})}, "facts[2]");
  expectRefused({fluent("free", {}), fits}, "facts[0]");
  expectRefused({fluent("free", {"c0", "c1"})}, "facts[0]");
  expectRefused({fits, fluent("", {})}, "facts[1]");
  expectRefused({fits, fluent("free", {"c0)("})}, "facts[1]");
  expectRefused({fits, fluent("free", {"c0"}), negated(fluent("FREE", {"C0"}))}, "facts[2]");
  EXPECT_EQ(questions_.last()->question_id, question.question_id);
  reply(question, kNo);
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS);
  EXPECT_EQ(result.plan.steps.size(), 2U) << "the spare chair is as broken as it was";
}

TEST_F(Services, getFactsTellsTheRobotsStateDuringATaskAndAfterIt) {
  const Question question = begin(seatGuests(3));
  const auto has = [](const GetFacts::Response& told, const std::string& text) {
    const auto texts = textsOf(told.facts);
    return std::count(texts.begin(), texts.end(), text) == 1;
  };
  const auto before = getFacts();
  EXPECT_TRUE(before.known) << before.message;
  EXPECT_EQ(before.session_id, question.session_id);
  EXPECT_TRUE(before.unknown.empty());
  EXPECT_TRUE(has(before, "(free c0)"));
  EXPECT_FALSE(has(before, "(free spare)"));
  reply(question, kNo);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);

  EXPECT_TRUE(setFacts({fluent("free", {"SPARE"}), negated(fluent("free", {"c0"}))}).accepted);
  const auto after = getFacts();
  EXPECT_EQ(after.session_id, question.session_id);
  EXPECT_EQ(after.facts.size(), before.facts.size());
  EXPECT_TRUE(has(after, "(free spare)"));
  EXPECT_FALSE(has(after, "(free c0)"));
}

TEST_F(Services, validateReadsMegabytesWhileQuestionsAreAnswered) {
  const AlignGoal large = longToRead();
  ASSERT_GT(large.robot_problem.size(), 3000000U);
  std::atomic<bool> go_on{true};
  std::atomic<int> began{0};
  std::atomic<int> ended{0};
  std::thread validating([&] {
    while (go_on) {
      ++began;
      const auto response = validate(large.robot_domain, large.robot_problem);
      ++ended;
      EXPECT_TRUE(response.valid) << response.errors.at(0);
      EXPECT_FALSE(validate(large.robot_domain, large.robot_problem + ")").valid);
    }
  });
  EXPECT_TRUE(eventually(
      [&] {
        const int call = began;
        const bool under_way = ended == call - 1;
        reply(begin(sweepHall()), kNo);
        EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
        return under_way && ended == call - 1;
      },
      2 * kPatience))
      << "the question waited for the texts";
  go_on = false;
  validating.join();
}

TEST_F(Services, getStateIsTheLastStateOfTheTopic) {
  const auto expectSame = [this] {
    EXPECT_TRUE(eventually([this] {
      const auto shown = states_.last();
      return shown && *shown == currentState();
    })) << currentState();
  };
  expectSame();
  reply(begin(sweepRooms(3)), kNo);
  for (int i = 0; i < 2; ++i) {
    ask();
    expectSame();
    EXPECT_EQ(int{currentState().phase}, AlignmentState::AWAITING_ANSWER);
    reply(last_, kNo);
  }
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  expectSame();
  EXPECT_EQ(int{currentState().phase}, AlignmentState::DONE);
}

// What four threads of answerers were told.
class Flood {
 public:
  struct Accepted {
    int value = 0;
    std::string fluent;  // empty: all of the open question
  };

  // `values` are drawn from; fluents, ids and names are random, often senseless.
  Flood(std::vector<int> values, Texts fluents, std::uint32_t newest_id)
      : values_(std::move(values)), fluents_(std::move(fluents)), id_(newest_id) {}

  void run() {
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < 4; ++i)
      threads.emplace_back([this, i] { answer(i); });
    for (std::thread& thread : threads)
      thread.join();
  }

  /// A question is open.
  void show(std::uint32_t id) { id_ = id; }

  // By the name it was given under.
  const std::map<std::string, Accepted>& accepted() const { return accepted_; }

 private:
  void answer(unsigned number) {
    std::mt19937 random(number);
    const auto one_of = [&](const auto& all) { return all[random() % all.size()]; };
    for (int i = 0; i < 500; ++i) {
      Answer call;
      call.request.answer = static_cast<std::int8_t>(one_of(values_));
      const std::uint32_t id = id_;
      call.request.question_id =
          one_of(std::vector<std::uint32_t>{0, id, id, id - 1, id + 1, 4000000000U});
      if (random() % 2 == 0) call.request.fluents = {one_of(fluents_)};
      call.request.answered_by = std::to_string(number) + "-" + std::to_string(i);
      EXPECT_TRUE(callService("/goal_alignment/answer", call));
      EXPECT_EQ(call.response.accepted != 0, call.response.message.empty());
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!call.response.accepted) continue;
      accepted_[call.request.answered_by] = {
          call.request.answer, call.request.fluents.empty() ? "" : call.request.fluents[0]};
    }
  }

  const std::vector<int> values_;
  const Texts fluents_;
  std::atomic<std::uint32_t> id_;
  std::mutex mutex_;
  std::map<std::string, Accepted> accepted_;
};

constexpr int kRooms = 12;

// Some that are asked, some that may be volunteered, some that make no sense.
Texts floodFluents() {
  Texts fluents = {"(clean r0)", "(quiet cellar)", "(quiet r0 r1)",
                   "",           "rubbish",        "(not (quiet r0))"};
  for (int i = 0; i < kRooms; ++i) {
    fluents.push_back("(quiet r" + std::to_string(i) + ")");
    fluents.push_back("(Room R" + std::to_string(i) + ")");
  }
  return fluents;
}

void expectEachCountedOnce(const Flood& flood, const AlignResult& result) {
  std::size_t counted = 0;
  for (const Candidate& candidate : result.candidates) {
    const bool answered = candidate.state == Candidate::WANTED ||
                          candidate.state == Candidate::NOT_WANTED ||
                          candidate.state == Candidate::UNSURE;
    if (!answered) continue;
    ++counted;
    const auto found = flood.accepted().find(candidate.answered_by);
    ASSERT_NE(found, flood.accepted().end()) << candidate;
    const int states[] = {Candidate::NOT_WANTED, Candidate::WANTED, Candidate::UNSURE};
    EXPECT_EQ(int{candidate.state}, states[found->second.value]) << candidate;
  }
  EXPECT_EQ(counted, flood.accepted().size()) << "fluents answered and answers accepted";
}

TEST_F(Services, aFloodOfAnswersAnswersEveryQuestionOnce) {
  Flood flood({kNo, kNo, 4, 100, -1, -128}, floodFluents(), begin(sweepRooms(kRooms)).question_id);
  ros::Subscriber shown = node_.subscribe<Question>("/goal_alignment/question", 100,
                                                    [&](const Question::ConstPtr& question) {
                                                      if (question->question_id != 0)
                                                        flood.show(question->question_id);
                                                    });
  flood.run();
  // Should it have left any open:
  EXPECT_TRUE(eventually([&] {
    const auto open = questions_.last();
    if (open && open->question_id != 0) answer(kNo, open->question_id);
    return align_.getState().isDone();
  }));
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_GT(flood.accepted().size(), 0U);
  std::size_t not_wanted = 0;
  for (const Candidate& candidate : result.candidates)
    not_wanted += candidate.state == Candidate::NOT_WANTED && candidate.answered_by != "test";
  EXPECT_EQ(not_wanted, flood.accepted().size()) << "fluents answered and answers accepted";
  EXPECT_LE(result.questions, static_cast<std::uint32_t>(kRooms));
}

TEST_F(Services, aFloodOfAllValuesEndsOneDialogueAndHarmsNoOther) {
  Flood flood({kNo, kNo, kNo, kYes, Answer::Request::UNSURE, 7, -3}, floodFluents(),
              begin(sweepRooms(kRooms)).question_id);
  flood.run();
  EXPECT_TRUE(eventually([&] {
    const auto open = questions_.last();
    if (open && open->question_id != 0) cancelKnownGoal(align_);
    return align_.getState().isDone();
  }));
  expectEachCountedOnce(flood, awaitResult());

  Flood declining({kNo, Answer::Request::DECLINE}, floodFluents(),
                  begin(sweepRooms(kRooms)).question_id);
  declining.run();
  const auto& accepted = declining.accepted();
  bool is_declined = std::any_of(accepted.begin(), accepted.end(), [](const auto& entry) {
    return entry.second.value == Answer::Request::DECLINE;
  });
  EXPECT_TRUE(eventually([&] {
    const auto open = questions_.last();
    if (open && open->question_id != 0 &&
        answer(Answer::Request::DECLINE, open->question_id).accepted) {
      is_declined = true;
    }
    return align_.getState().isDone();
  }));
  // Else all was volunteered before.
  EXPECT_EQ(awaitResult().outcome, is_declined ? AlignResult::DECLINED : AlignResult::SUCCESS);
  reply(begin(sweepHall()), kNo);
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

TEST_F(Services, noneWaitsForABusySolver) {
  const Parameter all("conflicts", "full");
  const AlignGoal goal = longToAnalyse();
  sendAndAwaitAnalysis(goal);
  const std::string session = currentState().session_id;
  EXPECT_FALSE(explain({"(at t3 c3)"}).known) << "the search goes on";
  EXPECT_FALSE(explain({}).known);
  EXPECT_EQ(answer(kNo).message, "no question is open");
  EXPECT_TRUE(answer(kNo, 0, {"(tile t3)"}).accepted) << "volunteered";
  EXPECT_FALSE(answer(kNo, 0, {"(tile t3)"}).accepted) << "answered";
  EXPECT_FALSE(reviseAnswer(kNo, {"(at t1 c2)"}).accepted) << "specified";
  EXPECT_TRUE(reviseAnswer(kYes, {"(tile t3)"}).accepted);
  EXPECT_FALSE(setFacts({fluent("blank", {"c999"})}).accepted);
  EXPECT_TRUE(setFacts({fluent("blank", {"c0"})}).accepted);
  EXPECT_TRUE(getFacts().known);
  EXPECT_EQ(getFacts().session_id, session);
  EXPECT_TRUE(validate(goal.robot_domain, goal.robot_problem).valid);
  EXPECT_FALSE(explain({"(at t3 c3)"}, kWhyNot).known);
  const ros::WallTime asked = ros::WallTime::now();
  const auto supposed = explain({"(at t3 c3)"}, kWhatIf);
  EXPECT_FALSE(supposed.known);
  EXPECT_EQ(supposed.text, "Not known yet.");
  EXPECT_GT((ros::WallTime::now() - asked).toSec(), 1.9) << "it may become known";
  EXPECT_TRUE(callAligner<std_srvs::Trigger>("forget").success);
  // Explanations wait, so a pair of them must not hold up the others.
  std::vector<std::thread> explaining;
  for (int i = 0; i < 6; ++i)
    explaining.emplace_back([] { EXPECT_FALSE(explain({"(at t4 c4)"}).known); });
  for (int i = 0; i < 20; ++i)
    EXPECT_FALSE(answer(kNo).accepted);
  for (std::thread& thread : explaining)
    thread.join();
  const AlignmentState state = currentState();
  EXPECT_EQ(int{state.phase}, AlignmentState::ANALYSING) << "it was not busy for long enough";
  EXPECT_EQ(state.session_id, session);
  EXPECT_FALSE(align_.getState().isDone());
  cancelKnownGoal(align_);
  EXPECT_EQ(awaitResult().outcome, AlignResult::CANCELED);
}

}  // namespace
}  // namespace goal_alignment::test
