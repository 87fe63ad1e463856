// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/clean/equal_points.hpp"

#include <bit>

namespace crest::io {
namespace {

/// Equal for equal points; the constants are those of splitmix64.
std::uint64_t hash_of(const kernel::Vec3& p) {
  std::uint64_t h = 0;
  for (const double x : p) {
    h += std::bit_cast<std::uint64_t>(x + 0.0) + 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
    h ^= h >> 31;
  }
  return h;
}

}  // namespace

std::vector<kernel::Index> first_equal(const std::vector<kernel::Vec3>& points) {
  using kernel::Index;
  using kernel::kNone;
  const std::size_t places = std::bit_ceil(2 * points.size() + 1);
  std::vector<Index> table(places, kNone), first(points.size());
  for (Index v = 0; v < points.size(); ++v) {
    std::size_t at = hash_of(points[v]) & (places - 1);
    while (table[at] != kNone && points[table[at]] != points[v]) at = (at + 1) & (places - 1);
    if (table[at] == kNone) table[at] = v;
    first[v] = table[at];
  }
  return first;
}

}  // namespace crest::io
