// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>

namespace goal_alignment {

/// Destroys something of millions of pieces in a thread of its own, since that takes longer than
/// who cancelled may wait; here, where there is no thread to be had. It must refer to nothing.
template <typename T>
void freeElsewhere(T&& large) noexcept {
  static_assert(!std::is_lvalue_reference<T>::value, "moved from");
  try {
    std::thread([held = std::forward<T>(large)] {}).detach();
  } catch (const std::system_error&) {  // NOLINT(bugprone-empty-catch): it is destroyed by now
  }
}

}  // namespace goal_alignment
