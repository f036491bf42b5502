// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "explainer.h"
#include "goal_alignment/Explain.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/session/session.h"
#include "session_record.h"

namespace goal_alignment::aligner {

/// Tells the explainer how the current session stands and answers its what-if queries, for which
/// the session has to think. Belongs to the solver thread.
class ExplanationFeed {
 public:
  /// Both outlive this.
  ExplanationFeed(const SessionRecord& current, Explainer& explainer);

  void show(const session::Snapshot& now);

  bool hasQueries() const { return !explainer_.suppositions().empty(); }
  /// Answers the oldest query.
  void answerQuery();

 private:
  std::optional<Explain::Response> whatIf(const std::vector<Literal>& fluents);

  const SessionRecord& current_;
  Explainer& explainer_;
};

}  // namespace goal_alignment::aligner
