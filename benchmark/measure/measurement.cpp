// SPDX-License-Identifier: BSD-3-Clause
#include "measurement.h"

#include <algorithm>
#include <set>

#include "goal_alignment/common/stopwatch.h"

namespace goal_alignment::benchmarks {
namespace {

std::string statusOf(const search::Result& result) {
  if (result.status == search::Status::Solved) return "solved";
  if (result.status == search::Status::Unsolvable) return "unsolvable";
  return std::string("limit: ") + toString(result.limit);
}

void recordSession(const session::Session& session, Record& record) {
  const session::Snapshot view = session.snapshot();
  const session::Statistics& spent = session.statistics();
  const auto& candidates = view.candidates;
  const auto& conflicts = view.conflicts;
  record.set("candidates", candidates.size());
  record.set("candidates_static", static_cast<std::size_t>(std::count_if(
                                      candidates.begin(), candidates.end(),
                                      [](const auto& each) { return each.is_static; })));
  record.set("questions", session.questions().size());
  record.set("conflicts", conflicts.size());
  record.set("checks", spent.planner_calls);
  record.set("checks_unknown", static_cast<std::size_t>(
                                   std::count_if(conflicts.begin(), conflicts.end(),
                                                 [](const auto& each) { return !each.proven; })));
  record.set("parse", spent.parse);
  record.set("ground", spent.ground);
  record.set("belief", spent.belief);
  record.set("conflict_s", spent.conflicts);
  record.set("question_s", spent.questions);
  record.set("plan", spent.plan);
  record.set("total", spent.total);
}

}  // namespace

Limits MeasureLimits::soft() const {
  Limits limits;
  limits.bytes = accountable(mebibytes << 20U);
  return limits.withSeconds(seconds);
}

void measureCall(const pddl::Source& domain, const pddl::Source& problem, CallKind kind,
                 const MeasureLimits& limits, Record& record) {
  const Stopwatch watch;
  const SingleCall call = singleCall(domain, problem, kind, limits.soft());
  record.set("total", watch.seconds());
  const bool limited = call.result.status == search::Status::LimitReached;
  record.set("status", statusOf(call.result));
  record.set("objects", call.objects);
  record.set("facts", call.facts);
  record.set("operators", call.operators);
  if (call.result.status == search::Status::Solved) {
    record.set("cost", static_cast<double>(call.result.cost));
    record.set("steps", call.plan.size());
  }
  record.set("expanded", static_cast<std::size_t>(call.result.statistics.expanded));
  record.set("evaluated", static_cast<std::size_t>(call.result.statistics.evaluated));
  const auto evaluated = static_cast<double>(call.result.statistics.evaluated);
  record.set("evaluations_per_s", call.search > 0 ? evaluated / call.search : 0);
  record.set("parse", call.parse);
  record.set("ground", call.ground);
  record.set("mutexes", call.mutexes);
  record.set("search", call.search);
  record.set("checks", std::size_t{1});
  record.set("checks_unknown", std::size_t{limited ? 1U : 0U});
}

void measureAlignment(const AlignmentWork& work, const MeasureLimits& limits, Record& record,
                      const Save& save) {
  session::Options options;
  options.policy = work.dialogue.policy;
  options.conflicts = work.dialogue.conflicts;
  options.threads = work.dialogue.threads;
  options.time_limit = limits.seconds;
  options.memory_limit = limits.mebibytes << 20U;
  const std::set<Literal> wanted(work.true_goal.begin(), work.true_goal.end());
  session::Session session(options);
  session.begin(work.input);
  Stopwatch since_answer;
  double first = -1;
  double longest = 0;
  const auto waited = [&] {
    const double seconds = since_answer.lap();
    if (first < 0) {
      first = seconds;
    } else {
      longest = std::max(longest, seconds);
    }
  };
  while (session.step() != session::State::Done) {
    if (session.state() != session::State::AwaitingAnswer) continue;
    waited();
    const std::vector<Literal> fluents = session.question()->fluents;
    recordSession(session, record);
    save();
    since_answer.lap();
    for (const Literal& fluent : fluents) {
      session.answer({fluent},
                     wanted.count(fluent) > 0 ? session::AnswerKind::Yes : session::AnswerKind::No,
                     "true goal");
    }
  }
  waited();
  record.set("status", std::string(session::outcomeWord(session.outcome().code)));
  if (session.robotModel() != nullptr) record.set("objects", session.robotModel()->objects.size());
  recordSession(session, record);
  record.set("operators", operatorCount(work.input.robot_domain, work.input.robot_problem));
  record.set("first_question", first);
  record.set("longest_step", longest);
}

}  // namespace goal_alignment::benchmarks
