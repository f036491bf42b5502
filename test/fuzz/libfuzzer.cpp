// SPDX-License-Identifier: BSD-3-Clause
// What libFuzzer calls; FUZZ_TARGET names one function of targets.h.
#include <cstddef>
#include <cstdint>

#include "targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  goal_alignment::fuzz::FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
