// SPDX-License-Identifier: BSD-3-Clause
// What the node tells in German besides questions: outcomes, explanations, suppositions, the story.
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "aligner/explanation.h"
#include "aligner/outcome_text.h"
#include "aligner/what_if_query.h"
#include "nodes/demo_narrator.h"

namespace goal_alignment::aligner {
namespace {

using session::CandidateState;
using session::OutcomeCode;

const phrasing::Phrases& german() {
  static const phrasing::Phrases phrases = phrasing::Phrases::fromYaml("language: de", "f");
  return phrases;
}

// Words of English frames, none of which is a German one.
void expectGerman(const std::string& text) {
  static const std::set<std::string> kEnglish = {
      "the", "that", "this", "you",  "it",  "is",  "if",       "not",  "and",  "of",    "does",
      "can", "have", "yes",  "with", "do",  "or",  "both",     "step", "asks", "steps", "answers",
      "ask", "no",   "my",   "your", "for", "has", "answered", "want", "know", "named", "task"};
  EXPECT_FALSE(text.empty());
  std::string word;
  for (const char c : text + " ") {
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0) {
      word += c;
      continue;
    }
    EXPECT_EQ(kEnglish.count(word), 0U) << "'" << word << "' in: " << text;
    word.clear();
  }
}

Literal literal(const std::string& text) {
  return Literal::parse(text);
}

// (g) is asked for; (a) and (b) can't be had together.
ExplanationContext sample(CandidateState state) {
  ExplanationContext explained;
  explained.snapshot.state = session::State::AwaitingAnswer;
  explained.snapshot.specified = {literal("(g)")};
  explained.snapshot.robot_known = true;
  explained.snapshot.conflicts_complete = true;
  for (const char* name : {"(a)", "(b)"}) {
    session::CandidateView view;
    view.fluent = literal(name);
    view.state = state;
    explained.snapshot.candidates.push_back(view);
  }
  explained.snapshot.conflicts = {{{literal("(a)"), literal("(b)")}, true, true, true}};
  explained.phrases = german();
  return explained;
}

TEST(German, outcomes) {
  session::Outcome outcome;
  for (const OutcomeCode code :
       {OutcomeCode::Success, OutcomeCode::Canceled, OutcomeCode::GoalUnsolvable,
        OutcomeCode::ExpectationUnachievable, OutcomeCode::UnsureBlocks, OutcomeCode::TimeLimit,
        OutcomeCode::MemoryLimit, OutcomeCode::BudgetLimit, OutcomeCode::Declined,
        OutcomeCode::QuestionLimit}) {
    outcome.code = code;
    outcome.message = "the message of the program";
    outcome.conflict.clear();
    if (code != OutcomeCode::ExpectationUnachievable)
      expectGerman(spokenOutcome(outcome, sample(CandidateState::Unsure).snapshot, german(), {}));
    outcome.conflict = {literal("(a)"), literal("(b)")};
    expectGerman(spokenOutcome(outcome, sample(CandidateState::Unsure).snapshot, german(), {}));
  }
}

TEST(German, explanations) {
  for (const CandidateState state :
       {CandidateState::Open, CandidateState::Asked, CandidateState::Wanted,
        CandidateState::NotWanted, CandidateState::Unsure, CandidateState::Settled}) {
    ExplanationContext explained = sample(state);
    for (const char* fluent : {"(a)", "(g)", "(z)"}) {
      expectGerman(explainWhy(explained, {literal(fluent)}).text);
      expectGerman(explainWhyNot(explained, {literal(fluent)}).text);
    }
    expectGerman(explainWhyNot(explained, {}).text);
    explained.human_plan = {GroundName::parse("(go)")};
    expectGerman(explainWhyNot(explained, {}).text);
    explained.snapshot.candidates[0].answered_by = "Ada";
    expectGerman(explainWhy(explained, {literal("(a)")}).text);
  }
}

TEST(German, suppositions) {
  session::Consequence consequence;
  const auto snapshot = sample(CandidateState::Open).snapshot;
  for (const auto kind : {session::Consequence::Kind::Plan, session::Consequence::Kind::NoPlan,
                          session::Consequence::Kind::Questions}) {
    consequence.kind = kind;
    for (const std::size_t number : {0, 1, 2}) {
      consequence.max_remaining = number;
      consequence.plan.resize(number);
      const WhatIfQuery supposed = supposition({literal("(a)")}, snapshot, german());
      expectGerman(explainConsequence(supposed, consequence, snapshot, german()).text);
    }
  }
  for (const char* refused : {"(z)", "(not (g))"})
    expectGerman(supposition({literal(refused)}, snapshot, german()).refusal);
}

TEST(German, theStoryOfATask) {
  std::ostringstream out;
  nodes::DemoNarrator story(out, german());
  HumanTask task;
  task.plan.resize(1);
  task.plan[0].name = "putzen";
  story.begin(task);
  AlignResult result;
  result.session_id = "s";
  result.outcome = AlignResult::EXPECTATION_UNACHIEVABLE;
  result.message = "Das geht nicht";
  result.alternatives.resize(4);
  story.hear(result);
  story.takeUp(result.alternatives[0]);
  story.awaitChoice();
  result.outcome = AlignResult::SUCCESS;
  result.plan.steps.resize(2);
  result.plan.steps[0].name = result.plan.steps[1].name = "putzen";
  result.plan.cost = 2;
  result.plan.extra_cost = 1;
  story.hear(result);
  story.hearTrouble("Schritt 1");
  story.hearNewPlan(result.plan);
  ExecutePlanResult end;
  end.outcome = ExecutePlanResult::SUCCESS;
  story.hearEnd(result.plan, end);
  expectGerman(out.str());
}

}  // namespace
}  // namespace goal_alignment::aligner
