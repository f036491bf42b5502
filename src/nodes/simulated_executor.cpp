// SPDX-License-Identifier: BSD-3-Clause
// Offers execute_plan without a robot: what no mapping speaks of is simulated.
#include "executor_main.h"

int main(int argc, char** argv) {
  using goal_alignment::execution::StepKind;
  return goal_alignment::nodes::runExecutor(argc, argv, "simulated_executor", StepKind::Simulated);
}
