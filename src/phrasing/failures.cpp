// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/phrases.h"

/// Why a step can't be done.
namespace goal_alignment::phrasing {

using Kind = validation::Violation::Kind;

std::string Phrases::reasonOf(const validation::Violation& violation) const {
  switch (violation.kind) {
    case Kind::UnknownAction:
      return say("fails_unknown");
    case Kind::WrongArity:
      return say("fails_number");
    case Kind::UnknownObject:
      return say("fails_object", {object(violation.object)});
    case Kind::WrongType:
      return say("fails_kind", {object(violation.object)});
    case Kind::Precondition:
      break;
  }
  if (violation.missing.empty()) return say("fails_unsaid");
  if (violation.missing.size() > 1) return say("fails_as_none", {fewClauses(violation.missing)});
  const Literal& missing = violation.missing.front();
  return say("fails_as", {clause({missing.atom, !missing.negated})});
}

std::string Phrases::failure(const validation::Violation& violation, const GroundName& step) const {
  const std::string number = std::to_string(violation.step + 1);
  return say("step_fails", {number, action(step), reasonOf(violation)});
}

}  // namespace goal_alignment::phrasing
