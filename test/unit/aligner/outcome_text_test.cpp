// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/outcome_text.h"

#include <gtest/gtest.h>

namespace goal_alignment::aligner {
namespace {

using session::OutcomeCode;

session::Outcome outcomeWith(OutcomeCode code, const std::vector<std::string>& conflict) {
  session::Outcome outcome;
  outcome.code = code;
  outcome.message = "as the session says it";
  for (const std::string& text : conflict)
    outcome.conflict.push_back(Literal::parse(text));
  return outcome;
}

// (g) is asked for; (a) and (b) can't be had together, and of (b) nobody is sure.
session::Snapshot sample() {
  session::Snapshot snapshot;
  snapshot.specified = {Literal::parse("(g)")};
  session::CandidateView view;
  view.fluent = Literal::parse("(a)");
  view.state = session::CandidateState::Wanted;
  snapshot.candidates.push_back(view);
  view.fluent = Literal::parse("(b)");
  view.state = session::CandidateState::Unsure;
  snapshot.candidates.push_back(view);
  snapshot.conflicts = {{{view.fluent, Literal::parse("(a)")}, true, true, true}};
  return snapshot;
}

std::string spoken(const session::Outcome& outcome) {
  return spokenOutcome(outcome, sample(), {}, {GroundName::parse("(climb-ladder)")});
}

TEST(OutcomeText, fluentsAreSpokenNotSpelled) {
  EXPECT_EQ(spoken(outcomeWith(OutcomeCode::GoalUnsolvable, {})),
            "I can't do what you asked for: \"g\" holds. That is certain.");
  session::Outcome no_plan = outcomeWith(OutcomeCode::ExpectationUnachievable, {"(a)", "(b)"});
  no_plan.alternatives = {{{Literal::parse("(b)")}, 0.5}};
  EXPECT_EQ(spoken(no_plan),
            "I can't have both: \"a\" holds, and \"b\" holds. That is certain. I can do "
            "everything except: \"b\" holds.");
  EXPECT_EQ(spoken(outcomeWith(OutcomeCode::UnsureBlocks, {"(a)", "(b)"})),
            "I can't have both: \"a\" holds, and \"b\" holds. It depends on whether this matters "
            "to you: \"b\" holds.");
  for (const OutcomeCode limit :
       {OutcomeCode::TimeLimit, OutcomeCode::MemoryLimit, OutcomeCode::BudgetLimit})
    EXPECT_EQ(spoken(outcomeWith(limit, {"(a)", "(b)"})).find("I could not find out"), 0U);
  session::Outcome plan = outcomeWith(OutcomeCode::Success, {});
  plan.plan.assumed_not_wanted = {Literal::parse("(c)")};
  EXPECT_NE(
      spoken(plan).find("I don't promise this, since nobody was asked about it: \"c\" holds."),
      std::string::npos);
}

TEST(OutcomeText, whatCouldBeHadInsteadIsSaidWheneverThereIsSomething) {
  session::Outcome unsure = outcomeWith(OutcomeCode::UnsureBlocks, {"(a)", "(b)"});
  unsure.alternatives = {{{Literal::parse("(b)")}, 0.5}, {{Literal::parse("(a)")}, 0.02}};
  const std::string text = spoken(unsure);
  EXPECT_NE(text.find("It depends on whether this matters to you"), std::string::npos) << text;
  const phrasing::Phrases phrases;
  const std::string offer =
      phrases.alternatives({unsure.alternatives[0].given_up, unsure.alternatives[1].given_up});
  ASSERT_FALSE(offer.empty());
  EXPECT_NE(text.find(offer), std::string::npos) << text;
  session::Outcome declined = outcomeWith(OutcomeCode::Declined, {});
  declined.alternatives = {unsure.alternatives[0]};
  EXPECT_EQ(spoken(declined), "I was to ask no more questions, so I left it undecided. " +
                                  phrases.alternatives({unsure.alternatives[0].given_up}));
}

TEST(OutcomeText, everyEndOfADialogueHasWords) {
  const std::vector<std::pair<OutcomeCode, std::string>> table = {
      {OutcomeCode::Success,
       "I have a plan. It does what you asked and keeps everything you didn't rule out."},
      {OutcomeCode::Canceled, "Canceled."},
      {OutcomeCode::TimeLimit,
       "I ran out of time before I could find out (as the session says it)."},
      {OutcomeCode::MemoryLimit,
       "I ran out of memory before I could find out (as the session says it)."},
      {OutcomeCode::BudgetLimit,
       "I ran through my search budget before I could find out (as the session says it); more time "
       "would not help."},
      {OutcomeCode::UnsureBlocks,
       "Nobody knows whether something matters that decides what I do, so I left it undecided."},
      {OutcomeCode::Declined, "I was to ask no more questions, so I left it undecided."},
      {OutcomeCode::QuestionLimit,
       "I may not ask any more questions, and what I do still depends on an answer."},
  };
  for (const auto& [code, text] : table)
    EXPECT_EQ(spoken(outcomeWith(code, {})), text);
}

TEST(OutcomeText, aFaultOfThePlanIsSaidInWords) {
  session::Outcome invalid = outcomeWith(OutcomeCode::HumanPlanInvalid, {});
  invalid.violation.emplace();
  invalid.violation->kind = validation::Violation::Kind::Precondition;
  invalid.violation->missing = {Literal::parse("(ladder-here)")};
  EXPECT_EQ(spoken(invalid),
            "Your plan does not work even as you see things: step 1 (climb ladder) can't be done: "
            "at that point \"ladder here\" does not hold.");
  session::Outcome elsewhere = outcomeWith(OutcomeCode::GoalNotExpected, {});
  elsewhere.missing = {Literal::parse("(tea-served)")};
  EXPECT_EQ(spoken(elsewhere),
            "Your plan does not lead to what you asked for. At its end this is not so: \"tea "
            "served\" holds.");
}

TEST(OutcomeText, whatIsTechnicalStaysTheSessionsMessage) {
  for (const OutcomeCode code :
       {OutcomeCode::NoAnswer, OutcomeCode::InvalidModel, OutcomeCode::GoalNotExpected})
    EXPECT_EQ(spoken(outcomeWith(code, {})), "as the session says it");
}

TEST(OutcomeText, unknownFactsAreNamedInWords) {
  session::Outcome outcome = outcomeWith(OutcomeCode::StateUnknown, {});
  outcome.message = "nobody can tell (robot-at dock): frame base_link does not exist";
  const auto phrases = phrasing::Phrases::fromYaml(
      "predicates: {robot-at: \"the robot is at the {0}\"}", "phrases.yaml");
  EXPECT_EQ(spokenOutcome(outcome, sample(), phrases, {}),
            "I can't tell how things stand: nobody can tell (the robot is at the dock): frame "
            "base_link does not exist");
}

TEST(OutcomeText, aConditionHasNoWords) {
  session::Snapshot snapshot = sample();
  snapshot.condition = "(or (p) (q))";
  EXPECT_EQ(spokenOutcome(outcomeWith(OutcomeCode::GoalUnsolvable, {}), snapshot, {}, {}),
            "I can't do what you asked for. That is certain.");
}

}  // namespace
}  // namespace goal_alignment::aligner
