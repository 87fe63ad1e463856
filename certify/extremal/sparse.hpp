// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Values by number, most of which were never written: they take the memory of those that were, not
// of the grid, which a small file may halve three times.
#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace crest::certify::extremal {

/// Pages of 64 values and tables of 16 pages come with the first value written there.
template <class T>
class Sparse {
 public:
  /// `none` is what is read where nothing was written.
  Sparse(std::size_t count, T none)
      : none_(none), top_(count / (kPage * kTable) + 1, kMissing), count_(count) {}

  std::size_t size() const { return count_; }
  T operator[](std::size_t i) const {
    const T* const page = find(i);
    return page == nullptr ? none_ : page[i % kPage];
  }
  /// The value's place. Where there is one already, callers of different values may run at once.
  T& at(std::size_t i) {
    std::uint32_t& table = top_[i / (kPage * kTable)];
    if (table == kMissing) table = tables_.add(kMissing);
    std::uint32_t& page = tables_.at(table)[i / kPage % kTable];
    if (page == kMissing) page = pages_.add(none_);
    return pages_.at(page)[i % kPage];
  }
  /// Calls visit(i, value) in order, for all that were written and some beside them.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t first = 0; first < count_; first += kPage) {
      if (top_[first / (kPage * kTable)] == kMissing) {
        first += (kTable - 1) * kPage;  // tables start at multiples of their length
        continue;
      }
      const T* const page = find(first);
      if (page == nullptr) continue;
      for (std::size_t i = 0; i < std::min(kPage, count_ - first); ++i) visit(first + i, page[i]);
    }
  }

 private:
  static constexpr std::size_t kPage = 64, kTable = 16;
  static constexpr std::uint32_t kMissing = 0xffffffffU;

  /// Arrays of a fixed length that stay where they are.
  template <class Value, std::size_t length>
  class Arrays {
   public:
    std::uint32_t add(const Value& value) {
      if (count_ % kChunk == 0)
        chunks_.push_back(std::make_unique_for_overwrite<Value[]>(kChunk * length));
      std::fill_n(at(count_), length, value);
      return count_++;
    }
    Value* at(std::uint32_t i) { return chunks_[i / kChunk].get() + i % kChunk * length; }
    const Value* at(std::uint32_t i) const {
      return chunks_[i / kChunk].get() + i % kChunk * length;
    }

   private:
    static constexpr std::uint32_t kChunk = 64;
    std::vector<std::unique_ptr<Value[]>> chunks_;
    std::uint32_t count_ = 0;
  };

  const T* find(std::size_t i) const {
    const std::uint32_t table = top_[i / (kPage * kTable)];
    if (table == kMissing) return nullptr;
    const std::uint32_t page = tables_.at(table)[i / kPage % kTable];
    return page == kMissing ? nullptr : pages_.at(page);
  }

  T none_;
  std::vector<std::uint32_t> top_;
  std::size_t count_;
  Arrays<std::uint32_t, kTable> tables_;
  Arrays<T, kPage> pages_;
};

}  // namespace crest::certify::extremal
