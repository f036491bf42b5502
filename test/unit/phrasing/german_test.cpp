// SPDX-License-Identifier: BSD-3-Clause
// Whole dialogues in German: not a word of the English frames.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "goal_alignment/cli/instance.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/phrasing/outcomes.h"
#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/phrasing/reply.h"
#include "goal_alignment/session/session.h"
#include "unit/source_root.h"

namespace goal_alignment::phrasing {
namespace {

using session::Session;

const std::vector<std::string> kDomains = {"tea", "ward", "home"};

Phrases germanOf(const std::string& domain) {
  const auto file = sourceRoot() / "config/domains" / domain / "phrases.de.yaml";
  return Phrases::fromYaml(pddl::readFile(file.string()).text, file.string());
}

/// Words of English frames, none of which is a German one.
void expectGerman(const std::string& text) {
  static const std::set<std::string> kEnglish = {
      "the", "that", "this", "you",   "it",  "is",  "if",   "not", "and", "of",   "does",
      "can", "have", "plan", "holds", "for", "yes", "with", "do",  "or",  "both", "matter"};
  static const std::set<std::string> kBothLanguages = {"plan"};
  std::string word;
  for (const char c : text + " ") {
    if ((c >= 'a' && c <= 'z') || (c & 0x80) != 0) {
      word += c;
      continue;
    }
    EXPECT_TRUE(kEnglish.count(word) == 0 || kBothLanguages.count(word) > 0)
        << "'" << word << "' in: " << text;
    word.clear();
  }
}

class GermanDialogue : public testing::Test {
 protected:
  /// Says all that is said on the way, and answers with `kind`.
  session::Outcome hold(const std::string& domain, session::AnswerKind kind) {
    const auto folder = sourceRoot() / "config/domains" / domain;
    phrases_ = germanOf(domain.substr(0, domain.find('/')));
    Session session{session::Options{}};
    session::Input input = cli::readInput(cli::InstanceFiles::of(folder.string()));
    const std::vector<GroundName> plan = input.human_plan;
    session.begin(std::move(input));
    while (session.step() != session::State::Done) {
      if (const auto& violation = session.humanPlanViolation())
        told(phrases_.failure(*violation, plan.at(violation->step)));
      if (session.state() != session::State::AwaitingAnswer) continue;
      const session::QuestionView question = *session.question();
      told(phrases_.question(question.fluents, question.at_end));
      told(phrases_.why(question.reasons, question.if_yes, question.if_no,
                        question.bound_is_provisional));
      told(questionLine(
          {question.asked + 1, "Ada", question.max_remaining, question.bound_is_provisional, ""},
          phrases_));
      session.answer(question.fluents, kind, "Ada");
    }
    for (const GroundName& step : session.outcome().plan.steps)
      told(phrases_.action(step));
    return session.outcome();
  }

  void told(const std::string& text) {
    expectGerman(text);
    told_ += text + "\n";
  }
  bool says(const std::string& part) const { return told_.find(part) != std::string::npos; }

  Phrases phrases_;
  std::string told_;
};

TEST_F(GermanDialogue, QuestionsReasonsProspectsAndPlan) {
  const session::Outcome outcome = hold("tea", session::AnswerKind::No);
  ASSERT_EQ(outcome.code, session::OutcomeCode::Success);
  EXPECT_TRUE(says("st es Ihnen")) << told_;
  EXPECT_TRUE(says(", dass ")) << told_;
  EXPECT_TRUE(says("Beides zusammen geht nicht: ")) << told_;
  EXPECT_TRUE(says("Wenn nicht, ")) << told_;
  EXPECT_TRUE(says("Frage 1 an Ada (")) << told_;
  EXPECT_TRUE(
      says("Schritt 3 (die Leiter hinaufsteigen) geht nicht, denn einen solchen Schritt "
           "kenne ich nicht"))
      << told_;
  EXPECT_TRUE(says("den Tee in ")) << told_;
  told(planFound(phrases_, {}));
}

TEST_F(GermanDialogue, ARefusalAndWhatThereIsInstead) {
  const session::Outcome outcome = hold("ward", session::AnswerKind::Yes);
  ASSERT_EQ(outcome.code, session::OutcomeCode::ExpectationUnachievable);
  std::vector<std::vector<Literal>> given_up;
  for (const session::Alternative& alternative : outcome.alternatives)
    given_up.push_back(alternative.given_up);
  ASSERT_GT(given_up.size(), 1U);
  told(expectationUnachievable(phrases_, {outcome.conflict, true}, given_up));
  EXPECT_TRUE(says("Das ist sicher. Ich kann alles tun, bis auf dies: ")) << told_;
  EXPECT_TRUE(says("Oder alles bis auf dies: ")) << told_;
  told(unsureBlocks(phrases_, {outcome.conflict, false}, outcome.conflict, given_up));
  for (const Limit limit : {Limit::Time, Limit::Memory, Limit::Budget}) {
    told(leftOpen(phrases_, outcome.conflict, limit));
    told(leftOpen(phrases_, "the search for it", limit));
  }
}

TEST(German, AnswersAreTypedInIt) {
  const Frames::Shared shared = Frames::shipped("de");
  const Frames& german = *shared;
  const auto kind = [&](const std::string& line, std::size_t fluents = 1) {
    const auto reply = parseReply(line, fluents, german);
    return reply ? static_cast<int>(reply->kind) : -1;
  };
  EXPECT_EQ(kind("J"), 1);
  EXPECT_EQ(kind(" Ja "), 1);
  EXPECT_EQ(kind("nein"), 0);
  EXPECT_EQ(kind("weiss nicht"), 2);
  EXPECT_EQ(kind("Weiß nicht"), 2);
  EXPECT_EQ(kind("keine fragen mehr"), 3);
  EXPECT_EQ(kind("alle", 2), 1);
  EXPECT_EQ(kind("keins", 2), 0);
  EXPECT_EQ(kind("yes"), -1);
  expectGerman(replyKeys(1, german));
  expectGerman(replyKeys(2, german));
}

// Each predicate has its sentence, and its word order after "dass".
TEST(German, EveryNameOfTheDomainsHasItsWords) {
  for (const std::string& domain : kDomains) {
    const Phrases phrases = germanOf(domain);
    const Phrases bare = Phrases::fromYaml("language: de", "f");
    for (const char* side : {"robot", "human"}) {
      const auto folder = sourceRoot() / "config/domains" / domain;
      const auto problems = domain == "home" ? folder / "lay_table" : folder;
      const pddl::Model model = pddl::readModel(
          pddl::readFile((folder / (std::string(side) + "_domain.pddl")).string()),
          pddl::readFile((problems / (std::string(side) + "_problem.pddl")).string()));
      for (const pddl::Predicate& predicate : model.predicates) {
        const GroundName atom{predicate.name.name,
                              std::vector<std::string>(predicate.parameter_types.size(), "es")};
        for (const bool negated : {false, true}) {
          const Literal fluent{atom, negated};
          EXPECT_NE(phrases.clause(fluent), bare.clause(fluent)) << predicate.name.spelling;
          EXPECT_EQ(phrases.that(fluent).find("Folgendes"), std::string::npos)
              << phrases.that(fluent);
          EXPECT_EQ(phrases.that(fluent).find("es nicht stimmt"), std::string::npos)
              << phrases.that(fluent);
          expectGerman(phrases.clause(fluent));
        }
      }
      for (const pddl::Schema& schema : model.schemas) {
        const GroundName step{schema.name.name,
                              std::vector<std::string>(schema.parameters.size(), "es")};
        EXPECT_NE(phrases.action(step), bare.action(step)) << schema.name.spelling;
      }
      for (const pddl::Object& object : model.objects) {
        EXPECT_NE(phrases.object(object.name.name), bare.object(object.name.name))
            << domain << ": " << object.name.spelling;
      }
    }
  }
}

}  // namespace
}  // namespace goal_alignment::phrasing
