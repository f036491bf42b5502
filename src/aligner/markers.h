// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <visualization_msgs/MarkerArray.h>

#include <functional>
#include <optional>
#include <string>

#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/Plan.h"

namespace goal_alignment::aligner {

/// Where things are, as far as is known.
struct Whereabouts {
  /// The frame of a PDDL object; "": none.
  std::function<std::string(const std::string& object)> frame_of;
  /// Where the origin of `frame` is, in `seen_from`; nothing where that is not known.
  std::function<std::optional<geometry_msgs::Point>(const std::string& frame,
                                                    const std::string& seen_from)>
      origin;
};

/// Candidates and, of the same session, the steps of the plan: as text above the frame of the first
/// object with one, what matters most on top; as an arrow from there to the next object with a
/// frame, where there is one. What mentions nothing with a frame is left out. The first marker
/// deletes all earlier ones, so that the array is complete in itself.
visualization_msgs::MarkerArray markersOf(const AlignmentState& state, const Plan& plan,
                                          const Whereabouts& whereabouts);

}  // namespace goal_alignment::aligner
