// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/vocabulary.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "goal_alignment/common/yaml_reader.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/phrasing/spoken_question.h"
#include "unit/source_root.h"

namespace goal_alignment::phrasing {
namespace {

using Kind = Reply::Kind;

Vocabulary vocabularyOf(const std::string& file) {
  const auto path = sourceRoot() / "config/vocabulary" / file;
  return Vocabulary::fromYaml(pddl::readFile(path.string()).text, file);
}

const Vocabulary& english() {
  static const Vocabulary vocabulary = vocabularyOf("en.yaml");
  return vocabulary;
}

const std::vector<std::string>& laundry() {
  static const std::vector<std::string> clauses = {"the towel hangs on the clothes horse",
                                                   "the school shirt hangs on the clothes horse",
                                                   "the sports shirt hangs on the clothes horse"};
  return clauses;
}

// "yes", "no", "unsure", "decline", "repeat", "why", "" for nothing, and numbers from 1.
std::string meaning(const Vocabulary& vocabulary, const std::string& said,
                    const std::vector<std::string>& offered = {"it rains"}) {
  const auto heard = vocabulary.understand(said, offered);
  if (!heard) return "";
  if (heard->kind == Heard::Kind::Repeat) return "repeat";
  if (heard->kind == Heard::Kind::Why) return "why";
  if (!heard->reply.chosen.empty()) {
    EXPECT_EQ(heard->reply.kind, Kind::Yes);
    std::string numbers;
    for (const std::size_t index : heard->reply.chosen)
      numbers += std::to_string(index + 1);
    return numbers;
  }
  const char* words[] = {"no", "yes", "unsure", "decline"};
  return words[static_cast<int>(heard->reply.kind)];
}

std::string ofSeveral(const std::string& said) {
  return meaning(english(), said, laundry());
}

TEST(Vocabulary, AccentsAndHowTheyAreEncodedDoNotCount) {
  const Vocabulary german = vocabularyOf("de.yaml");
  for (const char* said : {"weiß nicht", "WEISS NICHT", "weiss nicht"})
    EXPECT_EQ(meaning(german, said), "unsure") << said;
  for (const char* said : {"natürlich", "NATÜRLICH", "natu\u0308rlich"})
    EXPECT_EQ(meaning(german, said), "yes") << said;
  const std::vector<std::string> offered = {"die Tür der Küche ist zu", "der große Krug ist voll"};
  EXPECT_EQ(meaning(german, "die Ku\u0308che", offered), "1");
  EXPECT_EQ(meaning(german, "GROSSE", offered), "2");
}

TEST(Vocabulary, UnderstandsAnswersInAnyCaseAndWithCourtesy) {
  for (const char* said : {"yes", "Yes.", "  YES,  please!", "well, yes", "It does.", "Of course"})
    EXPECT_EQ(meaning(english(), said), "yes") << said;
  for (const char* said : {"no", "No, thank you.", "it doesn't matter", "it doesn\u2019t"})
    EXPECT_EQ(meaning(english(), said), "no") << said;
  EXPECT_EQ(meaning(english(), "I don't know"), "unsure");
  EXPECT_EQ(meaning(english(), "no more questions please"), "decline");
  EXPECT_EQ(meaning(english(), "Pardon?"), "repeat");
  EXPECT_EQ(meaning(english(), "Why do you ask?"), "why");
}

TEST(Vocabulary, TakesNothingElseForAnAnswer) {
  for (const char* said : {"", "...", "yes and no", "yes but not now", "no yes", "yesterday", "1",
                           "all of them", "it rains"})
    EXPECT_EQ(meaning(english(), said), "") << said;
}

TEST(Vocabulary, OfSeveralThingsNumbersChoose) {
  EXPECT_EQ(ofSeveral("the first and the third"), "13");
  EXPECT_EQ(ofSeveral("one, three"), "13");
  EXPECT_EQ(ofSeveral("1 3"), "13");
  EXPECT_EQ(ofSeveral("number two please"), "2");
  EXPECT_EQ(ofSeveral("the second one"), "2") << "this one is no number";
  EXPECT_EQ(ofSeveral("two and one"), "12");
  EXPECT_EQ(ofSeveral("the first and the sports shirt"), "13");
  EXPECT_EQ(ofSeveral("yes, the first one"), "1");
  EXPECT_EQ(ofSeveral("the fourth"), "") << "there are three";
}

TEST(Vocabulary, OfSeveralThingsNamesChoose) {
  EXPECT_EQ(ofSeveral("the towel"), "1");
  EXPECT_EQ(ofSeveral("The school shirt and the towel"), "12");
  EXPECT_EQ(ofSeveral("sports shirt"), "3");
  EXPECT_EQ(ofSeveral("the shirt"), "") << "which?";
  EXPECT_EQ(ofSeveral("the bed sheet"), "");
  EXPECT_EQ(ofSeveral("not the towel"), "");
  EXPECT_EQ(ofSeveral("all but the towel"), "");
  EXPECT_EQ(ofSeveral("no, the towel"), "");
}

TEST(Vocabulary, OfSeveralThingsAllOrNone) {
  EXPECT_EQ(ofSeveral("all of them"), "yes");
  EXPECT_EQ(ofSeveral("yes, all of them"), "yes");
  EXPECT_EQ(ofSeveral("none"), "no");
  EXPECT_EQ(ofSeveral("no"), "no");
  EXPECT_EQ(ofSeveral("yes"), "") << "which of these?";
  EXPECT_EQ(ofSeveral("y"), "");
  EXPECT_EQ(ofSeveral("don't know"), "unsure");
}

TEST(Vocabulary, SpeaksGermanFromItsFile) {
  const Vocabulary german = vocabularyOf("de.yaml");
  EXPECT_EQ(meaning(german, "Ja, bitte!"), "yes");
  EXPECT_EQ(meaning(german, "Natürlich."), "yes");
  EXPECT_EQ(meaning(german, "Ist egal"), "no");
  EXPECT_EQ(meaning(german, "Keine Ahnung"), "unsure");
  EXPECT_EQ(meaning(german, "die erste und die dritte", laundry()), "13");
  EXPECT_EQ(german.numbered(4, "Tee"), "fünf: Tee.");
}

void expectMeaning(const Vocabulary& vocabulary, const std::string& expected,
                   const std::vector<std::string>& texts) {
  for (const std::string& said : texts)
    EXPECT_EQ(meaning(vocabulary, said), expected) << said;
}

TEST(Vocabulary, UnderstandsWhatPeopleSayInEnglish) {
  expectMeaning(english(), "yes",
                {"yeah sure", "yes of course", "Yes, it does matter to me.", "sure, it matters",
                 "I think it does", "I do care", "very much so", "Yes, I'm sure", "sorry, yes"});
  expectMeaning(english(), "no",
                {"I don't care", "i dont care", "No, it does not matter.", "of course not",
                 "Of course it doesn't.", "whatever", "no, whatever", "not really", "don't bother",
                 "No, don't bother, thanks", "No, I don't mind at all", "I couldn't care less",
                 "never mind", "nah, doesn't matter", "certainly not", "sorry, no",
                 "it really doesn't matter to me", "no, nothing"});
  expectMeaning(english(), "unsure",
                {"you decide", "up to you", "whatever you like", "I don't know, you decide",
                 "I'm not really sure", "hard to say", "maybe not"});
  expectMeaning(english(), "decline", {"stop asking me", "No more questions, thank you"});
}

TEST(Vocabulary, UnderstandsWhatPeopleSayInGerman) {
  const Vocabulary german = vocabularyOf("de.yaml");
  expectMeaning(german, "yes",
                {"ja klar", "klar doch", "Ja, natürlich!", "auf jeden Fall",
                 "ja das ist mir wichtig", "nicht egal", "das ist mir nicht egal", "ja gern"});
  expectMeaning(german, "no",
                {"egal", "ist mir egal", "nö", "nein danke", "auf keinen Fall", "natürlich nicht",
                 "Nein, das ist mir egal", "gar nicht wichtig", "nicht wirklich", "nö, lass mal",
                 "das spielt keine Rolle", "ach nein"});
  expectMeaning(german, "unsure",
                {"weiß nicht", "entscheide du", "das überlasse ich dir",
                 "keine Ahnung, entscheide du", "wie du willst"});
}

TEST(Vocabulary, AsksAgainRatherThanGuesses) {
  expectMeaning(english(), "",
                {"yes, it doesn't matter", "no, it does", "of course, never mind", "yeah no",
                 "I don't know, I don't care", "not", "sure not", "not really unimportant",
                 "I don't care about the rain", "okay", "yes and no", "it", "to me"});
  expectMeaning(vocabularyOf("de.yaml"), "",
                {"ja egal", "nein doch", "nicht", "nicht so egal", "nicht wirklich unwichtig",
                 "mir", "ja nicht", "gut"});
}

const std::vector<std::string>& leftOut() {
  static const std::vector<std::string> clauses = {"the tea is made with the good leaves",
                                                   "the tea is served in the china cup"};
  return clauses;
}

// The number of what is left out, "none", "repeat", or "".
std::string choice(const Vocabulary& vocabulary, const std::string& said,
                   const std::vector<std::string>& offered = leftOut()) {
  const auto choice = vocabulary.choose(said, offered);
  if (!choice) return "";
  if (choice->kind == Choice::Kind::None) return "none";
  if (choice->kind == Choice::Kind::Repeat) return "repeat";
  return std::to_string(choice->index + 1);
}

TEST(Vocabulary, TakesTheAlternativeThatIsNamed) {
  for (const char* said :
       {"the first", "one", "1", "the first one please", "Yes, the first.", "I'll take the first",
        "okay, option one", "I want the first one", "the good leaves", "without the good leaves",
        "everything except the good leaves", "leave out the leaves"})
    EXPECT_EQ(choice(english(), said), "1") << said;
  for (const char* said : {"none", "none of them", "no", "No, thank you.", "neither", "nothing"})
    EXPECT_EQ(choice(english(), said), "none") << said;
  EXPECT_EQ(choice(english(), "say that again"), "repeat");
  const Vocabulary german = vocabularyOf("de.yaml");
  EXPECT_EQ(choice(german, "Ich nehme die zweite"), "2");
  EXPECT_EQ(choice(german, "ohne den Tee", {"der Tee ist fertig", "die Tür ist zu"}), "1");
  EXPECT_EQ(choice(german, "keins von beiden"), "none");
}

TEST(Vocabulary, TakesNoAlternativeThatIsNotClear) {
  for (const char* said :
       {"", "yes", "okay", "both", "the first and the second", "the tea", "the third",
        "not the good leaves", "keep the good leaves", "I want the good leaves", "I don't care",
        "whatever", "either", "you decide", "don't know", "bananas", "yes, but not the first"})
    EXPECT_EQ(choice(english(), said), "") << said;
  EXPECT_EQ(choice(vocabularyOf("de.yaml"), "egal"), "");
}

TEST(Vocabulary, TakesTheOnlyAlternativeForAYes) {
  const std::vector<std::string> one = {"the tea is served in the china cup"};
  for (const char* said :
       {"yes", "okay", "yes please", "go ahead", "okay, do that", "without the cup"})
    EXPECT_EQ(choice(english(), said, one), "1") << said;
  EXPECT_EQ(choice(english(), "no", one), "none");
  EXPECT_EQ(choice(english(), "I don't care", one), "");
}

// A vocabulary with this beside the least that there must be.
std::string faultOf(const std::string& more, const std::string& say = "") {
  const std::string rest =
      "say: {which: w, numbered: '{0}: {1}', sorry: s, answers: a, group_answers: g, no_reason: n" +
      say + "}\n";
  try {
    Vocabulary::fromYaml("'yes': ['yes']\n'no': ['no']\n" + rest + more, "words.yaml");
  } catch (const YamlError& error) {
    return error.what();
  }
  return "";
}

TEST(VocabularyFile, FaultsNameTheirPlace) {
  EXPECT_EQ(faultOf(""), "");
  EXPECT_EQ(faultOf("maybe: ['maybe']").rfind("words.yaml:4:1: expected one of yes, no, ", 0), 0U);
  EXPECT_EQ(faultOf("why: 'why'"),
            "words.yaml:4:6: expected a list of what may be heard, found 'why'");
  EXPECT_EQ(faultOf("why: []"), "words.yaml:4:6: expected what may be heard, found an empty list");
  EXPECT_EQ(faultOf("why: ['?!']"), "words.yaml:4:7: expected at least one word, found '?!'");
  EXPECT_EQ(faultOf("why: ['No!']"),
            "words.yaml:4:7: expected a text of one meaning, found 'No!', which has another above");
  EXPECT_EQ(faultOf("ignored: ['oh well']"), "words.yaml:4:11: expected one word, found 'oh well'");
  EXPECT_EQ(faultOf("numbers: {0: ['zero']}"),
            "words.yaml:4:11: expected a number from 1 to 255, found '0'");
  EXPECT_EQ(faultOf("numbers: {1: ['one'], 2: ['One']}"),
            "words.yaml:4:27: expected each word once, found 'one' again");
  EXPECT_EQ(faultOf("why: [[]]").rfind("words.yaml:4:7: ", 0), 0U);
  EXPECT_EQ(faultOf("{").rfind("words.yaml:", 0), 0U);
  EXPECT_NE(faultOf("", ", goodbye: b").find("'goodbye'"), std::string::npos);
  EXPECT_NE(faultOf("", ", sorry: again").find("'sorry'"), std::string::npos);
  EXPECT_NE(faultOf("", ", chosen: c").find("'choose_one'"), std::string::npos) << "all or none";
  EXPECT_EQ(faultOf("any: ['no']\nbeside: ['to me']"), "") << "what is said in addition";
  EXPECT_EQ(faultOf("any: 'no'"),
            "words.yaml:4:6: expected a list of what may be heard, found 'no'");
  EXPECT_NE(faultOf("why: ['a please']\nignored: ['please']\nrepeat: ['a']"), "")
      << "without what is ignored they are the same";
}

TEST(VocabularyFile, YesNoAndWhatIsSaidMustBeThere) {
  const auto fault = [](const std::string& text) -> std::string {
    try {
      Vocabulary::fromYaml(text, "words.yaml");
    } catch (const YamlError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(fault(""), "words.yaml:1:1: expected words for yes and no, found nothing");
  EXPECT_EQ(fault("- 'yes'"),
            "words.yaml:1:1: expected a map with 'yes', 'no' and 'say', found a list");
  EXPECT_NE(fault("'yes': ['yes']").find("expected 'no'"), std::string::npos);
  EXPECT_NE(fault("'yes': [a]\n'no': [b]").find("expected 'say'"), std::string::npos);
  EXPECT_NE(fault("'yes': [a]\n'no': [b]\nsay: {which: w}").find("'answers'"), std::string::npos);
  EXPECT_NE(fault("'yes': [a]\n'no': [b]\nsay: {numbered: '{0}'}").find("{1}"), std::string::npos);
}

class SpokenLaundry : public testing::Test {
 protected:
  SpokenQuestion several_{english(), "which?", "I have two pegs.", laundry(), 2};
  SpokenQuestion one_{english(), "Does it matter to you that it rains?", "", {"it rains"}, 1};
};

TEST_F(SpokenLaundry, IsAskedWithNumbers) {
  EXPECT_EQ(several_.asked().find("Which of these matter to you? one: the towel hangs"), 0U)
      << several_.asked();
  EXPECT_NE(several_.asked().find("three: the sports shirt hangs on the clothes horse."),
            std::string::npos);
  EXPECT_EQ(one_.asked(), "Does it matter to you that it rains?");
}

TEST_F(SpokenLaundry, AnswersEndIt) {
  ASSERT_TRUE(several_.hear("two").reply);
  EXPECT_EQ(several_.hear("two").reply->chosen, std::vector<std::size_t>{1});
  EXPECT_EQ(one_.hear("no").reply->kind, Kind::No);
}

TEST_F(SpokenLaundry, ItRepeatsAndGivesItsReasonAsOftenAsOneAsks) {
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(several_.hear("say that again").say, several_.asked());
    EXPECT_EQ(several_.hear("why?").say, "I have two pegs.");
  }
  EXPECT_EQ(one_.hear("why").say, "I have no reason to give.");
}

TEST_F(SpokenLaundry, ItSaysSorrySoManyTimesAndStillUnderstands) {
  EXPECT_EQ(one_.hear("bananas").say.find("Sorry? Does it matter"), 0U);
  EXPECT_EQ(one_.hear("bananas").say, "");
  EXPECT_EQ(one_.hear("yes").reply->kind, Kind::Yes);
}

TEST_F(SpokenLaundry, ItAsksAgainAfterSilenceSoManyTimes) {
  EXPECT_EQ(several_.silence().find(several_.asked()), 0U);
  EXPECT_NE(several_.silence(), "");
  EXPECT_EQ(several_.silence(), "");
}

}  // namespace
}  // namespace goal_alignment::phrasing
