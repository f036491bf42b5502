// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

namespace goal_alignment {

/// Elements that stand side by side in somebody else's memory.
template <typename T>
class Span {
 public:
  Span() = default;
  Span(const T* first, std::size_t size) : first_(first), size_(size) {}
  template <typename Container>
  Span(const Container& all) : first_(all.data()), size_(all.size()) {}  // NOLINT: it is all of it

  const T* begin() const { return first_; }
  const T* end() const { return first_ + size_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const { return first_[i]; }

  friend bool operator==(Span a, Span b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  const T* first_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace goal_alignment
