// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "record.h"

namespace goal_alignment::benchmarks {

/// Came to an end: a plan, a proof, a decided alignment.
bool isFinished(const Record& record);

/// Of all checks, the share that was left unknown; work that was killed before it could say counts
/// as one such check. 0 where there are none.
double shareOfChecksUnknown(const std::vector<Record>& records);

/// The exponent k of y ~ x^k: the slope of a least-squares line through the logarithms, over the
/// finished records in which both are positive. NaN where all x are the same.
double growthExponent(const std::vector<Record>& records, const std::string& x,
                      const std::string& y);

/// What the records come to, as a Markdown fragment: the headline shares, a table by suite and
/// kind, the growth exponents.
std::string summary(const std::vector<Record>& records);

}  // namespace goal_alignment::benchmarks
