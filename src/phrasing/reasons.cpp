// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "goal_alignment/phrasing/phrases.h"

/// What is asked and why, where the answers lead, and what there is instead.
namespace goal_alignment::phrasing {

using questions::AnswerEffect;
using questions::Reason;
using Ending = questions::AnswerEffect::Ending;

namespace {

/// More reasons than a person listens to.
constexpr std::size_t kMaxReasons = 3;

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) {
    if (!sentence.empty()) text += (text.empty() ? "" : " ") + sentence;
  }
  return text;
}

std::string ifNo(const Phrases& phrases, const AnswerEffect& prospect, bool group,
                 bool provisional) {
  const std::string condition = group ? "if_none" : "if_no";
  if (prospect.ending == Ending::Plan)
    return phrases.say(condition + (provisional ? "_ahead" : "_rest"));
  if (prospect.ending != Ending::Open || prospect.settled == 0) return "";
  return phrases.counted(condition + "_saves", prospect.settled);
}

std::string ifYes(const Phrases& phrases, const AnswerEffect& prospect, bool group, bool conflict) {
  const std::string condition = group ? "if_all" : "if_yes";
  switch (prospect.ending) {
    case Ending::NoPlan:
      return phrases.say(condition + "_not_all");
    case Ending::Undecided:
      return phrases.say(condition + "_unknown");
    case Ending::Open:
      return conflict ? phrases.say(condition + "_leaves_out") : "";
    case Ending::Plan:
      break;
  }
  return "";
}

}  // namespace

std::string Phrases::question(const std::vector<Literal>& fluents, bool at_end) const {
  if (fluents.empty()) return "";
  const std::string name = fluents.size() == 1 ? "question" : "questions";
  return say(name + (at_end ? "_at_end" : ""), {thats(fluents)});
}

std::string Phrases::reason(const std::vector<Literal>& conflict, bool proven, bool alone) const {
  if (conflict.empty()) return "";
  const std::string how_many = conflict.size() == 1   ? proven && alone ? "alone" : "one"
                               : conflict.size() == 2 ? "two"
                                                      : "many";
  return say((proven ? "reason_" : "maybe_") + how_many, {clauses(conflict)});
}

std::string Phrases::why(const std::vector<Reason>& reasons, const AnswerEffect& if_yes,
                         const AnswerEffect& if_no, bool provisional) const {
  std::vector<Reason> distinct;
  for (const Reason& reason : reasons) {
    const bool says_something = !reason.conflict.empty() || reason.extra_cost > 0;
    if (!says_something || std::count(distinct.begin(), distinct.end(), reason) > 0) continue;
    distinct.push_back(reason);
  }
  std::vector<std::string> sentences;
  bool conflict = false;
  for (std::size_t i = 0; i < distinct.size() && i < kMaxReasons; ++i) {
    const Reason& each = distinct[i];
    conflict = conflict || !each.conflict.empty();
    sentences.push_back(each.conflict.empty()
                            ? say("reason_cost", {std::to_string(each.extra_cost)})
                            : reason(each.conflict, each.proven, each.alone));
  }
  const bool group = reasons.size() > 1;
  if (distinct.size() > kMaxReasons) sentences.push_back(say("more_reasons"));
  sentences.push_back(ifNo(*this, if_no, group, provisional));
  sentences.push_back(ifYes(*this, if_yes, group, conflict));
  return joined(sentences);
}

std::string Phrases::alternatives(const std::vector<std::vector<Literal>>& given_up) const {
  std::vector<std::string> sentences;
  sentences.reserve(given_up.size());
  for (const std::vector<Literal>& set : given_up)
    sentences.push_back(say(sentences.empty() ? "except" : "or_except", {clauses(set)}));
  return joined(sentences);
}

}  // namespace goal_alignment::phrasing
