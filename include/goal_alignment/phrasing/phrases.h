// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/phrasing/template_text.h"
#include "goal_alignment/questions/prospect.h"
#include "goal_alignment/questions/reason.h"

/// Turns fluents, questions and reasons into sentences. Templates come from YAML; every section may
/// be left out, names match without case:
///
///     predicates:
///       made-with: "{0} is made with {1}"        # {n}: the n-th argument, counted from 0
///       on-high-shelf:
///         affirmative: "{0} is on the high shelf"
///         negated: "{0} is no longer on the high shelf"
///     objects:
///       good-leaves: "the good leaves"
///     actions:
///       go: "go from {0} to {1}"
///
/// A name without a template, or whose template asks for more arguments than it has, is read out so
/// that somebody who never saw PDDL can follow: `"made with" holds for tea and good leaves`.
namespace goal_alignment::phrasing {

class Phrases {
 public:
  /// No templates: everything is read out as it is written.
  Phrases() = default;

  /// Throws YamlError. `source_name` is what the error calls the text. O(text).
  static Phrases fromYaml(const std::string& text, const std::string& source_name);

  /// A clause: "the tea is made with the good leaves". Negated, without a template for it: "it is
  /// not so that …".
  std::string clause(const Literal& fluent) const;

  /// "Does it matter to you that …?": a spoken yes means wanted. Several fluents, of which any may
  /// be named: "Which of these matter to you: that …; that …; and that …?". None: an empty text.
  std::string question(const std::vector<Literal>& fluents) const;

  /// Why it is asked: "I can't have both: …, and ….". `proven` false: "I could not make sure …".
  /// An empty conflict gives an empty text.
  std::string reason(const std::vector<Literal>& conflict, bool proven) const;

  /// Why a question is asked and where the answers lead: the reasons, each once and few of them,
  /// then "If not, I can do all the rest.", "If it does, something else has to give way."
  /// `provisional`: there may be conflicts that nobody knows yet.
  std::string why(const std::vector<questions::Reason>& reasons, const questions::Prospect& if_yes,
                  const questions::Prospect& if_no, bool provisional) const;

  /// What can be had instead: "I can do all but this: …. Or all but this: ….", in the order given.
  std::string alternatives(const std::vector<std::vector<Literal>>& given_up) const;

  /// "go from the hallway to the table", or without a template "go: hallway, table".
  std::string action(const GroundName& step) const;

  /// "the good leaves", or without a template "good leaves".
  std::string object(const std::string& name) const;

 private:
  friend class PhraseReader;

  std::vector<std::string> spokenArguments(const GroundName& ground) const;

  std::map<std::string, TemplateText> affirmative_;  ///< by predicate, in lower case like the rest
  std::map<std::string, TemplateText> negated_;
  std::map<std::string, TemplateText> actions_;
  std::map<std::string, std::string> objects_;
};

}  // namespace goal_alignment::phrasing
