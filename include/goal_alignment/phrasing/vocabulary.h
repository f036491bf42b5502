// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/phrasing/reply.h"
#include "goal_alignment/phrasing/template_text.h"

/// The words of a spoken dialogue in one language. They come from YAML; `yes` and `no` and all of
/// `say` must be there, everything else may be left out:
///
///     yes: ["yes", "sure"]             # what is heard, also of several words
///     no: ["no"]
///     dont_know: ["don't know"]
///     decline: ["no more questions"]
///     repeat: ["pardon"]
///     why: ["why"]
///     all: ["all of them"]             # of several things
///     none: ["neither"]
///     and: ["and"]                     # between things that are named
///     but: ["not", "but", "except"]    # who says one of these chooses nothing by naming it
///     stand_in: ["one"]                # "the second one": no number, unless it comes first
///     ignored: ["please", "the"]       # words that change nothing
///     numbers: {1: ["one", "first"]}   # single words
///     say:                             # what the robot says
///       which: "Which of these matter to you?"
///       numbered: "{0}: {1}."          # {0}: the number's first word, {1}: what is offered
///       sorry: "Sorry?"
///       answers: "Please say yes, no, or don't know."
///       group_answers: "Please say the numbers, all, or none."
///       no_reason: "I have no reason to give."
///
/// Case, accents and punctuation do not count, and `ß` is `ss`.
namespace goal_alignment::phrasing {

/// What was understood of what a person said.
struct Heard {
  enum class Kind { Reply, Repeat, Why };
  Kind kind = Kind::Reply;
  Reply reply;  ///< of Kind::Reply
};

class Vocabulary {
 public:
  /// Throws YamlError, whose what() is `name:line:column: expected …, found …`. Among its faults:
  /// one text in two lists. O(text).
  static Vocabulary fromYaml(const std::string& text, const std::string& source_name);

  /// Nothing where it is something else, or could mean two things. `offered` are the clauses that
  /// the question offers; of several one may answer with their numbers or with words that only one
  /// of them has. A bare "yes" does not answer "which of these".
  std::optional<Heard> understand(const std::string& said,
                                  const std::vector<std::string>& offered) const;

  const std::string& which() const { return which_; }
  /// "one: the towel is washed." `index` counts from 0; numbers without a word are digits.
  std::string numbered(std::size_t index, const std::string& clause) const;
  const std::string& sorry() const { return sorry_; }
  const std::string& answers(bool several) const { return several ? group_answers_ : answers_; }
  const std::string& noReason() const { return no_reason_; }

 private:
  friend class VocabularyReader;

  enum class Meaning { Yes, No, DontKnow, Decline, Repeat, Why, All, None };
  using Words = std::vector<std::string>;

  std::optional<Meaning> meaningOf(const Words& words) const;
  Words withoutIgnored(const Words& words) const;
  Words withoutStandIns(const Words& words) const;
  static std::optional<Heard> heardAs(Meaning meaning, bool several);
  std::optional<Reply> chosen(Words words, const std::vector<std::string>& offered) const;
  std::optional<Reply> named(const Words& words, const std::vector<std::string>& offered) const;
  std::optional<std::size_t> numberIn(const std::string& word, std::size_t count) const;

  std::map<Words, Meaning> meanings_;  // as they are written, and without ignored words
  std::set<std::string> and_;
  std::set<std::string> but_;
  std::set<std::string> stand_in_;
  std::set<std::string> ignored_;
  std::map<std::string, std::size_t> numbers_;       // from 1
  std::map<std::size_t, std::string> number_words_;  // the first of each
  std::string which_;
  TemplateText numbered_;
  std::string sorry_;
  std::string answers_;
  std::string group_answers_;
  std::string no_reason_;
};

/// The words of a text as folded() has them, without punctuation but for apostrophes within them.
std::vector<std::string> wordsOf(const std::string& text);

}  // namespace goal_alignment::phrasing
