// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An array most places of which may be empty: an empty place costs neither construction nor copy.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace crest::kernel {

/// Calls f(i) for the bits i of `mask`, lowest first.
template <class Function>
inline void for_each_bit(std::uint64_t mask, Function&& f) {
  for (; mask != 0; mask &= mask - 1) f(static_cast<std::size_t>(std::countr_zero(mask)));
}

/// Place i holds a T if and only if bit i of mask() is set. Count: at most 64.
template <class T, int Count>
class SparseArray {
  static_assert(0 < Count && Count <= 64);

 public:
  SparseArray() noexcept {}
  SparseArray(const SparseArray& other) {
    for_each_bit(other.mask_, [&](std::size_t i) { put(i, other[i]); });
  }
  SparseArray(SparseArray&& other) noexcept(std::is_nothrow_move_constructible_v<T>) {
    for_each_bit(other.mask_, [&](std::size_t i) { put(i, std::move(other.place(i))); });
  }
  SparseArray& operator=(const SparseArray& other) {
    if (this != &other) assign([&](std::size_t i) -> const T& { return other[i]; }, other.mask_);
    return *this;
  }
  SparseArray& operator=(SparseArray&& other) noexcept(std::is_nothrow_move_constructible_v<T>) {
    if (this != &other)
      assign([&](std::size_t i) { return std::move(other.place(i)); }, other.mask_);
    return *this;
  }
  ~SparseArray() { clear(); }

  std::uint64_t mask() const { return mask_; }
  bool has(std::size_t i) const { return (mask_ >> i & 1) != 0; }
  /// Requires: has(i).
  const T& operator[](std::size_t i) const { return places_[i].value; }
  // By a pointer: GCC 12 merges these functions of different Counts and then warns of bounds.
  T& place(std::size_t i) {
    Place* const first = places_;
    return first[i].value;
  }

  template <class U>
  void put(std::size_t i, U&& value) {
    if (has(i)) {
      place(i) = std::forward<U>(value);
    } else {
      std::construct_at(&place(i), std::forward<U>(value));
      mask_ |= std::uint64_t{1} << i;
    }
  }
  /// What f() returns becomes place i, which is empty, without a copy.
  template <class Function>
  void make(std::size_t i, Function&& f) {
    ::new (static_cast<void*>(&place(i))) T(f());
    mask_ |= std::uint64_t{1} << i;
  }

 private:
  union Place {
    T value;
    Place() noexcept {}
    ~Place() {}
  };

  void clear() {
    if constexpr (!std::is_trivially_destructible_v<T>)
      for_each_bit(mask_, [&](std::size_t i) { std::destroy_at(&places_[i].value); });
    mask_ = 0;
  }
  template <class From>
  void assign(From&& from, std::uint64_t mask) {
    clear();
    for_each_bit(mask, [&](std::size_t i) { put(i, from(i)); });
  }

  Place places_[Count];
  std::uint64_t mask_ = 0;
};

}  // namespace crest::kernel
