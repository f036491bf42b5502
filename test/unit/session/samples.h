// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "goal_alignment/questions/policy.h"
#include "goal_alignment/session/session.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "unit/achievability/samples.h"
#include "unit/alignment/samples.h"

/// What the tests of `session` share: people to talk to, and a session driven to its end.
namespace goal_alignment::session::samples {

using Person = std::function<AnswerKind(const Literal& fluent)>;

inline Literal literal(const std::string& text) {
  return Literal::parse(text);
}

inline std::vector<Literal> literals(const std::vector<std::string>& texts) {
  std::vector<Literal> result;
  for (const std::string& text : texts)
    result.push_back(literal(text));
  return result;
}

/// Answers truly.
inline Person honest(const oracles::Hagl& hagl) {
  return [&hagl](const Literal& fluent) {
    return hagl.wants(fluent) ? AnswerKind::Yes : AnswerKind::No;
  };
}

/// Wants these and nothing else.
inline Person wanting(const std::vector<std::string>& texts) {
  return [wanted = literals(texts)](const Literal& fluent) {
    const bool wants = std::find(wanted.begin(), wanted.end(), fluent) != wanted.end();
    return wants ? AnswerKind::Yes : AnswerKind::No;
  };
}

/// The task of unit/alignment/samples.h.
inline Input desk() {
  using namespace goal_alignment::samples;
  Input input;
  input.robot_domain = {"robot_domain.pddl", kDeskRobotDomain};
  input.robot_problem = {"robot_problem.pddl", kDeskProblem};
  input.human_domain = {"human_domain.pddl", kDeskHumanDomain};
  input.human_problem = {"human_problem.pddl", kDeskProblem};
  input.human_plan = deskPlan();
  return input;
}

/// Thinks until there is a question or an outcome.
inline State think(Session& session) {
  while (session.step() == State::Analysing) {
  }
  return session.state();
}

/// Lets the person answer until there is an outcome; what was asked, in order.
inline std::vector<Literal> talk(Session& session, const Person& person) {
  std::vector<Literal> asked;
  while (think(session) == State::AwaitingAnswer) {
    const std::vector<Literal> fluents = session.question()->fluents;
    for (const Literal& fluent : fluents) {
      asked.push_back(fluent);
      session.answer({fluent}, person(fluent), "person");
    }
  }
  return asked;
}

inline Options options(const std::string& policy, ConflictMode conflicts = ConflictMode::Full,
                       std::uint64_t seed = 0) {
  Options result;
  result.policy = policy;
  result.conflicts = conflicts;
  result.seed = seed;
  return result;
}

/// Any policy, with or without all conflicts.
inline Options anyOptions(RandomSource& random) {
  const std::vector<std::string> policies = questions::policyNames();
  return options(policies[random.below(policies.size())],
                 oracles::chance(random, 0.5) ? ConflictMode::Full : ConflictMode::Lazy,
                 random.below(1000));
}

/// What was answered so, in the order of the questions.
inline std::vector<Literal> answered(const Session& session, AnswerKind kind) {
  std::vector<Literal> result;
  for (const QuestionRecord& record : session.questions()) {
    for (std::size_t i = 0; i < record.fluents.size(); ++i) {
      if (record.answers[i] == kind) result.push_back(record.fluents[i]);
    }
  }
  return result;
}

/// A session over the desk, thought through to its first question.
inline Session atFirstQuestion(Options chosen = {}) {
  Session session(std::move(chosen));
  session.begin(desk());
  think(session);
  return session;
}

inline int code(const Session& session) {
  return static_cast<int>(session.outcome().code);
}

/// The outcome that the problem must have: 1, 51 or 52.
inline int expectedCode(const oracles::Hagl& hagl) {
  if (!hagl.achievable(0)) return 51;
  return hagl.achievable(hagl.wanted()) ? 1 : 52;
}

using achievability::samples::text;

}  // namespace goal_alignment::session::samples
