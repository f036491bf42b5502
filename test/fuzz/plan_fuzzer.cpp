// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <string>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/parser.h"
#include "promise.h"
#include "targets.h"

namespace goal_alignment::fuzz {

namespace {

/// parse() and text() are each other's inverse on what is read.
template <typename Value>
void checkText(const Value& value) {
  promise(Value::parse(value.text()) == value, "text() is read back: " + value.text());
}

template <typename Value>
void parseAlone(std::string_view text) {
  try {
    checkText(Value::parse(text));
  } catch (const std::invalid_argument& refused) {
    promiseMessage(refused.what());
  }
}

}  // namespace

void plan(std::string_view bytes) {
  const pddl::Source source{"x", std::string(bytes)};
  isRead([&] {
    const pddl::PlanText plan = pddl::parsePlan(source);
    promise(plan.steps.size() == plan.positions.size(), "each step has a position");
    for (const GroundName& step : plan.steps)
      checkText(step);
  });
  isRead([&] {
    for (const Literal& literal : pddl::parseLiterals(source))
      checkText(literal);
  });
  isRead([&] { checkText(pddl::parseStep(source)); });
  parseAlone<GroundName>(bytes);
  parseAlone<Literal>(bytes);
}

}  // namespace goal_alignment::fuzz
