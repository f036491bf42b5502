// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/ActionDispatch.h"
#include "goal_alignment/Plan.h"
#include "goal_alignment/any_message/wait_point.h"
#include "goal_alignment/execution/aligner_link.h"
#include "goal_alignment/execution/executor_options.h"
#include "goal_alignment/execution/facts_ledger.h"
#include "goal_alignment/execution/precondition_monitor.h"

namespace goal_alignment::execution {

/// "(go hall kitchen)"
std::string textOf(const ActionDispatch& step);

/// What is so around a plan that runs: whether its next step can begin and the rest of it can still
/// succeed, what each step has changed, and whether tf sees it otherwise. The facts are those of
/// the aligner, of whatever task it is at; while it can't tell them they are what they must have
/// become. Of the thread that runs plans.
class FactsWatch {
 public:
  /// What stops a plan.
  struct Look {
    enum class Kind {
      Fine,
      Interrupted,
      Step,  ///< `step` can't be carried out
      End    ///< the plan would not end, or has not ended, as it has to
    };
    Kind kind = Kind::Fine;
    std::size_t step = 0;
    std::string reason;  ///< one sentence
  };

  FactsWatch(AlignerLink& aligner, FactsLedger& ledger, any_message::WaitPoint& wait,
             const ExecutorOptions& options)
      : aligner_(aligner), ledger_(ledger), wait_(wait), options_(options) {}

  void begin(const Plan& plan);

  /// The robot's; null: nothing is watched.
  const pddl::Model* model() const { return watch_ ? &watch_->model() : nullptr; }

  /// Before the plan's step of that index. What tf tells may be a moment behind, so that only what
  /// stays so for facts_timeout stops the plan.
  Look beforeStep(const Plan& plan, std::size_t index);
  Look atTheEnd(const Plan& plan);

  void succeeded(const ActionDispatch& step);
  /// Facts that a failed step has brought to light; what is none of the model's is told, too.
  void failed(const ActionDispatch& step, const std::vector<Literal>& facts);

  /// Why no new plan can be asked for; "": it can be.
  std::string whyNoNewPlan();

 private:
  using Judge = std::function<PreconditionMonitor::Finding(const WorldState&)>;

  /// What a step has changed, as long as tf may still come to see it.
  struct Claim {
    bool holds = false;
    std::string step;
    any_message::Clock::time_point since;
  };

  void giveUp(const std::string& why);
  void goBlind(const std::string& why);
  std::optional<WorldState> world();
  std::string whyLost() const;
  PreconditionMonitor::Finding judgeRest(const std::vector<GroundName>& steps,
                                         const std::vector<Literal>& wanted,
                                         const WorldState& world);
  Look await(const Judge& judge, std::size_t first_step, std::size_t steps);
  bool claimsAreSettled(const WorldState& world);
  void contradict(const GroundName& atom, const Claim& claim) const;

  AlignerLink& aligner_;
  FactsLedger& ledger_;
  any_message::WaitPoint& wait_;
  const ExecutorOptions& options_;
  std::optional<PreconditionMonitor> watch_;  // nothing: the plan just runs
  std::string unwatched_;                     // why
  std::string blind_;                         // why facts can't be had just now; "": they can
  std::string session_;
  std::string other_session_;      // that the aligner was at last, where it was not ours; "": none
  bool session_is_lost_ = false;   // the aligner is at another one
  std::optional<WorldState> now_;  // as last seen, and changed by steps since
  bool rest_is_fine_ = false;      // from now_ on
  std::map<GroundName, Claim> claims_;
};

}  // namespace goal_alignment::execution
