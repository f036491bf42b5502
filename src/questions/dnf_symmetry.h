// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dnf_bounds.h"

namespace goal_alignment::questions {

/// A key that many DNFs share that differ only in the names of equally likely candidates, so that
/// they cost the same; DNFs that differ in more never share one. Equally likely candidates are
/// renamed in the order of what surrounds them (colour refinement: Weisfeiler & Leman, 1968), one
/// connected component after the other. Where that leaves ties two DNFs that differ in names only
/// may get different keys, which costs time and nothing else. The DNF's own key where no two of its
/// candidates are equally likely. O(total size + n log n).
DnfKey keyUpToRenaming(const MonotoneDnf& dnf, const Chances& p);

}  // namespace goal_alignment::questions
