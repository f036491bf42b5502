// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/questions/policy.h"

#include <array>
#include <stdexcept>
#include <utility>

#include "ask_all_policy.h"
#include "auto_policy.h"
#include "goal_alignment/common/listed.h"
#include "optimal_policy.h"
#include "paper_policy.h"
#include "ratio_policy.h"

namespace goal_alignment::questions {

namespace {

template <typename Kind>
std::unique_ptr<Policy> make(PolicyContext context) {
  return std::make_unique<Kind>(std::move(context));
}

struct Entry {
  const char* name;
  std::unique_ptr<Policy> (*make)(PolicyContext);
};

constexpr std::array<Entry, 5> kPolicies = {{
    {"auto", make<AutoPolicy>},
    {"optimal", make<OptimalPolicy>},
    {"ratio", make<RatioPolicy>},
    {"paper", make<PaperPolicy>},
    {"ask-all", make<AskAllPolicy>},
}};

}  // namespace

std::vector<std::string> policyNames() {
  std::vector<std::string> names;
  names.reserve(kPolicies.size());
  for (const Entry& entry : kPolicies)
    names.emplace_back(entry.name);
  return names;
}

std::unique_ptr<Policy> makePolicy(const std::string& name, PolicyContext context) {
  for (const Entry& entry : kPolicies) {
    if (name == entry.name) return entry.make(std::move(context));
  }
  throw std::invalid_argument("unknown policy '" + name + "'; there are: " +
                              listed(kPolicies, [](const Entry& entry) { return entry.name; }));
}

}  // namespace goal_alignment::questions
