// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "goal_alignment/common/span.h"

/// Millions of small things in few large blocks that never move: neither growing nor freeing them
/// keeps a thread that was cancelled for long.
namespace goal_alignment {

/// A vector that only grows.
template <typename T>
class BlockVector {
  static_assert(std::is_trivially_destructible<T>::value, "nobody visits the elements in the end");

 public:
  void push_back(T value) {  // NOLINT(readability-identifier-naming): as a std::vector
    if (size_ == blocks_.size() * kPerBlock) blocks_.emplace_back(new T[kPerBlock]);
    blocks_.back()[size_++ % kPerBlock] = std::move(value);
  }

  const T& operator[](std::size_t i) const { return blocks_[i / kPerBlock][i % kPerBlock]; }
  T& operator[](std::size_t i) { return blocks_[i / kPerBlock][i % kPerBlock]; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  /// For range-based loops only.
  class Iterator {
   public:
    Iterator(const BlockVector& of, std::size_t at) : of_(&of), at_(at) {}
    const T& operator*() const { return (*of_)[at_]; }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return at_ != other.at_; }

   private:
    const BlockVector* of_;
    std::size_t at_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size_}; }

 private:
  static constexpr std::size_t kPerBlock = 1024;

  std::vector<std::unique_ptr<T[]>> blocks_;
  std::size_t size_ = 0;
};

/// Keeps copies of arrays.
template <typename T>
class ArrayStore {
  static_assert(std::is_trivially_copyable<T>::value, "nobody visits the elements in the end");

 public:
  Span<T> keep(Span<T> array) {
    if (array.size() > left_) {
      left_ = std::max(kPerBlock, array.size());
      blocks_.emplace_back(new T[left_]);
      next_ = blocks_.back().get();
    }
    T* const copy = next_;
    std::copy(array.begin(), array.end(), copy);
    next_ += array.size();
    left_ -= array.size();
    return {copy, array.size()};
  }

 private:
  static constexpr std::size_t kPerBlock = 16384;

  std::vector<std::unique_ptr<T[]>> blocks_;
  T* next_ = nullptr;
  std::size_t left_ = 0;
};

}  // namespace goal_alignment
