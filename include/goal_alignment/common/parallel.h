// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace goal_alignment {

/// How many independent pieces of work are done side by side. A constant, whatever the number of
/// threads, for what one batch finds out is used by the next: so the results are the same.
constexpr std::size_t kBatch = 8;

/// Calls work(0) … work(count − 1) on up to `threads` threads and waits for all. With one thread
/// they run in order on the caller's. Of what they throw the first in order is thrown on.
void inParallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace goal_alignment
