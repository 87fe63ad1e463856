// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/equal_points.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace crest::kernel {
namespace {

/// Equal for equal points; the constants are those of splitmix64.
std::uint64_t hash_of(const Vec3& p) {
  std::uint64_t h = 0;
  for (const double x : p) {
    h += std::bit_cast<std::uint64_t>(x + 0.0) + 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
    h ^= h >> 31;
  }
  return h;
}

/// A hash table of points with open addressing. Points come in batches, so that their places come
/// from memory side by side.
class EqualPoints {
 public:
  explicit EqualPoints(const std::vector<Vec3>& points)
      : points_(points), table_(std::bit_ceil(2 * points.size() + 1), kNone) {}

  /// Calls `use` with every point and the first one that equals it.
  template <class Use>
  void for_each(const Use& use) {
    constexpr std::size_t batch = 32;
    std::array<std::size_t, batch> places{};
    for (std::size_t begin = 0; begin < points_.size(); begin += batch) {
      const std::size_t count = std::min(batch, points_.size() - begin);
      for (std::size_t i = 0; i < count; ++i) {
        places[i] = hash_of(points_[begin + i]) & (table_.size() - 1);
        __builtin_prefetch(&table_[places[i]]);
      }
      for (std::size_t i = 0; i < count; ++i) {
        const auto v = static_cast<Index>(begin + i);
        use(v, first(v, places[i]));
      }
    }
  }

 private:
  Index first(Index v, std::size_t at) {
    while (table_[at] != kNone && points_[table_[at]] != points_[v])
      at = (at + 1) & (table_.size() - 1);
    if (table_[at] == kNone) table_[at] = v;
    return table_[at];
  }

  const std::vector<Vec3>& points_;
  std::vector<Index> table_;
};

}  // namespace

std::vector<Index> first_equal(const std::vector<Vec3>& points) {
  std::vector<Index> first(points.size());
  EqualPoints(points).for_each([&](Index v, Index of) { first[v] = of; });
  return first;
}

std::size_t count_equal(const std::vector<Vec3>& points) {
  std::size_t count = 0;
  EqualPoints(points).for_each([&](Index v, Index of) { count += v != of; });
  return count;
}

}  // namespace crest::kernel
