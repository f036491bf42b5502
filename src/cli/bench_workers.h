// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "bench_instance.h"
#include "progress_bar.h"

namespace goal_alignment::cli {

/// Measures the instances, so many side by side. The calling thread alone calls `report`, in the
/// order of the instances, and draws the bar. Once `cancel` is cancelled the work under way ends,
/// and what was complete is reported. Throws on what a worker throws.
void measureAll(const std::vector<InstanceFolder>& instances, const BenchPlan& plan, int threads,
                const CancelToken& cancel, ProgressBar& bar,
                const std::function<void(InstanceResult)>& report);

}  // namespace goal_alignment::cli
