// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/AlignResult.h"
#include "goal_alignment/any_message/action_client.h"
#include "goal_alignment/any_message/service_caller.h"
#include "goal_alignment/any_message/wait_point.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/execution/precondition_monitor.h"

namespace goal_alignment::execution {

/// What the execution of plans wants of the aligner. An interrupt ends every wait.
class AlignerLink {
 public:
  struct Facts {
    bool known = false;
    std::string message;  ///< why not
    std::string session_id;
    WorldState world;  ///< both lists sorted
  };

  AlignerLink(ros::NodeHandle node, const std::string& aligner,
              any_message::ServiceCaller& services, any_message::WaitPoint& wait);

  Facts facts();

  /// These are so now. What is refused, as another source tells it better, is left out. False: the
  /// aligner does not answer.
  bool tell(const std::vector<Literal>& changes);

  /// Another one when the aligner was started anew; "": it is not there.
  std::string life() const;

  /// A new plan under the session's answers; people may be asked. Nothing: `why_not` says why.
  std::optional<AlignResult> replan(const std::string& session_id, double cancel_timeout,
                                    std::string& why_not);

  /// The parameter of the aligner; "" where it has none.
  std::string parameter(const std::string& key) const;

  /// Whether replan() sent the goal of that id.
  static bool isOwnGoal(const std::string& goal_id);

 private:
  bool set(const std::vector<Literal>& changes, std::string& refusal);
  template <typename Service>
  std::optional<typename Service::Response> ask(const std::string& name,
                                                const typename Service::Request& request,
                                                any_message::ServiceCaller::Reply::Kind& kind);

  ros::NodeHandle node_;
  std::string aligner_;
  any_message::ServiceCaller& services_;
  any_message::WaitPoint& wait_;
  any_message::ActionClient align_;
  unsigned goals_sent_ = 0;
  bool hangs_ = false;  // it did not answer in time, and is not waited for as long again
};

}  // namespace goal_alignment::execution
