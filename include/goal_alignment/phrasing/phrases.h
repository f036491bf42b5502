// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/phrasing/frames.h"
#include "goal_alignment/phrasing/template_text.h"
#include "goal_alignment/questions/answer_effect.h"
#include "goal_alignment/questions/reason.h"
#include "goal_alignment/validation/execution.h"

/// Turns fluents, questions and reasons into sentences. Templates come from YAML; every section may
/// be left out, names match without case:
///
///     language: en                 # of config/phrases, or FILE.yaml beside this file
///     predicates:
///       made-with: "{0} is made with {1}"        # {n}: the n-th argument, counted from 0
///       on-high-shelf:
///         affirmative: "{0} is on the high shelf"
///         negated: "{0} is no longer on the high shelf"
///     objects:
///       good-leaves: "the good leaves"
///     actions:
///       go: "go from {0} to {1}"
///     frames:                      # instead of texts of the language
///       certain: "I am sure of it."
///
/// Where a clause reads otherwise after "that", it has the forms `that` and `that_not`. Where an
/// object reads otherwise in some places, it has forms of any name, and a gap says which it takes:
///
///     language: de
///     predicates:
///       kettle-at:
///         affirmative: "der Kessel steht {0:wo}"
///         that: "der Kessel {0:wo} steht"
///     objects:
///       sink: {name: "die Spüle", wo: "auf der Spüle"}
///
/// A name without a template, or whose template asks for more arguments than it has, is read out so
/// that somebody who never saw PDDL can follow: `"made with" holds for tea and good leaves`.
namespace goal_alignment::phrasing {

class Phrases {
 public:
  /// No templates, in English: everything is read out as it is written.
  Phrases() = default;

  /// Throws YamlError. `source_name` is what the error calls the text; a language's file is looked
  /// for in its folder. O(text).
  static Phrases fromYaml(const std::string& text, const std::string& source_name);

  /// A clause: "the tea is made with the good leaves". Negated, without a template for it: "it is
  /// not so that …".
  std::string clause(const Literal& fluent) const;

  /// The same after "that": "that the tea is made with the good leaves".
  std::string that(const Literal& fluent) const;

  /// "a", "a, and b", "a; b; and c".
  std::string clauses(const std::vector<Literal>& fluents) const;
  std::string thats(const std::vector<Literal>& fluents) const;
  /// The same, but of more than a person listens to the first ones, "a; b; and 3 more".
  std::string fewClauses(const std::vector<Literal>& fluents) const;

  /// "Does it matter to you that …?": a spoken yes means wanted. Several fluents, of which any may
  /// be named: "Which of these matter to you: that …; that …; and that …?". None: an empty text.
  /// `at_end`: they may be so for a while and then no more, "When I'm done, does it …".
  std::string question(const std::vector<Literal>& fluents, bool at_end = false) const;

  /// Why it is asked: "I can't have both: …, and ….". `proven` false: "I could not find out …".
  /// `alone`: the one fluent can't be had whatever else is asked for. An empty conflict gives an
  /// empty text.
  std::string reason(const std::vector<Literal>& conflict, bool proven, bool alone = false) const;

  /// Why a question is asked and where the answers lead: the reasons, each once and few of them,
  /// then "If not, I can do all the rest.", "If it does, I have to leave something else out."
  /// `provisional`: there may be conflicts that nobody knows yet.
  std::string why(const std::vector<questions::Reason>& reasons,
                  const questions::AnswerEffect& if_yes, const questions::AnswerEffect& if_no,
                  bool provisional) const;

  /// What can be had instead: "I can do everything except: …. Or everything except: ….", in the
  /// order given.
  std::string alternatives(const std::vector<std::vector<Literal>>& given_up) const;

  /// "go from the hallway to the table", or without a template "go: hallway, table".
  std::string action(const GroundName& step) const;

  /// "step 3 (climb the ladder) can't be done: …". `step` is the plan's at violation.step.
  std::string failure(const validation::Violation& violation, const GroundName& step) const;

  /// A text from elsewhere, in which each `(name argument …)` that has a template is put in words:
  /// "step 1 (go from the hallway to the table) failed".
  std::string inWords(const std::string& text) const;

  /// "the good leaves", or without a template "good leaves".
  std::string object(const std::string& name) const;

  /// The language's texts.
  const Frames& frames() const { return *frames_; }
  /// The one called `name`.
  std::string say(const std::string& name, const std::vector<std::string>& arguments = {}) const;
  std::string counted(const std::string& name, std::size_t number,
                      const std::vector<std::string>& more = {}) const;

  /// What the reader of a log should know: "de.yaml lacks …, which is said in English". Empty:
  /// nothing.
  const std::string& warning() const { return warning_; }

 private:
  friend class PhraseReader;

  /// The sentences of one predicate.
  struct Forms {
    std::optional<TemplateText> affirmative;
    std::optional<TemplateText> negated;
    std::optional<TemplateText> that;
    std::optional<TemplateText> that_not;
  };
  using Form = std::optional<TemplateText> Forms::*;
  enum class Place : std::uint8_t { Alone, AfterThat };

  Filling filling(const std::string& name) const;
  std::vector<Filling> fillings(const GroundName& ground) const;
  std::vector<std::string> spokenArguments(const GroundName& ground) const;
  std::optional<std::string> form(const GroundName& atom, Form form) const;
  std::string bareClause(const Literal& fluent, Place place) const;
  std::string enumeration(const std::vector<std::string>& words) const;
  std::string enumerationOfClauses(const std::vector<std::string>& clauses,
                                   std::size_t named) const;
  using Spoken = std::string (Phrases::*)(const Literal&) const;
  std::string listed(const std::vector<Literal>& fluents, Spoken spoken, bool whole) const;
  std::string reasonOf(const validation::Violation& violation) const;
  std::optional<std::string> wordsFor(const std::string& pddl) const;

  std::map<std::string, Forms> predicates_;  ///< by name, in lower case like the rest
  std::map<std::string, TemplateText> actions_;
  std::map<std::string, Filling> objects_;
  Frames::Shared frames_ = Frames::english();
  std::string warning_;
};

}  // namespace goal_alignment::phrasing
