// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Large arrays that start uninitialised, in huge pages where the system grants them: a check that
// passes over its data a few times is else bound by page faults.
#include <sys/mman.h>

#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

namespace crest::certify {

template <class T>
struct UntouchedAllocator {
  using value_type = T;

  UntouchedAllocator() = default;
  template <class U>
  UntouchedAllocator(const UntouchedAllocator<U>&) {}  // NOLINT: conversion is what allocators do

  T* allocate(std::size_t n) {
    if (n > static_cast<std::size_t>(-1) / (2 * sizeof(T))) throw std::bad_alloc();
    if (n * sizeof(T) < 2 * kPage) return std::allocator<T>().allocate(n);
    const std::size_t size = (n * sizeof(T) + kPage - 1) / kPage * kPage;
    void* const memory = std::aligned_alloc(kPage, size);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    // Only advice: refused or not, the memory is there.
    (void)::madvise(memory, size, MADV_HUGEPAGE);
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t n) {
    if (n * sizeof(T) < 2 * kPage) return std::allocator<T>().deallocate(memory, n);
    std::free(memory);
  }
  /// resize(n) leaves what it adds without a value.
  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Values>
  void construct(U* at, Values&&... values) {
    ::new (static_cast<void*>(at)) U(std::forward<Values>(values)...);
  }
  friend bool operator==(UntouchedAllocator, UntouchedAllocator) {
    return true;
  }

 private:
  static constexpr std::size_t kPage = std::size_t{1} << 21;
};

/// Of trivial types.
template <class T>
using Buffer = std::vector<T, UntouchedAllocator<T>>;

}  // namespace crest::certify
