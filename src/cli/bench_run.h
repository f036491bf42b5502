// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <mutex>
#include <set>
#include <vector>

#include "bench_truth.h"
#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::cli {

/// The sessions that are under way, for whoever ends them all. Thread-safe.
class RunningSessions {
 public:
  /// While one lives, its session ends when all do.
  class Entry {
   public:
    Entry(RunningSessions& sessions, session::Session& session);
    ~Entry();
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;

   private:
    RunningSessions& sessions_;
    session::Session& session_;
  };

  /// Cancels those that run, and from now on every new one.
  void cancelAll();
  bool cancelled() const { return cancelled_.cancelled(); }

 private:
  std::mutex mutex_;
  std::set<session::Session*> running_;
  CancelToken cancelled_;
};

/// What one alignment came to.
struct RunFigures {
  std::size_t candidates = 0;
  std::size_t candidates_static = 0;
  std::size_t settled = 0;         ///< candidates that nobody had to ask about
  std::size_t questions = 0;       ///< candidates shown to the person
  std::size_t rounds = 0;          ///< times the person was interrupted; fewer, with groups
  double first_question = 0;       ///< seconds, or until the outcome where none was asked
  std::vector<double> per_answer;  ///< seconds from each answer to what follows
  session::Statistics spent;
  session::OutcomeCode outcome = session::OutcomeCode::None;
};

/// Aligns with a person who wants that. The outcome is Canceled where `sessions` were.
RunFigures alignOnce(session::Input input, const session::Options& options, const Wants& wants,
                     RunningSessions& sessions);

/// What an instance is before anybody is asked: the same for all policies and truths.
struct Analysis {
  session::Outcome outcome;  ///< None where there is something to ask
  std::vector<Literal> candidates;
  /// Without what an answer is assumed for; meaningful where they are known.
  std::vector<achievability::Conflict> conflicts;
  bool conflicts_known = false;  ///< all of them

  /// How few answers a clairvoyant would need.
  std::size_t minimum(const Wants& wants) const;
};

Analysis analyse(session::Input input, session::Options options, RunningSessions& sessions);

}  // namespace goal_alignment::cli
