// SPDX-License-Identifier: BSD-3-Clause
#include "session_record.h"

#include <cstdint>

namespace goal_alignment::aligner {

void SessionRecord::beginNextGoal() {
  const session::Statistics& statistics = session->statistics();
  usage.waiting_time = 0;
  usage.earlier_thinking = statistics.total;
  usage.earlier_calls = statistics.planner_calls;
  usage.earlier_questions = session->snapshot().questions_asked;
}

double SessionRecord::thinkingTime() const {
  return session->statistics().total - usage.earlier_thinking;
}

std::string SessionRecord::clausesOf(const std::vector<Literal>& fluents) const {
  return phrases.clauses(fluents);
}

std::string SessionRecord::planBreak() const {
  const auto& violation = session->humanPlanViolation();
  if (!violation) return "";
  return phrases.failure(*violation, human_plan.at(violation->step));
}

AlignmentState SessionRecord::stateMessage(const session::Snapshot& now) const {
  AlignmentState state = ros_common::toMessage(now, phrases, answer_times);
  state.session_id = labels.id;
  state.task_id = labels.task_id;
  state.person = labels.person;
  return state;
}

AlignResult SessionRecord::usageResult(const session::Snapshot& now) const {
  AlignResult result;
  result.failing_step = -1;
  result.session_id = labels.id;
  result.candidates = ros_common::toMessage(now, phrases, answer_times).candidates;
  result.questions = static_cast<std::uint32_t>(now.questions_asked - usage.earlier_questions);
  result.planner_calls =
      static_cast<std::uint32_t>(session->statistics().planner_calls - usage.earlier_calls);
  result.thinking_time = thinkingTime();
  result.waiting_time = usage.waiting_time;
  return result;
}

}  // namespace goal_alignment::aligner
