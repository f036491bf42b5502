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
///     any: ["I don't care"]            # of these, whatever they mean to a question: they choose
///                                      # none of several alternatives
///     agreed: ["okay"]                 # means yes to an alternative, nothing to a question
///     beside: ["to me", "I think"]     # what may stand beside an answer and changes nothing
///     leaving_out: ["without"]         # before what an alternative leaves out: "without the
///     sugar" choosing: ["I'll take"]          # before an alternative's number, where a name could
///     mean
///                                      # what is to be kept
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
///       # Without all of these no alternatives are offered, and no steps of a plan are said:
///       offer: "I can do everything except one of these."
///       offer_one: "I can do everything except: {0}."
///       choose: "Which one do I leave out?"        # of several
///       choose_one: "Shall I do that?"             # there is one
///       choose_answers: "Please say a number, or none."
///       chosen: "All right."
///       left: "All right, I leave it."
///       plan: "{0} steps: first {1}, last {2}."    # the number of steps, what the first and last
///       is plan_of_one: "I do this: {0}."
///
/// Case, accents, punctuation and apostrophes do not count, and `ß` is `ss`. What is heard may
/// consist of several of these texts, the longest at each place, as long as all mean the same: "no,
/// it doesn't matter".
namespace goal_alignment::phrasing {

/// What was understood of what a person said.
struct Heard {
  enum class Kind { Reply, Repeat, Why };
  Kind kind = Kind::Reply;
  Reply reply;  ///< of Kind::Reply
};

/// What was understood of what a person said to alternatives, of which one can be had.
struct Choice {
  enum class Kind { One, None, Repeat };
  Kind kind = Kind::None;
  std::size_t index = 0;  ///< of Kind::One
};

/// What is said at the end of a task.
struct EndSayings {
  std::string offer;
  TemplateText offer_one;
  std::string choose;
  std::string choose_one;
  std::string choose_answers;
  std::string chosen;
  std::string left;
  TemplateText plan;
  TemplateText plan_of_one;
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

  /// The same of alternatives, which are named by what has to be left out. "Yes" takes the only
  /// one; what would do with any of them takes none.
  std::optional<Choice> choose(const std::string& said,
                               const std::vector<std::string>& offered) const;

  const std::string& which() const { return which_; }
  /// "one: the towel is washed." `index` counts from 0; numbers without a word are digits.
  std::string numbered(std::size_t index, const std::string& clause) const;
  const std::string& sorry() const { return sorry_; }
  const std::string& answers(bool several) const { return several ? group_answers_ : answers_; }
  const std::string& noReason() const { return no_reason_; }
  /// Null where the vocabulary says nothing of ends.
  const EndSayings* atEnd() const { return end_ ? &*end_ : nullptr; }

 private:
  friend class VocabularyReader;

  enum class Meaning { Yes, No, DontKnow, Decline, Repeat, Why, All, None, Agreed };
  using Words = std::vector<std::string>;
  using PhraseSet = std::set<Words>;

  std::set<Meaning> meaningsOf(const Words& words) const;
  std::set<Meaning> meaningsOfAll(const Words& words) const;
  std::vector<std::size_t> lengthsAt(const Words& words, std::size_t at) const;
  std::vector<Words> textsOf(const Words& words) const;
  static std::size_t longestOf(const PhraseSet& phrases, const Words& words, std::size_t at);
  static Words withoutPhrases(const PhraseSet& phrases, const Words& words);
  Words withoutIgnored(const Words& words) const;
  Words withoutStandIns(const Words& words) const;
  Words withoutYes(const Words& words) const;
  static std::optional<Heard> heardAs(std::set<Meaning> meanings, bool several);
  static std::optional<Heard> heardAs(Meaning meaning, bool several);
  static std::optional<Choice> choiceAs(std::set<Meaning> meanings, std::size_t offered);
  std::optional<Reply> chosen(Words words, const std::vector<std::string>& offered) const;
  std::optional<Reply> named(const Words& words, const std::vector<std::string>& offered) const;
  std::optional<std::size_t> numberIn(const std::string& word, std::size_t count) const;

  std::map<Words, Meaning> meanings_;  // as they are written, without ignored words, and both
                                       // without apostrophes
  std::size_t longest_ = 0;            // of meanings_, in words
  PhraseSet any_;
  PhraseSet beside_;
  PhraseSet leaving_out_;
  PhraseSet choosing_;
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
  std::optional<EndSayings> end_;
};

/// The words of a text as folded() has them, without punctuation but for apostrophes within them.
std::vector<std::string> wordsOf(const std::string& text);

}  // namespace goal_alignment::phrasing
