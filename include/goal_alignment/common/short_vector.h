// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>

namespace goal_alignment {

/// A vector that needs no memory of its own while it has at most N elements. (Boost's small_vector
/// does the same, but GCC can't see that its copies stay within bounds, and warns.)
template <typename T, std::size_t N>
class ShortVector {
  static_assert(std::is_trivially_copyable<T>::value, "elements are copied as bytes");

 public:
  using value_type = T;

  ShortVector() = default;
  ShortVector(std::initializer_list<T> values) {
    for (const T& value : values)
      push_back(value);
  }
  ShortVector(const ShortVector& other) { append(other); }
  ShortVector(ShortVector&& other) noexcept { swap(other); }
  ShortVector& operator=(ShortVector other) noexcept {
    swap(other);
    return *this;
  }
  ~ShortVector() = default;

  T* data() { return more_ ? more_.get() : few_.data(); }
  const T* data() const { return more_ ? more_.get() : few_.data(); }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  void push_back(T value) {  // NOLINT(readability-identifier-naming): as a std::vector
    if (size_ == capacity_) reserve(2 * std::size_t{capacity_});
    data()[size_++] = value;
  }
  void clear() { size_ = 0; }
  void reserve(std::size_t capacity) {
    if (capacity <= capacity_) return;
    std::unique_ptr<T[]> larger(new T[capacity]);
    std::copy(begin(), end(), larger.get());
    more_ = std::move(larger);
    capacity_ = static_cast<std::uint32_t>(capacity);
  }

  friend bool operator==(const ShortVector& a, const ShortVector& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  void append(const ShortVector& other) {
    reserve(size_ + other.size_);
    std::copy(other.begin(), other.end(), end());
    size_ += other.size_;
  }
  void swap(ShortVector& other) noexcept {
    std::swap(few_, other.few_);
    std::swap(more_, other.more_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  std::unique_ptr<T[]> more_;
  std::uint32_t size_ = 0;
  std::uint32_t capacity_ = N;
  std::array<T, N> few_{};
};

}  // namespace goal_alignment
