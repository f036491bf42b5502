// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dialogue.h"
#include "goal_alignment/achievability/achievability.h"
#include "goal_alignment/alignment/beliefs.h"
#include "goal_alignment/alignment/problem.h"
#include "goal_alignment/alignment/robot_analysis.h"
#include "goal_alignment/questions/policy.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::session {

/// What a session does from step to step. Each phase is one step(); the last one repeats.
class Session::Implementation {
 public:
  explicit Implementation(Options options);

  void begin(Input input);
  State step();
  SubmitResult answer(const std::vector<Literal>& fluents, AnswerKind kind,
                      const std::string& answered_by, bool revising);
  void setRobotState(const std::vector<GroundName>& atoms);
  Consequence whatIf(const std::vector<Literal>& wanted, const std::vector<Literal>& not_wanted,
                     double seconds);
  void resume(const Options& options);
  void finish(OutcomeCode code, std::string message);

  Snapshot snapshot() const;
  std::vector<GroundName> robotState() const;
  const pddl::Model* robotModel() const { return problem_ ? &problem_->robot : nullptr; }
  std::string spelling(const GroundName& ground) const;
  std::vector<std::string> parameterNames(const std::string& action) const;

  State state() const { return state_; }
  UnsurePolicy unsurePolicy() const { return *options_.unsure_policy; }
  const std::optional<QuestionView>& question() const { return question_; }
  const Outcome& outcome() const { return outcome_; }
  const Dialogue& dialogue() const { return dialogue_; }
  const Statistics& statistics() const { return statistics_; }
  const std::optional<validation::Violation>& humanPlanViolation() const {
    return robot_analysis_.human_plan_violation;
  }
  CancelToken& cancelToken() { return cancel_; }

 private:
  enum class Phase { Read, Ground, Check, Believe, FindConflicts, Decide };

  // implementation.cpp: the phases
  void run(Phase phase);
  void read();
  void beginDialogue();
  void ground();
  void checkWhole();
  void believe();
  std::vector<double> costDifferences(alignment::CostOptions options);
  void findConflicts();
  questions::PolicyContext policyContext();
  std::vector<bool> unachievableAlone();
  Limits limits(double seconds_kept = 0) const;
  Limits cancelOnly() const;
  double& stopwatch(Phase phase);
  Phase nextPhase() const;
  void resume(Phase phase);
  void finish(Outcome outcome);
  achievability::Achievability& robot() { return *robot_analysis_.achievability; }
  const achievability::Achievability& robot() const { return *robot_analysis_.achievability; }

  // decision.cpp: from what is known to a question or an outcome
  void decide();
  bool concludeNoPlan();
  bool concludePlan();
  bool concludeBlocked();
  void concludeUnsure();
  bool anyLive() const;
  bool minimiseReasons(const std::vector<questions::Choice>& choices);
  void blame(Outcome& outcome, const achievability::Conflict& conflict) const;
  bool openQuestionMatters() const;
  questions::Situation situation() const;

  // asking.cpp: what is asked, why, and how much more may follow
  void ask(const std::vector<questions::Choice>& choices);
  void ask(const std::vector<Dialogue::AskedCandidate>& posed);
  QuestionView openQuestion() const;
  Reason reasonFor(std::optional<std::size_t> conflict) const;
  Reason reasonNow(const Dialogue::AskedCandidate& posed, const questions::Situation& now) const;
  std::size_t mostRemaining(const questions::Situation& now) const;
  bool cantBeHadAlone(const achievability::Conflict& conflict) const;
  bool mayPass(const Literal& fluent) const;

  // extra_cost.cpp: what keeping things costs that nobody asked for
  bool costsMatter() const;
  std::vector<Dialogue::AskedCandidate> tooCostly(const achievability::CandidateSet& kept,
                                                  const achievability::CandidateSet& open,
                                                  const task::Plan& plan, std::size_t most);
  bool askAboutCost(const achievability::CandidateSet& wished, const task::Plan& plan);
  search::Improved cheapened(const achievability::CandidateSet& set, const task::Plan& plan,
                             std::uint64_t states);
  search::Improved cheaply(const achievability::CandidateSet& set, const task::Plan& plan);
  achievability::CandidateSet trueAtEnd(const task::Plan& plan) const;

  // conclusion.cpp: outcomes
  void conclude(const achievability::CandidateSet& achieved, const task::Plan& first_plan);
  FinalPlan finalPlan(const achievability::CandidateSet& achieved, const task::Plan& first_plan);
  bool humanPlanAchieves(const std::vector<Literal>& goal) const;
  std::vector<Literal> fluents(const achievability::CandidateSet& set) const;
  std::vector<Literal> specifiedAnd(const achievability::CandidateSet& set) const;
  std::string listed(const std::vector<Literal>& literals) const;
  std::string askedFor() const;

  // alternatives.cpp: what there could be instead
  std::vector<Alternative> alternativesAfter(OutcomeCode code);
  std::vector<achievability::CandidateSet> setsToGiveUp(OutcomeCode code,
                                                        const std::vector<double>& beliefs);
  std::vector<achievability::CandidateSet> knownSetsToGiveUp(
      const achievability::CandidateSet& all) const;
  achievability::CandidateSet costlySet(const achievability::CandidateSet& all);
  const task::Plan* knownPlanFor(const achievability::CandidateSet& set) const;
  std::vector<double> answeredBeliefs() const;

  Options options_;
  alignas(64) CancelToken cancel_;  // apart from what the thread that works reads and writes
  alignas(64) State state_ = State::Idle;
  Phase phase_ = Phase::Read;
  Limits::Clock::time_point step_began_;
  Input input_;

  // Owned through pointers: the ground task and the policy refer to what they were made from.
  std::unique_ptr<alignment::Problem> problem_;
  alignment::RobotAnalysis robot_analysis_;
  std::unique_ptr<questions::Policy> policy_;
  bool unit_costs_ = true;
  std::vector<double> beliefs_;
  Dialogue dialogue_;

  std::optional<QuestionView> question_;
  Outcome outcome_;
  Statistics statistics_;
  std::string conflicts_ended_;          // why not all conflicts were found first, and which were
  std::size_t earlier_robot_calls_ = 0;  // made before the robot's state changed
  std::size_t belief_calls_ = 0;
  double budget_from_ = 0;        // thinking time used up when the last outcome was reached
  std::size_t asked_before_ = 0;  // questions that do not count against max_questions
  bool ends_unsure_ = false;      // as soon as it is known what the person could choose
};

}  // namespace goal_alignment::session
