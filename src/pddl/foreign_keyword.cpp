// SPDX-License-Identifier: BSD-3-Clause
#include "foreign_keyword.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "goal_alignment/common/quote.h"

namespace goal_alignment::pddl {

namespace {

/// A keyword that we know of and do not treat.
struct Foreign {
  std::string_view keyword;
  const char* what;  ///< where the keyword does not say enough
};

constexpr const char* kHierarchy = "hierarchical planning";
constexpr const char* kSensing = "sensing";
constexpr const char* kStreams = "PDDLStream";
constexpr const char* kSeveralAgents = "several agents";
constexpr const char* kProbability = "probabilistic planning";
constexpr const char* kTime = "a durative action";
constexpr const char* kVariables = "variables beside parameters";

/// PDDL 3.1 and before, PDDL+, HDDL, UCPOP's and PDDL 1.2's expansions, PDDLStream, MA-PDDL, PPDDL,
/// and what planners under partial observability read.
constexpr std::array<Foreign, 53> kForeign{{
    {":durative-action", ""},
    {":derived", ""},
    {":axiom", ""},
    {":constraints", ""},
    {":process", ""},
    {":event", ""},
    {":extends", ""},
    {":timeless", ""},
    {":safety", ""},
    {":domain-variables", ""},
    {":length", ""},
    {":situation", ""},
    {":duration", kTime},
    {":condition", kTime},
    {":vars", kVariables},
    {":domain-axioms", ""},
    {":task", kHierarchy},
    {":tasks", kHierarchy},
    {":method", kHierarchy},
    {":methods", kHierarchy},
    {":htn", kHierarchy},
    {":subtasks", kHierarchy},
    {":ordered-subtasks", kHierarchy},
    {":ordered-tasks", kHierarchy},
    {":ordering", kHierarchy},
    {":expansion", kHierarchy},
    {":maintain", kHierarchy},
    {":only-in-expansions", kHierarchy},
    {":modules", "calls to modules"},
    {":stream", kStreams},
    {":rule", kStreams},
    {":observe", kSensing},
    {":observation", kSensing},
    {":observations", kSensing},
    {":observable", kSensing},
    {":sensor", kSensing},
    {":sensors", kSensing},
    {":sense", kSensing},
    {":sensing", kSensing},
    {":sensing-action", kSensing},
    {":belief", kSensing},
    {":init-belief", kSensing},
    {":initial-belief", kSensing},
    {":hidden", kSensing},
    {":uncertain", kSensing},
    {":agent", kSeveralAgents},
    {":agents", kSeveralAgents},
    {":private", kSeveralAgents},
    {":factored-privacy", kSeveralAgents},
    {":probability", kProbability},
    {":goal-probability", kProbability},
    {":goal-reward", kProbability},
    {":reward", kProbability},
}};

}  // namespace

void refuseForeign(const TokenReader& reader) {
  const auto* const found =
      std::find_if(kForeign.begin(), kForeign.end(),
                   [&](const Foreign& foreign) { return reader.atWord(foreign.keyword); });
  if (found == kForeign.end()) return;
  const std::string what = *found->what == '\0' ? "" : " (" + std::string(found->what) + ")";
  reader.failUnsupported(reader.current().position, inQuotes(found->keyword) + what);
}

}  // namespace goal_alignment::pddl
