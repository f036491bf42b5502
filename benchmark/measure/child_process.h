// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

#include "record.h"

namespace goal_alignment::benchmarks {

/// What a process may use before it is killed.
struct HardLimits {
  double seconds = 60;
  std::size_t mebibytes = 2048;
};

/// Sends what the record holds so far, in case that the work does not come to its end.
using Save = std::function<void()>;

/// Runs the work in a process of its own, so that peak memory is its own, a crash is its own, and
/// limits hold whatever the work does. Returns the record that the work filled in, with `cpu`
/// seconds and `peak_mib`; `status` says `killed: time`, `crashed: signal N` or `failed` where the
/// work did not come to its end (then with what it had set by its last call of `save`), and `error`
/// what it threw.
///
/// Only to be called while this process has one thread. Throws std::system_error.
Record runInChild(const std::function<void(Record& record, const Save& save)>& work,
                  const HardLimits& limits);

}  // namespace goal_alignment::benchmarks
