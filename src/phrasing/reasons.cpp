// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "goal_alignment/phrasing/phrases.h"

/// Why something is asked, where the answers lead, and what there is instead.
namespace goal_alignment::phrasing {

using questions::Prospect;
using questions::Reason;
using Ending = questions::Prospect::Ending;

namespace {

/// More reasons than a person listens to.
constexpr std::size_t kMostReasons = 3;

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) {
    if (!sentence.empty()) text += (text.empty() ? "" : " ") + sentence;
  }
  return text;
}

std::string ifNo(const Prospect& prospect, bool group, bool provisional) {
  const std::string condition = group ? "If none of them does, " : "If not, ";
  if (prospect.ending == Ending::Plan) {
    return condition +
           (provisional ? "nothing that I know of stands in the way." : "I can do all the rest.");
  }
  if (prospect.ending != Ending::Open || prospect.settled == 0) return "";
  return condition + "I need not ask about " +
         (prospect.settled == 1 ? "one other thing."
                                : std::to_string(prospect.settled) + " other things.");
}

std::string ifYes(const Prospect& prospect, bool group, bool conflict) {
  const std::string condition = group ? "If all of them do, " : "If it does, ";
  switch (prospect.ending) {
    case Ending::NoPlan:
      return condition + "I can't do all that you want.";
    case Ending::Undecided:
      return condition + "I don't know whether I can do all that you want.";
    case Ending::Open:
      return conflict ? condition + "something else has to give way." : "";
    case Ending::Plan:
      break;
  }
  return "";
}

}  // namespace

std::string Phrases::why(const std::vector<Reason>& reasons, const Prospect& if_yes,
                         const Prospect& if_no, bool provisional) const {
  std::vector<Reason> distinct;
  for (const Reason& reason : reasons) {
    const bool says_something = !reason.conflict.empty() || reason.extra_cost > 0;
    if (!says_something || std::count(distinct.begin(), distinct.end(), reason) > 0) continue;
    distinct.push_back(reason);
  }
  std::vector<std::string> sentences;
  bool conflict = false;
  for (std::size_t i = 0; i < distinct.size() && i < kMostReasons; ++i) {
    conflict = conflict || !distinct[i].conflict.empty();
    sentences.push_back(!distinct[i].conflict.empty()
                            ? reason(distinct[i].conflict, distinct[i].proven)
                            : "To keep it so costs " + std::to_string(distinct[i].extra_cost) +
                                  " more than a plan for what I know to be wanted.");
  }
  const bool group = reasons.size() > 1;
  if (distinct.size() > kMostReasons) sentences.emplace_back("There are more such reasons.");
  sentences.push_back(ifNo(if_no, group, provisional));
  sentences.push_back(ifYes(if_yes, group, conflict));
  return joined(sentences);
}

std::string Phrases::alternatives(const std::vector<std::vector<Literal>>& given_up) const {
  std::vector<std::string> sentences;
  for (const std::vector<Literal>& set : given_up) {
    std::string clauses;
    for (const Literal& fluent : set)
      clauses += (clauses.empty() ? "" : "; and ") + clause(fluent);
    sentences.push_back((sentences.empty() ? "I can do all but this: " : "Or all but this: ") +
                        clauses + ".");
  }
  return joined(sentences);
}

}  // namespace goal_alignment::phrasing
