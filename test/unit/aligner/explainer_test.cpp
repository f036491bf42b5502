// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/explainer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace goal_alignment::aligner {
namespace {

// (g) is asked for; whether something speaks against (e) is not known yet.
ExplanationContext sample() {
  ExplanationContext explained;
  explained.snapshot.state = session::State::AwaitingAnswer;
  explained.snapshot.specified = {Literal::parse("(g)")};
  session::CandidateView view;
  view.fluent = Literal::parse("(e)");
  explained.snapshot.candidates.push_back(view);
  return explained;
}

Explain::Request request(const std::vector<std::string>& fluents,
                         int kind = Explain::Request::WHY) {
  Explain::Request request;
  request.kind = static_cast<std::uint8_t>(kind);
  request.fluents = fluents;
  return request;
}

bool says(const Explain::Response& response, const std::string& text) {
  return response.text.find(text) != std::string::npos;
}

constexpr int kWhy = Explain::Request::WHY;
constexpr int kWhatIf = Explain::Request::WHAT_IF;
constexpr int kWhyNot = Explain::Request::WHY_NOT;
constexpr std::chrono::duration<double> kNone{0};
constexpr std::chrono::duration<double> kLong{60};

TEST(Explainer, refusesWhatItCannotRead) {
  Explainer explainer;
  explainer.show(sample());
  for (const int kind : {kWhy, kWhyNot, kWhatIf})
    EXPECT_FALSE(explainer.explain(request({"(((("}, kind), kLong).known);
  EXPECT_TRUE(says(explainer.explain(request({}, 9), kLong), "expected WHY=0"));
}

TEST(Explainer, doesNotWaitForATask) {
  for (const int kind : {kWhy, kWhyNot, kWhatIf})
    EXPECT_EQ(Explainer().explain(request({"(e)"}, kind), kLong).text, "No task was given yet.");
}

TEST(Explainer, waitsForTheReasonToComeUp) {
  for (const int kind : {kWhy, kWhyNot}) {
    Explainer explainer;
    ExplanationContext explained = sample();
    explainer.show(explained);
    EXPECT_FALSE(explainer.explain(request({"(e)"}, kind), kNone).known);
    std::thread solver([&] {
      explainer.show(explained);  // nothing new
      explained.snapshot.conflicts_complete = true;
      explainer.show(explained);
    });
    EXPECT_TRUE(explainer.explain(request({"(E)"}, kind), kLong).known);
    solver.join();
  }
}

TEST(Explainer, refusesAtOnceWhatCannotBeSupposed) {
  Explainer explainer;
  explainer.show(sample());
  EXPECT_TRUE(says(explainer.explain(request({}, kWhatIf), kLong), "Name what is to be supposed"));
  EXPECT_TRUE(says(explainer.explain(request({"(z)"}, kWhatIf), kLong), "You don't expect this"));
  EXPECT_TRUE(
      says(explainer.explain(request({"(not (g))"}, kWhatIf), kLong), "You asked for this"));
  EXPECT_TRUE(explainer.suppositions().empty());
}

TEST(Explainer, asksTheSolverWhatWouldFollow) {
  std::atomic<int> nudged{0};
  Explainer explainer([&] { ++nudged; });
  explainer.show(sample());
  std::thread solver([&] {
    while (explainer.suppositions().empty())
      std::this_thread::yield();
    explainer.suppositions().answerOne([](const std::vector<Literal>& fluents) {
      Explain::Response response;
      response.known = true;
      response.text = fluents.at(0).text();
      return std::make_optional(response);
    });
  });
  const auto response = explainer.explain(request({"(E)"}, kWhatIf), kLong);
  solver.join();
  EXPECT_TRUE(response.known);
  EXPECT_EQ(response.text, "(e)");
  EXPECT_EQ(nudged, 1);
}

TEST(Explainer, dropsWhatNobodyWaitsForAnyMore) {
  Explainer explainer;
  explainer.show(sample());
  const auto response = explainer.explain(request({"(e)"}, kWhatIf), kNone);
  EXPECT_FALSE(response.known);
  EXPECT_EQ(response.text, "Not known yet.");
  EXPECT_TRUE(explainer.suppositions().empty());
  explainer.suppositions().answerOne([](const std::vector<Literal>&) {
    ADD_FAILURE() << "its asker has given up";
    return std::nullopt;
  });
}

TEST(SuppositionQueue, triesAgainWhatIsNotKnownYetWhileItsAskerWaits) {
  SuppositionQueue queue;
  std::atomic<bool> gives_up{false};
  int tries = 0;
  std::thread solver([&] {
    while (!gives_up || !queue.empty()) {
      queue.answerOne([&](const std::vector<Literal>&) {
        Explain::Response response;
        return ++tries == 3 ? std::make_optional(response) : std::nullopt;
      });
    }
  });
  const auto later = [](double seconds) {
    return SuppositionQueue::Clock::now() +
           std::chrono::duration_cast<SuppositionQueue::Clock::duration>(
               std::chrono::duration<double>(seconds));
  };
  EXPECT_TRUE(queue.ask({Literal::parse("(e)")}, later(20)));
  EXPECT_FALSE(queue.ask({Literal::parse("(e)")}, later(0.05))) << "it is never known";
  gives_up = true;
  solver.join();
  EXPECT_GT(tries, 3);
}

}  // namespace
}  // namespace goal_alignment::aligner
