// SPDX-License-Identifier: BSD-3-Clause
#include "query_services.h"

#include <chrono>
#include <cstdint>

#include "goal_alignment/Explain.h"
#include "goal_alignment/Validate.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/ros_common/names.h"

namespace goal_alignment::aligner {
namespace {

constexpr std::uint32_t kExplainThreads = 2;  // each may wait until a reason is found

void validate(const Validate::Request& request, Validate::Response& response) {
  response.errors = pddl::faults({"domain", request.domain}, {"problem", request.problem});
  response.valid = response.errors.empty();
}

}  // namespace

QueryServices::QueryServices(const ros::NodeHandle& private_node, Explainer& explainer)
    : validate_(private_node, 1), explain_(private_node, kExplainThreads) {
  validate_.add<Validate>(ros_common::kValidateService, validate);
  explain_.add<Explain>(ros_common::kExplainService,
                        [&explainer](const Explain::Request& request, Explain::Response& response) {
                          response = explainer.explain(
                              request, std::chrono::duration<double>(ros_common::kExplainSeconds));
                        });
}

void QueryServices::start() {
  validate_.start();
  explain_.start();
}

}  // namespace goal_alignment::aligner
