// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "family_bounds.h"

namespace goal_alignment::questions {

/// A key that many families share which differ in the names of equally likely candidates alone, and
/// no others: they cost the same. Candidates are renamed among their likes in the order of what
/// surrounds them (colour refinement: Weisfeiler & Leman, 1968), those that belong together side by
/// side. Where that leaves ties a family may miss its twin, which costs time and nothing else. The
/// family's own key where no two of its candidates are equally likely. O(total size + n log n).
FamilyKey keyUpToNames(const Family& family, const Chances& p);

}  // namespace goal_alignment::questions
