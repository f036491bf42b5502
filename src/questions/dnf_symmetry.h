// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dnf_bounds.h"

namespace goal_alignment::questions {

/// A key that many DNFs share which differ in the names of equally likely candidates alone, and
/// no others: they cost the same. Candidates are renamed among their likes in the order of what
/// surrounds them (colour refinement: Weisfeiler & Leman, 1968), those that belong together side by
/// side. Where that leaves ties a dnf may miss its twin, which costs time and nothing else. The
/// dnf's own key where no two of its candidates are equally likely. O(total size + n log n).
DnfKey keyUpToNames(const MonotoneDnf& dnf, const Chances& p);

}  // namespace goal_alignment::questions
