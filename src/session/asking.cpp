// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "implementation.h"

/// What is asked, why, and how much more may follow.
namespace goal_alignment::session {

using achievability::Conflict;
using questions::Knowledge;

Reason Session::Implementation::reasonFor(std::optional<std::size_t> conflict) const {
  if (!conflict) return {};
  const Conflict& known = robot().conflicts()[*conflict];
  return {fluents(known.members), known.proven, 0, cantBeHadAlone(known)};
}

/// Whatever else is asked for.
bool Session::Implementation::cantBeHadAlone(const Conflict& conflict) const {
  const std::vector<std::size_t> members = achievability::members(conflict.members);
  return conflict.proven && members.size() == 1 &&
         ((problem_->specified.empty() && problem_->condition.empty()) ||
          robot().recallAlone(members.front()) == achievability::Verdict::Unachievable);
}

/// Whether the fluent may be so for a while and then no more.
bool Session::Implementation::mayPass(const Literal& fluent) const {
  const auto passes = [&](const pddl::Model& model) {
    const auto predicate = model.findPredicate(fluent.atom.name);
    const auto undoes = [&](const pddl::LiftedAtom& atom) { return atom.predicate == predicate; };
    const auto any = [&](const auto& effect) {
      const auto& atoms = fluent.negated ? effect.add : effect.del;
      return std::any_of(atoms.begin(), atoms.end(), undoes);
    };
    return std::any_of(model.schemas.begin(), model.schemas.end(), [&](const auto& schema) {
      return any(schema) || std::any_of(schema.conditional.begin(), schema.conditional.end(), any);
    });
  };
  return passes(problem_->human) || passes(problem_->robot);
}

void Session::Implementation::ask(const std::vector<questions::Choice>& choices) {
  std::vector<Dialogue::AskedCandidate> posed;
  posed.reserve(choices.size());
  for (const questions::Choice& choice : choices)
    posed.push_back({choice.candidate, reasonFor(choice.conflict)});
  ask(posed);
}

void Session::Implementation::ask(const std::vector<Dialogue::AskedCandidate>& posed) {
  std::vector<std::size_t> candidates;
  candidates.reserve(posed.size());
  for (const Dialogue::AskedCandidate& one : posed)
    candidates.push_back(one.candidate);
  const std::size_t asked = dialogue_.askedWith(candidates);
  if (options_.max_questions >= 0 &&
      asked > asked_before_ + static_cast<std::size_t>(options_.max_questions)) {
    finish(OutcomeCode::QuestionLimit,
           "the limit of questions is reached, and the outcome still depends on " +
               listed({dialogue_.fluents()[candidates.front()]}));
    return;
  }
  dialogue_.ask(posed);
  question_ = openQuestion();
  state_ = State::AwaitingAnswer;
}

/// What the open question looks like, with what is known now.
QuestionView Session::Implementation::openQuestion() const {
  const questions::Situation now = situation();
  QuestionView view;
  for (const Dialogue::AskedCandidate& posed : dialogue_.posed()) {
    view.fluents.push_back(dialogue_.fluents()[posed.candidate]);
    view.reasons.push_back(reasonNow(posed, now));
    view.probabilities.push_back(beliefs_[posed.candidate]);
    view.at_end = view.at_end || mayPass(view.fluents.back());
  }
  view.asked = dialogue_.asked() - 1;
  view.max_remaining = mostRemaining(now);
  view.bound_is_provisional = !robot().complete();
  view.if_yes = questions::answerEffect(now, dialogue_.openCandidates(), Knowledge::Wanted);
  view.if_no = questions::answerEffect(now, dialogue_.openCandidates(), Knowledge::NotWanted);
  return view;
}

/// Why it is asked as things stand: where an answer to something else has settled the reason that
/// it was asked for, another may be left.
Reason Session::Implementation::reasonNow(const Dialogue::AskedCandidate& posed,
                                          const questions::Situation& now) const {
  const auto rests = [&](const Conflict& conflict) {
    return now.isLive(conflict) && fluents(conflict.members) == posed.reason.conflict;
  };
  const bool answered = now.knowledge[posed.candidate] != Knowledge::Open;
  if (answered || posed.reason.conflict.empty() ||
      std::any_of(now.conflicts.begin(), now.conflicts.end(), rests)) {
    return posed.reason;
  }
  return reasonFor(questions::smallestLiveConflict(now, posed.candidate));
}

/// How many candidates a question may still be about. Each question is about one at least.
std::size_t Session::Implementation::mostRemaining(const questions::Situation& now) const {
  if (policy_->usesConflicts() && robot().complete() && !costsMatter())
    return now.relevantCandidates().count();
  const bool any = !policy_->usesConflicts();
  std::size_t count = 0;
  for (std::size_t f = 0; f < now.knowledge.size(); ++f) {
    const bool askable = any || !robot().alwaysTrue().test(f);
    if (askable && now.knowledge[f] == Knowledge::Open) ++count;
  }
  return count;
}

}  // namespace goal_alignment::session
