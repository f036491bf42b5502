// SPDX-License-Identifier: BSD-3-Clause
// Offers execute_plan on a robot: a mapping says how each action is carried out.
#include "executor_main.h"

int main(int argc, char** argv) {
  return goal_alignment::nodes::runExecutor(argc, argv, "plan_executor", std::nullopt);
}
