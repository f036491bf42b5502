// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/outcomes.h"

#include <algorithm>

namespace goal_alignment::phrasing {

namespace {

/// More clauses than a person listens to.
constexpr std::size_t kNamed = 5;

/// "a", "a; and b", "a; b; c; d; e; and 3 more", each with `before` it.
std::string listed(const Phrases& phrases, const std::vector<Literal>& fluents,
                   const std::string& before = "") {
  const std::size_t named = fluents.size() > kNamed + 1 ? kNamed : fluents.size();
  std::string text;
  for (std::size_t i = 0; i < named; ++i) {
    const bool last = i + 1 == fluents.size();
    text += (i == 0 ? "" : last ? "; and " : "; ") + before + phrases.clause(fluents[i]);
  }
  if (named < fluents.size()) text += "; and " + std::to_string(fluents.size() - named) + " more";
  return text;
}

}  // namespace

std::string goalUnsolvable(const Phrases& phrases, const std::vector<Literal>& specified) {
  const std::string what = specified.empty() ? "" : ": " + listed(phrases, specified);
  return "I can't do what you asked for" + what + ". That is certain.";
}

std::string expectationUnachievable(const Phrases& phrases, const std::vector<Literal>& conflict,
                                    const std::vector<std::vector<Literal>>& alternatives) {
  const std::size_t spoken = std::min(alternatives.size(), kSpokenAlternatives);
  const std::vector<std::vector<Literal>> first(
      alternatives.begin(), alternatives.begin() + static_cast<std::ptrdiff_t>(spoken));
  std::string text = phrases.reason(conflict, true) + " That is certain.";
  if (spoken > 0) text += " " + phrases.alternatives(first);
  const std::size_t more = alternatives.size() - spoken;
  if (more == 1) text += " There is one more way.";
  if (more > 1) text += " There are " + std::to_string(more) + " more ways.";
  return text;
}

std::string unsureBlocks(const Phrases& phrases, const std::vector<Literal>& conflict, bool proven,
                         const std::vector<Literal>& deciding) {
  const std::string which = deciding.size() > 1 ? "which of these matter" : "whether this matters";
  return phrases.reason(conflict, proven) + " It depends on " + which +
         " to you: " + listed(phrases, deciding) + ".";
}

std::string leftOpen(const Phrases& phrases, const std::vector<Literal>& conflict) {
  return phrases.reason(conflict, false) + " My limits did not let me find out more.";
}

std::string planWithout(const Phrases& phrases, const std::vector<Literal>& assumed_not_wanted) {
  return "I have a plan for what you asked for and all that you did not answer with no. Nobody was "
         "asked about this, and I do not promise it: " +
         listed(phrases, assumed_not_wanted) + ".";
}

std::string supposition(const Phrases& phrases, const std::vector<Literal>& wanted,
                        const std::vector<Literal>& not_wanted) {
  std::string text = "If it ";
  if (!wanted.empty()) text += "mattered " + listed(phrases, wanted, "that ");
  if (!wanted.empty() && !not_wanted.empty()) text += ", and ";
  if (!not_wanted.empty()) text += "did not matter " + listed(phrases, not_wanted, "that ");
  return text;
}

}  // namespace goal_alignment::phrasing
