// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/what_if_query.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <thread>

namespace goal_alignment::aligner {
namespace {

using Kind = session::Consequence::Kind;

std::vector<Literal> literals(const std::vector<std::string>& texts) {
  std::vector<Literal> result;
  for (const std::string& text : texts)
    result.push_back(Literal::parse(text));
  return result;
}

// (g) is asked for; (a), (b) and (not (c)) are candidates.
session::Snapshot sample() {
  session::Snapshot snapshot;
  snapshot.specified = literals({"(g)"});
  for (const Literal& fluent : literals({"(a)", "(b)", "(not (c))"})) {
    session::CandidateView view;
    view.fluent = fluent;
    snapshot.candidates.push_back(view);
  }
  snapshot.conflicts = {{literals({"(a)", "(b)"}), true, true, true},
                        {literals({"(b)"}), false, false, true}};
  return snapshot;
}

WhatIfQuery suppose(const std::vector<std::string>& texts) {
  return supposition(literals(texts), sample(), {});
}

TEST(WhatIfQuery, candidatesAreWantedAndTheirNegationsNot) {
  const WhatIfQuery supposed = suppose({"(a)", "(not (b))", "(not (c))", "(g)"});
  EXPECT_EQ(supposed.refusal, "");
  EXPECT_EQ(supposed.wanted, literals({"(a)", "(not (c))"}));
  EXPECT_EQ(supposed.not_wanted, literals({"(b)"}));
}

TEST(WhatIfQuery, whatMakesNoSenseIsRefused) {
  EXPECT_EQ(suppose({"(a)", "(z)"}).refusal,
            "You don't expect this, so nothing depends on it: \"z\" holds.");
  EXPECT_EQ(suppose({"(c)"}).refusal,
            "You don't expect this, so nothing depends on it: \"c\" holds.");
  EXPECT_EQ(suppose({"(not (g))"}).refusal, "You asked for this: \"g\" holds.");
  EXPECT_EQ(suppose({"(a)", "(not (a))"}).refusal,
            "This can't both matter and not matter: \"a\" holds.");
}

Explain::Response explained(const session::Consequence& consequence,
                            const std::vector<std::string>& texts = {"(a)"}) {
  return explainConsequence(suppose(texts), consequence, sample(), {});
}

TEST(WhatIfQuery, aPlanIsToldWithItsLength) {
  session::Consequence consequence;
  consequence.kind = Kind::Plan;
  consequence.plan.resize(7);
  const auto response = explained(consequence);
  EXPECT_TRUE(response.known);
  EXPECT_EQ(response.text, "If it mattered that \"a\" holds: I would have a plan of 7 steps.");
  EXPECT_TRUE(response.conflicts.empty());
  consequence.plan.resize(1);
  EXPECT_EQ(explained(consequence, {"(not (a))"}).text,
            "If it did not matter that \"a\" holds: I would have a plan of 1 step.");
  consequence.plan.clear();
  EXPECT_EQ(explained(consequence, {"(g)"}).text,
            "As things stand: all would be so already, without a step.");
}

TEST(WhatIfQuery, noPlanIsToldWithItsConflict) {
  session::Consequence consequence;
  consequence.kind = Kind::NoPlan;
  consequence.conflict = literals({"(b)", "(a)"});
  const auto response = explained(consequence, {"(a)", "(b)"});
  EXPECT_TRUE(response.known);
  EXPECT_EQ(response.text,
            "If it mattered that \"a\" holds, and that \"b\" holds: I could not do it. I can't "
            "have both: \"b\" holds, and \"a\" holds.");
  ASSERT_EQ(response.conflicts.size(), 1U);
  EXPECT_TRUE(response.conflicts[0].proven);
  EXPECT_TRUE(response.conflicts[0].minimal) << "as it is known";
  consequence.conflict = literals({"(a)"});
  EXPECT_TRUE(explained(consequence).conflicts.at(0).proven) << "though nobody knew it before";
}

TEST(SuppositionQueue, whatTheSolverFailsAtIsToldAndTheNextIsAnswered) {
  SuppositionQueue queue;
  const auto deadline = SuppositionQueue::Clock::now() + std::chrono::seconds(60);
  const auto ask = [&](const std::string& fluent) {
    return std::async(std::launch::async, [&queue, deadline, fluent] {
      return queue.ask(literals({fluent}), deadline);
    });
  };
  auto failing = ask("(a)");
  while (queue.empty())
    std::this_thread::yield();
  queue.answerOne([](const std::vector<Literal>&) -> std::optional<Explain::Response> {
    throw std::runtime_error("no room");
  });
  const auto failed = failing.get();
  ASSERT_TRUE(failed);
  EXPECT_FALSE(failed->known);
  EXPECT_EQ(failed->text, "I can't tell: no room");
  EXPECT_TRUE(queue.empty()) << "it is not tried again";

  auto next = ask("(b)");
  while (queue.empty())
    std::this_thread::yield();
  queue.answerOne([](const std::vector<Literal>&) { return notKnownYet({}); });
  EXPECT_EQ(next.get()->text, "Not known yet.");
}

TEST(WhatIfQuery, questionsThatFollowAreCounted) {
  session::Consequence consequence;
  consequence.kind = Kind::Questions;
  consequence.max_remaining = 3;
  consequence.conflict = literals({"(b)"});
  const auto response = explained(consequence);
  EXPECT_TRUE(response.known);
  EXPECT_EQ(
      response.text,
      "If it mattered that \"a\" holds: I would have to ask at most 3 more questions. I "
      "could not find out whether I can do what you asked for and this as well: \"b\" holds.");
  EXPECT_FALSE(response.conflicts.at(0).proven);
  consequence.conflict.clear();
  consequence.max_remaining = 1;
  EXPECT_EQ(explained(consequence).text,
            "If it mattered that \"a\" holds: I would have to ask at most one more question.");
  consequence.bound_is_provisional = true;
  EXPECT_EQ(explained(consequence).text,
            "If it mattered that \"a\" holds: a few more questions may follow.");
  consequence.max_remaining = 0;
  EXPECT_EQ(explained(consequence).text,
            "If it mattered that \"a\" holds: it would stay undecided.");
}

}  // namespace
}  // namespace goal_alignment::aligner
