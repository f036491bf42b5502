// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/questions/answer_effect.h"
#include "goal_alignment/questions/reason.h"
#include "goal_alignment/session/options.h"
#include "goal_alignment/session/outcome.h"
#include "goal_alignment/validation/execution.h"

/// One alignment, from task to outcome and on. The façade of the core: the ROS node, the command
/// line and the tests drive this same object. It asks and is told; it does no I/O.
///
///     Idle ──begin()──▶ Analysing ──step()──▶ AwaitingAnswer | Done
///                           ▲                     │
///                           └──── answer() ───────┘
///     Done ──revise(), answer(), setRobotState(), resume()──▶ Analysing    (nothing is asked again)
///
/// A worked example, compiled by test/unit/session/session_test.cpp:
///
///     Session session{Options{}};
///     session.begin(input);
///     while (session.step() != State::Done) {
///       if (session.state() == State::AwaitingAnswer) {
///         for (const Literal& fluent : session.question()->fluents) {
///           session.answer({fluent}, person.wants(fluent) ? AnswerKind::Yes : AnswerKind::No, "me");
///         }
///       }
///     }
///     execute(session.outcome().plan.steps);  // if outcome().code is Success
///
/// cancel() alone may be called from another thread; everything else belongs to one.
namespace goal_alignment::session {

enum class State : std::uint8_t { Idle, Analysing, AwaitingAnswer, Done };

/// Something that is so, or not so, for the human now, whatever their problem file says.
struct HumanFact {
  Literal fact;
  bool of_robot = false;  ///< the robot reported it: counts where both models have the predicate,
                          ///< and where the human's plan does not need the contrary
};

/// Texts of the four files and the human's plan. An empty goal means the problem files' goal.
struct Input {
  pddl::Source robot_domain;
  pddl::Source robot_problem;
  pddl::Source human_domain;
  pddl::Source human_problem;
  std::vector<Literal> goal;
  std::vector<GroundName> human_plan;  ///< empty: the human expects what they believe is so now
  std::vector<HumanFact>
      human_facts;  ///< later ones count; what their model can't have is left out
};

enum class AnswerKind : std::int8_t { No = 0, Yes = 1, Unsure = 2, Decline = 3 };

/// What became of an answer. Refused answers change nothing; message says why.
struct SubmitResult {
  bool accepted = false;
  std::string message;
};

/// Numbers as in the ROS message Candidate.
enum class CandidateState : std::uint8_t {
  Specified = 0,
  Open = 1,  ///< in a live conflict, so its answer can change the outcome
  Asked = 2,
  Wanted = 3,
  NotWanted = 4,
  Unsure = 5,
  Settled = 6,  ///< can't change the outcome, never asked
};

struct CandidateView {
  Literal fluent;
  CandidateState state = CandidateState::Open;
  double probability = 0;              ///< belief that the person wants it
  bool achievable = true;              ///< together with the specified goal, as far as is known
  bool is_static = false;              ///< no action of either model changes its predicate
  bool assumed = false;                ///< nobody has said so: Options::hidden_…
  std::vector<std::size_t> conflicts;  ///< indices of the live conflicts it is in
  std::string answered_by;
};

struct ConflictView {
  std::vector<Literal> fluents;
  bool proven = false;
  bool minimal = false;
  bool live = false;   ///< no fluent of it was answered NO
  bool alone = false;  ///< proven: its one fluent can't be had even without what was asked for

  /// Whether these are its fluents, in any order.
  bool isOf(const std::vector<Literal>& these) const;
};

using questions::Reason;

/// The open question, with all that its wording needs.
struct QuestionView {
  std::vector<Literal> fluents;       ///< one, or up to Options::max_group_size
  std::vector<Reason> reasons;        ///< by fluent
  std::vector<double> probabilities;  ///< beliefs, by fluent
  std::size_t asked = 0;              ///< questions asked before this one
  std::size_t max_remaining = 0;      ///< at most so many more, this one included
  bool bound_is_provisional = false;  ///< conflicts are not complete: the bound may still change,
                                      ///< and so may the prospects
  questions::AnswerEffect if_yes;     ///< what follows if all of `fluents` not answered yet matter
  questions::AnswerEffect if_no;      ///< and if none of those does
  bool at_end = false;                ///< one of them may be so for a while and then no more
};

/// One question that was answered. What of its fluents was answered only after others had made it
/// needless is in it, too.
struct QuestionRecord {
  std::vector<Literal> fluents;
  std::vector<Reason> reasons;      ///< by fluent
  std::vector<AnswerKind> answers;  ///< by fluent
  std::size_t round = 0;
};

/// What would follow from answers that were not given.
struct Consequence {
  enum class Kind : std::uint8_t {
    Unknown,    ///< the time did not suffice to find out
    Plan,       ///< there is a plan for everything that then is not answered NO
    NoPlan,     ///< proven
    Questions,  ///< it depends on answers that were not given yet
  };
  Kind kind = Kind::Unknown;
  std::vector<GroundName> plan;       ///< with Plan
  std::vector<Literal> conflict;      ///< with NoPlan, and where one is known with Questions
  std::size_t max_remaining = 0;      ///< with Questions: at most so many
  bool bound_is_provisional = false;  ///< as QuestionView's
};

/// Everything an onlooker may want to see.
struct Snapshot {
  State state = State::Idle;
  bool planning = false;  ///< in Analysing: no known conflict is left to ask about
  float progress = 0;     ///< 0 … 1
  std::vector<Literal> specified;
  std::string condition;     ///< what was asked for besides, as PDDL; empty: nothing
  bool robot_known = false;  ///< humanPlanInRobotModel() says all there is to say
  std::vector<CandidateView> candidates;
  std::vector<ConflictView> conflicts;
  bool conflicts_complete = false;
  std::size_t questions_asked = 0;
  std::size_t max_remaining = 0;

  /// Null where there is none. They point into this snapshot.
  const CandidateView* candidateOf(const Literal& fluent) const;
  const ConflictView* conflictOf(const std::vector<Literal>& these) const;
};

/// Where the time went, in seconds, and how often a planner ran.
struct Statistics {
  double parse = 0;
  double ground = 0;
  double belief = 0;
  double conflicts = 0;
  double questions = 0;
  double plan = 0;
  double total = 0;  ///< thinking only; waiting for answers is not counted
  std::size_t planner_calls = 0;
};

class Session {
 public:
  /// Throws std::invalid_argument for an option out of its range.
  explicit Session(Options options);
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  /// Takes the task on and forgets what was before. No work is done yet.
  void begin(Input input);

  /// Does one piece of work and returns the new state: one of parsing, grounding, analysis, a
  /// decision, the final plan. Never throws for bad input: that is an outcome. In AwaitingAnswer
  /// and Done there is nothing to do and nothing changes.
  State step();

  State state() const;
  UnsurePolicy unsurePolicy() const;                    ///< what "don't know" means now
  const std::optional<QuestionView>& question() const;  ///< in AwaitingAnswer
  const Outcome& outcome() const;                       ///< meaningful in Done

  /// Answers candidates, asked or not, at any time once the models are read. Refused:
  /// a fluent answered already (revise() changes it), a specified one, one outside S^H.
  /// Answering part of an open question's fluents leaves the question open for the others, and so
  /// does an answer to something else, as long as the question still matters: then its bound,
  /// prospects and reasons are those after the answer. Decline ends the dialogue.
  SubmitResult answer(const std::vector<Literal>& fluents, AnswerKind kind,
                      const std::string& answered_by);

  /// Replaces earlier answers; from Done the session resumes.
  SubmitResult revise(const std::vector<Literal>& fluents, AnswerKind kind,
                      const std::string& answered_by);

  /// The robot's state is now this: S^H and the answers stay, the robot's side is analysed anew.
  /// `atoms` are all atoms that are true. Throws pddl::SemanticError naming an atom that the
  /// robot's model can't have; the session is then as it was.
  void setRobotState(const std::vector<GroundName>& atoms);

  /// All atoms that are true for the robot; empty before the models are read.
  std::vector<GroundName> robotState() const;

  /// The robot's model: its predicates, objects and types, for who must know which facts there can
  /// be. Null before the models are read; valid until begin().
  const pddl::Model* robotModel() const;

  /// What would follow if the candidates `wanted` were answered YES, `not_wanted` NO, and all else
  /// stayed as it is. Thinks for at most so many seconds; changes neither answers nor the open
  /// question. Unknown before the models are analysed. Throws std::invalid_argument naming a fluent
  /// that is no candidate, or is in both lists.
  Consequence whatIf(const std::vector<Literal>& wanted, const std::vector<Literal>& not_wanted,
                     double seconds);

  /// Goes on under the limits and the max_group_size of `options`, and under their unsure_policy
  /// where they name one; max_questions counts from here.
  /// After an outcome that decided nothing (50, 53 to 55, 60 to 62, 64), or that was due to the
  /// world outside (70, 73), the work resumes where it was left; a definite outcome
  /// stays. After 55 other answers, another robot state or more memory can lead further; more time
  /// alone can't. Throws std::invalid_argument like the constructor.
  void resume(const Options& options);

  /// Something outside makes it senseless to go on: Done with this outcome, whatever was before;
  /// the answers stay. Before begin() nothing happens.
  void abort(OutcomeCode code, const std::string& reason);

  /// Nobody answered the open question in time: Done with NoAnswer. The answers given stay.
  void answerTimedOut(const std::string& reason);

  /// Ends the work in progress as soon as possible; the session then is Done with Canceled.
  /// Thread-safe. Takes effect also when it comes before begin()'s first step().
  void cancel() noexcept;

  Snapshot snapshot() const;
  const std::vector<QuestionRecord>& questions() const;
  const Statistics& statistics() const;

  /// Where π^H first fails in the robot's model, as one sentence; empty: it doesn't, or is not
  /// known yet.
  std::string humanPlanInRobotModel() const;
  /// The same for who words it.
  const std::optional<validation::Violation>& humanPlanViolation() const;

  /// The text with the names spelled as the models' writers did.
  std::string spelling(const Literal& fluent) const;
  std::string spelling(const GroundName& action) const;

  /// The parameter names of an action's schema in the robot's model, lower case, without `?`.
  std::vector<std::string> parameterNames(const std::string& action) const;

 private:
  class StateMachine;
  std::unique_ptr<StateMachine> machine_;
};

}  // namespace goal_alignment::session
