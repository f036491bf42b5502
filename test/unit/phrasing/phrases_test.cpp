// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/phrases.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "goal_alignment/common/yaml_reader.h"

namespace goal_alignment::phrasing {
namespace {

constexpr const char* kTea = R"(
predicates:
  Made-With: "{0} is made with {1}"
  on-high-shelf:
    affirmative: "{0} is on the high shelf"
    negated: "{0} is off the high shelf"
  dusty: {negated: "{0} is free of dust"}
  too-many: "{0} {1} {2}"
  braces: "{{{0}}}"
objects:
  tea: "the tea"
  good-leaves: "the good leaves"
actions:
  go: "go from {0} to {1}"
  wait: "wait a little"
)";

Phrases tea() {
  return Phrases::fromYaml(kTea, "tea.yaml");
}

std::vector<Literal> literals(const std::vector<std::string>& texts) {
  std::vector<Literal> result;
  for (const std::string& text : texts)
    result.push_back(Literal::parse(text));
  return result;
}

struct Spoken {
  std::string pddl;
  std::string expected;
};

struct SpokenList {
  std::vector<std::string> pddl;
  std::string expected;
};

TEST(Phrases, ClausesComeFromTheTemplates) {
  const std::vector<Spoken> table = {
      {"(made-with tea good-leaves)", "the tea is made with the good leaves"},
      {"(on-high-shelf good-leaves)", "the good leaves is on the high shelf"},
      {"(not (on-high-shelf tea))", "the tea is off the high shelf"},
      {"(not (made-with tea water))", "it is not so that the tea is made with water"},
      {"(braces tea)", "{the tea}"},
  };
  for (const Spoken& row : table) {
    EXPECT_EQ(tea().clause(Literal::parse(row.pddl)), row.expected) << row.pddl;
  }
}

TEST(Phrases, WithoutATemplateThePredicateIsReadOutReadably) {
  const std::vector<Spoken> table = {
      {"(hand-empty)", "\"hand empty\" holds"},
      {"(not (hand-empty))", "\"hand empty\" does not hold"},
      {"(brewed-with tea spring_water)", "\"brewed with\" holds for the tea and spring water"},
      {"(between a level-2 f0-1)", "\"between\" holds for a, level 2 and f0-1"},
      {"(dusty cup)", "\"dusty\" holds for cup"},
      {"(not (dusty cup))", "cup is free of dust"},
      {"(too-many a b)", "\"too many\" holds for a and b"},
      {"(not (too-many a b))", "\"too many\" does not hold for a and b"},
  };
  for (const Spoken& row : table) {
    EXPECT_EQ(tea().clause(Literal::parse(row.pddl)), row.expected) << row.pddl;
  }
}

TEST(Phrases, AYesToTheQuestionMeansWanted) {
  const std::vector<SpokenList> table = {
      {{}, ""},
      {{"(made-with tea good-leaves)"},
       "Does it matter to you that the tea is made with the good leaves?"},
      {{"(not (on-high-shelf tea))"}, "Does it matter to you that the tea is off the high shelf?"},
      {{"(p a)", "(q b)"},
       "Which of these matter to you: that \"p\" holds for a, and that \"q\" holds for b?"},
      {{"(p)", "(q)", "(r)"},
       "Which of these matter to you: that \"p\" holds; that \"q\" holds; and that \"r\" holds?"},
  };
  for (const SpokenList& row : table) {
    EXPECT_EQ(tea().question(literals(row.pddl)), row.expected);
  }
}

TEST(Phrases, AProvenReasonSaysCant) {
  const std::vector<SpokenList> table = {
      {{}, ""},
      {{"(made-with tea good-leaves)"},
       "I can't do what you asked for and this as well: the tea is made with the good leaves."},
      {{"(p)", "(not (dusty cup))"}, "I can't have both: \"p\" holds, and cup is free of dust."},
      {{"(p)", "(q)", "(r)"},
       "I can't have all of these together: \"p\" holds; \"q\" holds; and \"r\" holds."},
  };
  for (const SpokenList& row : table) {
    EXPECT_EQ(tea().reason(literals(row.pddl), true), row.expected);
  }
}

TEST(Phrases, ASuspectedReasonSaysCouldNotFindOut) {
  const std::vector<SpokenList> table = {
      {{}, ""},
      {{"(p)"},
       "I could not find out whether I can do what you asked for and this as well: \"p\" holds."},
      {{"(p)", "(q)"},
       "I could not find out whether I can have both: \"p\" holds, and \"q\" holds."},
      {{"(p)", "(q)", "(r)"},
       "I could not find out whether I can have all of these together: \"p\" holds; \"q\" holds; "
       "and \"r\" holds."},
  };
  for (const SpokenList& row : table) {
    EXPECT_EQ(tea().reason(literals(row.pddl), false), row.expected);
  }
}

TEST(Phrases, ActionsAreSpokenWithOrWithoutATemplate) {
  const std::vector<Spoken> table = {
      {"(go hallway good-leaves)", "go from hallway to the good leaves"},
      {"(wait)", "wait a little"},
      {"(climb-up)", "climb up"},
      {"(take-one mug counter)", "take one: mug, counter"},
      {"(go hallway)", "go: hallway"},
  };
  for (const Spoken& row : table) {
    EXPECT_EQ(tea().action(GroundName::parse(row.pddl)), row.expected) << row.pddl;
  }
}

TEST(Phrases, AtTheEndIsSaidWhereItMayPass) {
  const auto one = literals({"(p a)"});
  EXPECT_EQ(tea().question(one, true),
            "When I'm done, does it matter to you that \"p\" holds for a?");
  EXPECT_EQ(tea().question(literals({"(p)", "(q)"}), true),
            "When I'm done, which of these matter to you: that \"p\" holds, and that \"q\" holds?");
}

TEST(Phrases, WordOrderAndCasesOfOtherLanguages) {
  const Phrases german = Phrases::fromYaml(
      "language: de\n"
      "predicates:\n"
      "  at: {affirmative: \"{0} steht {1:wo}\", that: \"{0} {1:wo} steht\"}\n"
      "  full: {affirmative: \"{0} ist voll\", negated: \"{0} ist leer\"}\n"
      "objects:\n"
      "  sink: {name: \"die Spüle\", Wo: \"an der Spüle\"}\n"
      "  kettle: \"der Kessel\"\n",
      "f");
  const std::vector<Spoken> table = {
      {"(at kettle sink)", "der Kessel steht an der Spüle"},
      {"(at kettle kettle)", "der Kessel steht der Kessel"},  // without a form of its own
      {"(not (at kettle sink))", "es stimmt nicht, dass der Kessel an der Spüle steht"},
      {"(full kettle)", "der Kessel ist voll"},
      {"(not (full kettle))", "der Kessel ist leer"},
      {"(big sink kettle)", "„big“ gilt für die Spüle und der Kessel"},
  };
  for (const Spoken& row : table)
    EXPECT_EQ(german.clause(Literal::parse(row.pddl)), row.expected) << row.pddl;
  EXPECT_EQ(german.question(literals({"(at kettle sink)"})),
            "Ist es Ihnen wichtig, dass der Kessel an der Spüle steht?");
  EXPECT_EQ(german.question(literals({"(not (full kettle))"})),
            "Ist es Ihnen wichtig, dass Folgendes gilt: der Kessel ist leer?");
}

TEST(Phrases, WhatHasNoFormAfterThatIsSaidAsOneSaysItThere) {
  const Phrases german =
      Phrases::fromYaml("language: de\npredicates: {closed: \"das Tor ist zu\"}\n", "f");
  const std::vector<Spoken> thats = {
      {"(closed)", "dass Folgendes gilt: das Tor ist zu"},
      {"(not (closed))", "dass Folgendes nicht gilt: das Tor ist zu"},
      {"(loud)", "dass „loud“ gilt"},
      {"(not (loud))", "dass „loud“ nicht gilt"},
      {"(loud bell)", "dass „loud“ für bell gilt"},
      {"(not (loud bell))", "dass „loud“ für bell nicht gilt"},
      {"(= bell gong)", "dass bell und gong dasselbe sind"},
      {"(not (= bell gong))", "dass bell und gong nicht dasselbe sind"},
  };
  for (const Spoken& row : thats)
    EXPECT_EQ(german.that(Literal::parse(row.pddl)), row.expected) << row.pddl;
  EXPECT_EQ(german.clause(Literal::parse("(not (closed))")),
            "Folgendes gilt nicht: das Tor ist zu");
}

TEST(Phrases, SingleTextsOfALanguageAreReplaced) {
  const Phrases own = Phrases::fromYaml("frames: {certain: \"No doubt.\"}\nlanguage: de\n", "f");
  EXPECT_EQ(own.say("certain"), "No doubt.");
  EXPECT_EQ(own.say("answer_yes"), "ja");
  EXPECT_EQ(own.warning(), "");
}

TEST(Phrases, EqualityIsSaidInWords) {
  EXPECT_EQ(tea().clause(Literal::parse("(= tea cup)")), "the tea and cup are the same");
  EXPECT_EQ(tea().clause(Literal::parse("(not (= tea cup))")), "the tea and cup are not the same");
}

TEST(Phrases, AFailureNamesTheStepAndWhatIsNotSo) {
  using Violation = validation::Violation;
  const GroundName step = GroundName::parse("(go hallway good-leaves)");
  Violation violation;
  violation.step = 2;
  violation.kind = Violation::Kind::Precondition;
  violation.missing = literals({"(on-high-shelf tea)"});
  const std::string begin = "step 3 (go from hallway to the good leaves) can't be done: ";
  EXPECT_EQ(tea().failure(violation, step), begin + "at that point the tea is off the high shelf");
  violation.missing = literals({"(p)", "(q)"});
  EXPECT_EQ(tea().failure(violation, step),
            begin + "none of these is so at that point: \"p\" holds, and \"q\" holds");
  violation.missing.clear();
  EXPECT_EQ(tea().failure(violation, step),
            begin + "something that it needs is not so at that point");
  violation.kind = Violation::Kind::UnknownAction;
  EXPECT_EQ(tea().failure(violation, GroundName::parse("(fly-home tea)")),
            "step 3 (fly home: the tea) can't be done: I know no such step");
  violation.object = "black-hole";
  violation.kind = Violation::Kind::UnknownObject;
  EXPECT_EQ(tea().failure(violation, step), begin + "I know nothing that is called black hole");
}

TEST(Phrases, WhatOthersSayInPddlIsPutInWords) {
  EXPECT_EQ(
      tea().inWords("step 2 (go hallway tea) failed (too late): (not (dusty cup)), then (x"),
      "step 2 (go from hallway to the tea) failed (too late): (cup is free of dust), then (x");
  EXPECT_EQ(tea().inWords(")) ((go hallway tea))"), ")) ((go from hallway to the tea))");
  EXPECT_EQ(tea().inWords("(fly hallway)"), "(fly hallway)") << "no template";
  EXPECT_EQ(tea().inWords(""), "");
}

TEST(Phrases, FilesThatSayNothingAreFine) {
  for (const std::string text : {"", "# only a comment\n", "objects:\n", "predicates: {}\n"}) {
    EXPECT_EQ(Phrases::fromYaml(text, "f").clause(Literal::parse("(p)")), "\"p\" holds") << text;
  }
}

struct Broken {
  std::string yaml;
  std::string position;
  std::string message;
};

TEST(Phrases, ErrorsNamePlaceExpectationAndWhatStoodThere) {
  const std::vector<Broken> table = {
      {"predicates: [a]", "1:13", "expected a map from names to texts, found a list"},
      {"- a", "1:1",
       "expected a map of 'predicates', 'objects', 'actions', 'language' and 'frames', found a "
       "list"},
      {"objects:\npredicate:\n", "2:1",
       "expected 'predicates', 'objects', 'actions', 'language' or 'frames', found 'predicate'"},
      {"predicates:\n  on: \"{a} on {1}\"", "2:7",
       "expected a gap such as {0} (or {{ for a brace), found '{a}'"},
      {"predicates:\n  on: \"on {1\"", "2:7",
       "expected a gap such as {0} (or {{ for a brace), found '{1'"},
      {"predicates:\n  on: \"{12345}\"", "2:7",
       "expected a gap such as {0} (or {{ for a brace), found '{12345}'"},
      {"actions:\n  go: \"0} to\"", "2:7",
       "expected '{' before '}' (or }} for a brace), found '0}'"},
      {"actions:\n  go: [x]", "2:7", "expected a text such as \"go to {0}\", found a list"},
      {"objects:\n  a: \"\"", "2:6", "expected what to call the object, found ''"},
      {"objects:\n  cup: x\n  Cup: y", "3:3", "expected each name once, found 'cup' again"},
      {"predicates:\n  on: {positive: x}", "2:8",
       "expected 'affirmative', 'negated', 'that' or 'that_not', found 'positive'"},
      {"predicates:\n  on: {that: x, that: y}", "2:17",
       "expected each name once, found 'that' again"},
      {"objects:\n  a: {dative: x}", "2:6", "expected 'name', what to call the object, found none"},
      {"language: xx", "1:11",
       "expected 'de', 'en', or a file beside this one, FILE.yaml, found 'xx'"},
      {"frames:\n  certain: x\n  certian: x", "3:3",
       "expected a name that config/phrases/en.yaml has, found 'certian'"},
      {"frames:\n  question: \"Hm?\"", "2:13", "expected a text with {0}, found 'Hm?'"},
      {"frames: {certain: \"{0}\"}", "1:19", "expected a text with no gap, found '{0}'"},
      {"frames: {certain: a, certain: b}", "1:22",
       "expected each name once, found 'certain' again"},
      {"objects: {a: b\n", "2:1", "expected YAML, found end of map flow not found"},
      {"objects:\n---\nobjects:\n", "2:1", "expected one document, found a second one"},
      {", a", "1:1", "expected one document, found a second one"},
      {"objects: {a: K\xfc}", "1:14", "expected UTF-8, found other bytes in 'K…'"},
      {"objects: {a: \"\\ü\"}", "1:17", "expected YAML, found unknown escape character: "},
      {"objects: {a: " + std::string(1001, 'x') + "}", "1:14",
       "expected at most 1000 bytes, found '" + std::string(60, 'x') + "…'"},
  };
  for (const Broken& row : table) {
    try {
      Phrases::fromYaml(row.yaml, "tea.yaml");
      ADD_FAILURE() << "accepted: " << row.yaml;
    } catch (const YamlError& error) {
      EXPECT_EQ(error.what(), "tea.yaml:" + row.position + ": " + row.message);
    }
  }
}

}  // namespace
}  // namespace goal_alignment::phrasing
