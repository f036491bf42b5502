// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/vocabulary.h"

#include <algorithm>
#include <iterator>

#include "goal_alignment/phrasing/folding.h"

namespace goal_alignment::phrasing {

namespace {

constexpr const char* kTypographicApostrophe = "\u2019";

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

std::optional<Vocabulary::Meaning> Vocabulary::meaningOf(const Words& words) const {
  for (const Words& form : {words, withoutIgnored(words)}) {
    const auto found = meanings_.find(form);
    if (found != meanings_.end()) return found->second;
  }
  return std::nullopt;
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
  }
  return std::nullopt;
}

std::optional<Heard> Vocabulary::understand(const std::string& said,
                                            const std::vector<std::string>& offered) const {
  const Words words = wordsOf(said);
  const bool several = offered.size() > 1;
  if (const auto meaning = meaningOf(words)) return heardAs(*meaning, several);
  if (!several) return std::nullopt;
  const auto reply = chosen(words, offered);
  return reply ? std::optional(Heard{Heard::Kind::Reply, *reply}) : std::nullopt;
}

std::optional<Reply> Vocabulary::chosen(Words words,
                                        const std::vector<std::string>& offered) const {
  const auto is_joint = [this](const std::string& word) { return and_.count(word) > 0; };
  words = withoutStandIns(withoutIgnored(words));
  words.erase(std::remove_if(words.begin(), words.end(), is_joint), words.end());
  // "Yes, the first."
  if (words.size() > 1 && meaningOf({words.front()}) == Meaning::Yes) words.erase(words.begin());
  if (meaningOf(words) == Meaning::All) return Reply{Reply::Kind::Yes, {}};
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
