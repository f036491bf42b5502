// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_models.h"

#include <exception>

#include "align_goal_reader.h"

namespace goal_alignment::aligner {
namespace {

constexpr double kSeconds = 5;  // for one pair of files
constexpr std::size_t kBytes = std::size_t{1} << 30U;

}  // namespace

ParameterModels::Model ParameterModels::robot(std::string& why_not) {
  return read(robot_, &session::Input::robot_domain, &session::Input::robot_problem, why_not);
}

ParameterModels::Model ParameterModels::human(std::string& why_not) {
  return read(human_, &session::Input::human_domain, &session::Input::human_problem, why_not);
}

ParameterModels::Model ParameterModels::read(Read& last, File domain, File problem,
                                             std::string& why_not) {
  try {
    const session::Input files = parameterModels(NodeOptions::read(private_node_));
    return of(last, files.*domain, files.*problem, why_not);
  } catch (const std::exception& error) {
    why_not = error.what();
    return nullptr;
  }
}

ParameterModels::Model ParameterModels::of(Read& last, const pddl::Source& domain,
                                           const pddl::Source& problem, std::string& why_not) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool known = last.model || !last.why_not.empty();
  if (!known || last.domain != domain.text || last.problem != problem.text) {
    last = {domain.text, problem.text, nullptr, ""};
    Limits limits;
    limits.bytes = kBytes;
    try {
      last.model = std::make_shared<const pddl::Model>(
          pddl::readModel(domain, problem, limits.withSeconds(kSeconds)));
    } catch (const std::exception& error) {
      last.why_not = error.what();
    }
  }
  why_not = last.why_not;
  return last.model;
}

}  // namespace goal_alignment::aligner
