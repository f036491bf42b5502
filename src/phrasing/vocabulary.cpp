// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/vocabulary.h"

#include <algorithm>
#include <iterator>

#include "goal_alignment/phrasing/folding.h"

namespace goal_alignment::phrasing {

namespace {

constexpr const char* kTypographicApostrophe = "\u2019";
constexpr std::size_t kMaxWords = 50;  // of an answer

// Bytes beyond ASCII belong to letters.
bool isInWord(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '\'';
}

std::string withPlainApostrophes(std::string text) {
  const std::string fancy = kTypographicApostrophe;
  for (std::size_t at = text.find(fancy); at != std::string::npos; at = text.find(fancy, at))
    text.replace(at, fancy.size(), "'");
  return text;
}

}  // namespace

std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : folded(withPlainApostrophes(text)) + " ") {
    if (isInWord(c)) {
      word += c;
      continue;
    }
    const std::size_t first = word.find_first_not_of('\'');
    if (first != std::string::npos)
      words.push_back(word.substr(first, word.find_last_not_of('\'') + 1 - first));
    word.clear();
  }
  return words;
}

std::string Vocabulary::numbered(std::size_t index, const std::string& clause) const {
  const auto word = number_words_.find(index + 1);
  const std::string number = word == number_words_.end() ? std::to_string(index + 1) : word->second;
  return numbered_.fill({number, clause}).value_or(clause);
}

Vocabulary::Words Vocabulary::withoutIgnored(const Words& words) const {
  Words result;
  std::copy_if(words.begin(), words.end(), std::back_inserter(result),
               [this](const std::string& word) { return ignored_.count(word) == 0; });
  return result;
}

Vocabulary::Words Vocabulary::withoutStandIns(const Words& words) const {
  Words result;
  bool after_ordinal = false;
  for (const std::string& word : words) {
    if (!after_ordinal || stand_in_.count(word) == 0) result.push_back(word);
    const auto number = numbers_.find(word);
    after_ordinal =
        number != numbers_.end() && wordsOf(number_words_.at(number->second)).front() != word;
  }
  return result;
}

// In words, 0 for none.
std::size_t Vocabulary::longestOf(const PhraseSet& phrases, const Words& words, std::size_t at) {
  std::size_t longest = 0;
  for (const Words& phrase : phrases) {
    const bool fits =
        phrase.size() <= words.size() - at &&
        std::equal(phrase.begin(), phrase.end(), words.begin() + static_cast<std::ptrdiff_t>(at));
    if (fits) longest = std::max(longest, phrase.size());
  }
  return longest;
}

// In words, the longest first; what changes nothing counts as one, too.
std::vector<std::size_t> Vocabulary::lengthsAt(const Words& words, std::size_t at) const {
  std::vector<std::size_t> lengths;
  const auto first = words.begin() + static_cast<std::ptrdiff_t>(at);
  const std::size_t beside =
      std::max<std::size_t>(longestOf(beside_, words, at), ignored_.count(*first) > 0 ? 1 : 0);
  for (std::size_t length = std::min(longest_, words.size() - at); length > 0; --length) {
    const Words text(first, first + static_cast<std::ptrdiff_t>(length));
    if (meanings_.count(text) > 0 || length == beside) lengths.push_back(length);
  }
  return lengths;
}

// The words as texts of the lists, as long as can be from the left; none where a word is left over.
std::vector<Vocabulary::Words> Vocabulary::textsOf(const Words& words) const {
  std::vector<std::size_t> ends = {0};
  std::vector<std::vector<std::size_t>> untried;
  std::vector<bool> leads_nowhere(words.size() + 1, false);
  if (words.size() > kMaxWords) return {};
  while (!ends.empty() && ends.back() < words.size()) {
    const std::size_t at = ends.back();
    if (untried.size() < ends.size()) {
      untried.push_back(leads_nowhere[at] ? std::vector<std::size_t>() : lengthsAt(words, at));
      std::reverse(untried.back().begin(), untried.back().end());
    }
    if (untried.back().empty()) {
      leads_nowhere[at] = true;
      ends.pop_back();
      untried.pop_back();
    } else {
      ends.push_back(at + untried.back().back());
      untried.back().pop_back();
    }
  }
  std::vector<Words> texts;
  for (std::size_t i = 1; i < ends.size(); ++i)
    texts.emplace_back(words.begin() + static_cast<std::ptrdiff_t>(ends[i - 1]),
                       words.begin() + static_cast<std::ptrdiff_t>(ends[i]));
  return texts;
}

std::set<Vocabulary::Meaning> Vocabulary::meaningsOfAll(const Words& words) const {
  std::set<Meaning> meanings;
  bool negates = false;
  for (const Words& text : textsOf(words)) {
    const auto meaning = meanings_.find(text);
    if (meaning == meanings_.end()) continue;  // it stands beside
    // "Not really" says no, and so does "unimportant"; "not really unimportant" does not.
    if (negates && any_.count(text) > 0) return {};
    const auto is_but = [this](const std::string& word) { return but_.count(word) > 0; };
    negates = text.size() > 1 && std::any_of(text.begin(), text.end(), is_but);
    meanings.insert(meaning->second);
  }
  return meanings;
}

std::set<Vocabulary::Meaning> Vocabulary::meaningsOf(const Words& words) const {
  const std::set<Meaning> meanings = meaningsOfAll(words);
  return meanings.empty() ? meaningsOfAll(withoutIgnored(words)) : meanings;
}

// "No, none of them" and "yes, all of them" say one thing twice.
std::optional<Heard> Vocabulary::heardAs(std::set<Meaning> meanings, bool several) {
  if (meanings.count(Meaning::All) > 0 && meanings.count(Meaning::Yes) > 0)
    meanings.erase(several ? Meaning::Yes : Meaning::All);
  if (meanings.count(Meaning::None) > 0 && meanings.count(Meaning::No) > 0)
    meanings.erase(several ? Meaning::No : Meaning::None);
  return meanings.size() == 1 ? heardAs(*meanings.begin(), several) : std::nullopt;
}

std::optional<Heard> Vocabulary::heardAs(Meaning meaning, bool several) {
  const auto reply = [](Reply::Kind kind) { return Heard{Heard::Kind::Reply, {kind, {}}}; };
  switch (meaning) {
    case Meaning::Yes:
      return several ? std::nullopt : std::optional(reply(Reply::Kind::Yes));
    case Meaning::All:
      return several ? std::optional(reply(Reply::Kind::Yes)) : std::nullopt;
    case Meaning::No:
      return reply(Reply::Kind::No);
    case Meaning::None:
      return several ? std::optional(reply(Reply::Kind::No)) : std::nullopt;
    case Meaning::DontKnow:
      return reply(Reply::Kind::Unsure);
    case Meaning::Decline:
      return reply(Reply::Kind::Decline);
    case Meaning::Repeat:
      return Heard{Heard::Kind::Repeat, {}};
    case Meaning::Why:
      return Heard{Heard::Kind::Why, {}};
    case Meaning::Agreed:
      break;
  }
  return std::nullopt;
}

std::optional<Heard> Vocabulary::understand(const std::string& said,
                                            const std::vector<std::string>& offered) const {
  const Words words = wordsOf(said);
  const bool several = offered.size() > 1;
  const std::set<Meaning> meanings = meaningsOf(words);
  if (!meanings.empty()) return heardAs(meanings, several);
  if (!several) return std::nullopt;
  const auto reply = chosen(words, offered);
  return reply ? std::optional(Heard{Heard::Kind::Reply, *reply}) : std::nullopt;
}

std::optional<Choice> Vocabulary::choiceAs(std::set<Meaning> meanings, std::size_t offered) {
  if (meanings.erase(Meaning::Agreed) > 0) meanings.insert(Meaning::Yes);
  if (meanings.erase(Meaning::None) > 0 || meanings.erase(Meaning::Decline) > 0)
    meanings.insert(Meaning::No);
  if (meanings.size() != 1) return std::nullopt;
  switch (*meanings.begin()) {
    case Meaning::Yes:
      return offered == 1 ? std::optional(Choice{Choice::Kind::One, 0}) : std::nullopt;
    case Meaning::No:
      return Choice{Choice::Kind::None, 0};
    case Meaning::Repeat:
    case Meaning::Why:  // the reason is part of what is said
      return Choice{Choice::Kind::Repeat, 0};
    default:
      return std::nullopt;
  }
}

std::optional<Choice> Vocabulary::choose(const std::string& said,
                                         const std::vector<std::string>& offered) const {
  const Words words = wordsOf(said);
  if (withoutPhrases(any_, words).size() < words.size()) return std::nullopt;
  const std::set<Meaning> meanings = meaningsOf(words);
  if (!meanings.empty()) return choiceAs(meanings, offered.size());
  const Words rest = withoutPhrases(leaving_out_, withoutYes(words));
  auto reply = chosen(rest, offered);
  // "I want the sugar" would leave it out; "I want the second" is clear.
  if (!reply) reply = chosen(withoutPhrases(choosing_, rest), Words(offered.size()));
  if (!reply || reply->chosen.size() != 1) return std::nullopt;
  return Choice{Choice::Kind::One, reply->chosen.front()};
}

Vocabulary::Words Vocabulary::withoutPhrases(const PhraseSet& phrases, const Words& words) {
  Words rest;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t length = longestOf(phrases, words, at);
    if (length == 0) rest.push_back(words[at]);
    at += std::max<std::size_t>(length, 1);
  }
  return rest;
}

// "Yes, the first."
Vocabulary::Words Vocabulary::withoutYes(const Words& words) const {
  for (std::size_t length = std::min(longest_, words.size()); length > 0; --length) {
    if (length == words.size()) continue;
    const auto rest = words.begin() + static_cast<std::ptrdiff_t>(length);
    const auto found = meanings_.find(Words(words.begin(), rest));
    if (found == meanings_.end()) continue;
    const bool is_yes = found->second == Meaning::Yes || found->second == Meaning::Agreed;
    return is_yes ? Words(rest, words.end()) : words;
  }
  return words;
}

std::optional<Reply> Vocabulary::chosen(Words words,
                                        const std::vector<std::string>& offered) const {
  const auto is_joint = [this](const std::string& word) { return and_.count(word) > 0; };
  words = withoutStandIns(withoutIgnored(words));
  words.erase(std::remove_if(words.begin(), words.end(), is_joint), words.end());
  words = withoutYes(words);
  if (meaningsOf(words) == std::set<Meaning>{Meaning::All}) return Reply{Reply::Kind::Yes, {}};
  return named(words, offered);
}

std::optional<std::size_t> Vocabulary::numberIn(const std::string& word, std::size_t count) const {
  const auto number = numbers_.find(word);
  const auto reply =
      parseReply(number == numbers_.end() ? word : std::to_string(number->second), count);
  // Its letters, "y" and the like, are for keyboards.
  if (!reply || reply->chosen.empty()) return std::nullopt;
  return reply->chosen.front();
}

// Every word has to be a number or in what is offered, and at least one in one thing alone: "the
// shirt" chooses nothing where there are two.
std::optional<Reply> Vocabulary::named(const Words& words,
                                       const std::vector<std::string>& offered) const {
  std::vector<std::set<std::string>> names;
  for (const std::string& clause : offered) {
    const Words all = wordsOf(clause);
    names.emplace_back(all.begin(), all.end());
  }
  std::set<std::size_t> chosen;
  for (const std::string& word : words) {
    if (but_.count(word) > 0) return std::nullopt;
    if (const auto number = numberIn(word, offered.size())) {
      chosen.insert(*number);
      continue;
    }
    std::vector<std::size_t> in;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i].count(word) > 0) in.push_back(i);
    if (in.empty()) return std::nullopt;
    if (in.size() == 1) chosen.insert(in.front());
  }
  if (chosen.empty()) return std::nullopt;
  return Reply{Reply::Kind::Yes, {chosen.begin(), chosen.end()}};
}

}  // namespace goal_alignment::phrasing
