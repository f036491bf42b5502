// SPDX-License-Identifier: BSD-3-Clause
#include "open_question.h"

#include <algorithm>
#include <vector>

#include "extra_cost.h"
#include "fluents.h"

namespace goal_alignment::session {

using achievability::CandidateSet;
using achievability::Conflict;
using questions::Knowledge;
using questions::Situation;

namespace {

bool undoes(const pddl::Model& model, const Literal& fluent) {
  const auto predicate = model.findPredicate(fluent.atom.name);
  const auto is_of_predicate = [&](const pddl::LiftedAtom& atom) {
    return atom.predicate == predicate;
  };
  const auto any = [&](const auto& effect) {
    const auto& atoms = fluent.negated ? effect.add : effect.del;
    return std::any_of(atoms.begin(), atoms.end(), is_of_predicate);
  };
  return std::any_of(model.schemas.begin(), model.schemas.end(), [&](const auto& schema) {
    return any(schema) || std::any_of(schema.conditional.begin(), schema.conditional.end(), any);
  });
}

/// Whether the fluent may be so for a while and then no more.
bool mayPass(const alignment::Problem& problem, const Literal& fluent) {
  return undoes(problem.human, fluent) || undoes(problem.robot, fluent);
}

/// Why it is asked as things stand: where an answer to something else has settled the reason that
/// it was asked for, another may be left.
Reason reasonNow(const Dialogue::AskedCandidate& posed, const Situation& now,
                 const Analysis& analysis) {
  const auto is_the_reason = [&](const Conflict& conflict) {
    return now.isLive(conflict) &&
           fluentsOf(analysis.problem(), conflict.members) == posed.reason.conflict;
  };
  const bool answered = now.knowledge[posed.candidate] != Knowledge::Open;
  if (answered || posed.reason.conflict.empty() ||
      std::any_of(now.conflicts.begin(), now.conflicts.end(), is_the_reason)) {
    return posed.reason;
  }
  return reasonFor(analysis, questions::smallestLiveConflict(now, posed.candidate));
}

}  // namespace

Reason reasonFor(const Analysis& analysis, std::optional<std::size_t> conflict) {
  if (!conflict) return {};
  const Conflict& known = analysis.robot().conflicts()[*conflict];
  return {fluentsOf(analysis.problem(), known.members), known.proven, 0,
          isUnachievableAlone(analysis, known)};
}

bool isUnachievableAlone(const Analysis& analysis, const Conflict& conflict) {
  if (!conflict.proven || conflict.members.count() != 1) return false;
  const alignment::Problem& problem = analysis.problem();
  return (problem.specified.empty() && problem.condition.empty()) ||
         analysis.robot().recallAlone(conflict.members.find_first()) ==
             achievability::Verdict::Unachievable;
}

QuestionView openQuestion(const Dialogue& dialogue, const Analysis& analysis,
                          const Options& options) {
  const Situation now = analysis.situation(dialogue.knowledge());
  QuestionView view;
  for (const Dialogue::AskedCandidate& posed : dialogue.posed()) {
    view.fluents.push_back(dialogue.fluents()[posed.candidate]);
    view.reasons.push_back(reasonNow(posed, now, analysis));
    view.probabilities.push_back(analysis.beliefs()[posed.candidate]);
    view.at_end = view.at_end || mayPass(analysis.problem(), view.fluents.back());
  }
  view.asked = dialogue.asked() - 1;
  view.max_remaining = maxRemaining(analysis, now, options);
  view.bound_is_provisional = !analysis.robot().complete();
  view.if_yes = questions::answerEffect(now, dialogue.openCandidates(), Knowledge::Wanted);
  view.if_no = questions::answerEffect(now, dialogue.openCandidates(), Knowledge::NotWanted);
  return view;
}

bool stillMatters(const QuestionView& question, const Dialogue& dialogue,
                  const Analysis& analysis) {
  using Ending = questions::AnswerEffect::Ending;
  if (!analysis.policy().usesConflicts()) return true;
  const Situation now = analysis.situation(dialogue.knowledge());
  const Ending ending = questions::answerEffect(now, {}, Knowledge::Open).ending;
  if (ending == Ending::Plan) {
    return std::any_of(question.reasons.begin(), question.reasons.end(),
                       [](const Reason& reason) { return reason.extra_cost > 0; });
  }
  const auto& waiting = dialogue.openCandidates();
  const CandidateSet relevant = now.relevantCandidates();
  return ending == Ending::Open && std::any_of(waiting.begin(), waiting.end(),
                                               [&](std::size_t f) { return relevant.test(f); });
}

std::size_t maxRemaining(const Analysis& analysis, const Situation& now, const Options& options) {
  const achievability::Achievability& robot = analysis.robot();
  const bool uses_conflicts = analysis.policy().usesConflicts();
  if (uses_conflicts && robot.complete() && !costsMatter(options))
    return now.relevantCandidates().count();
  std::size_t count = 0;
  for (std::size_t f = 0; f < now.knowledge.size(); ++f) {
    const bool askable = !uses_conflicts || !robot.alwaysTrue().test(f);
    if (askable && now.knowledge[f] == Knowledge::Open) ++count;
  }
  return count;
}

}  // namespace goal_alignment::session
