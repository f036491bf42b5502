// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "fact_file.h"
#include "goal_alignment/Fluent.h"
#include "goal_alignment/GetFacts.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/session/session.h"
#include "goal_alignment/spatial_facts/observer.h"
#include "said_facts.h"

namespace goal_alignment::aligner {

/// What is so in the robot's world: the problem file of the session under way, or of the last one,
/// which a goal may continue, changed by what ~set_facts said, and last of all by what was seen of
/// where things are. Facts that were set also hold for later tasks whose models come from
/// parameters, across restarts where there is a file, and so does what the person has come to
/// believe; a goal that brings its own problems says itself what is so. Thread-safe.
class RobotFacts {
 public:
  /// `file` keeps the facts across restarts, and outlives this; null: nothing does.
  explicit RobotFacts(FactFile* file = nullptr) : file_(file) {}

  /// The models that the parameters name. What was kept for them is taken up the first time; a line
  /// for people says so, and is empty where there is nothing to say.
  std::string follow(const FactScope& scope, double expiry);

  /// All of the facts are taken, or none: a fact that the robot's model of the session can't have,
  /// a name that is none, or a fact both true and false is refused with its index. What the rules
  /// own (null: nothing) is left to them, and the message says so; with nothing else that is a
  /// refusal. Where a rule trusts the file, it trusts what was set as well. The person follows all
  /// that was reported, what tf owns included: they know what was carried out.
  session::SubmitResult set(const std::vector<Fluent>& facts, const spatial_facts::Rules* rules);

  /// The same of what the person believes, from the next task on; `human` refuses what their model
  /// can't have (null: nothing is refused for it).
  session::SubmitResult setHuman(const std::vector<Fluent>& facts, const pddl::Model* human);

  /// What has come to be so for the person; `follows`: also what the robot reported.
  std::vector<session::HumanFact> believed(bool follows) const;

  /// Nothing was ever set; the number of facts forgotten. The session under way forgets them, too.
  std::size_t forget();

  /// Changes when the facts of the session may have.
  unsigned version() const { return version_; }

  /// Another session begins. `earlier_hold` false: facts set before it do not hold for it.
  void beginSession(const std::string& session_id, bool earlier_hold);

  /// What facts there can be in the session's robot model, and those of its problem file; until
  /// then none is refused as unknown.
  void setModel(const pddl::Model& model);

  /// All atoms that are true now, and known to be; sorted. Facts that were set and that the model
  /// can't have are left out and named in `left_out`. Needs the model.
  std::vector<GroundName> state(const spatial_facts::Observation& seen,
                                std::vector<GroundName>& left_out) const;

  /// The answer of ~get_facts. Never waits for the solver thread.
  GetFacts::Response tell(const spatial_facts::Observation& seen) const;

  /// Before any task, of the model that it would have; null: none, and `why_not` says why.
  GetFacts::Response tellBefore(const std::shared_ptr<const pddl::Model>& model,
                                const std::string& why_not,
                                const spatial_facts::Observation& seen) const;

 private:
  using Changes = std::map<GroundName, bool>;

  // What holds for one session.
  struct World {
    std::string session_id;  // empty: no task yet
    Changes set;
    std::shared_ptr<const pddl::Model> model;  // null: not read yet
  };

  World world() const;
  void keep() const;
  static std::string read(const std::vector<Fluent>& facts, const pddl::Model* model,
                          const std::string& whose, Changes& changes);
  static GetFacts::Response told(const World& world, const spatial_facts::Observation& seen);
  static std::vector<GroundName> stateOf(const World& world, const spatial_facts::Observation& seen,
                                         std::vector<GroundName>& left_out);

  FactFile* const file_;
  std::mutex keeping_;  // of who changes the facts, until they are kept; before mutex_
  bool followed_ = false;
  FactScope scope_;
  std::atomic<unsigned> version_{1};
  mutable std::mutex mutex_;  // guards the two below
  SaidFacts said_;
  World world_;
};

}  // namespace goal_alignment::aligner
