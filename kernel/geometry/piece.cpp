// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/piece.hpp"

namespace crest::kernel {

namespace {

/// `count` boxes with the least surface; none (0, 0, 0) if no such numbers of parts fit.
GridSize best_parts(const GridSize& size, Index count) {
  GridSize best{};
  double least = 0;
  for (Index x = 1; x <= std::min(count, size[0]); ++x) {
    if (count % x != 0) continue;
    for (Index y = 1; y <= std::min(count / x, size[1]); ++y) {
      const Index z = count / x / y;
      if (count / x % y != 0 || z > size[2]) continue;
      const double a = double(size[0]) / x, b = double(size[1]) / y, c = double(size[2]) / z;
      // Ties: fewer cuts along x, along which samples lie next to each other in files.
      const double surface = a * b + b * c + c * a;
      if (least == 0 || surface < least) {
        least = surface;
        best = {x, y, z};
      }
    }
  }
  return best;
}

}  // namespace

GridSize parts_of(const GridSize& size, Index count) {
  const std::uint64_t nodes = GridBox{{}, size}.nodes();
  count = static_cast<Index>(std::min<std::uint64_t>(count, nodes));
  for (; count > 1; --count)
    if (const GridSize r = best_parts(size, count); r[0] > 0) return r;
  return {1, 1, 1};
}

std::vector<GridBox> cut_grid(const GridSize& size, const GridSize& parts) {
  std::vector<GridBox> r;
  const auto cut = [&](std::size_t k, Index part) {
    return static_cast<Index>(std::uint64_t{size[k]} * part / parts[k]);
  };
  for (Index z = 0; z < parts[2]; ++z)
    for (Index y = 0; y < parts[1]; ++y)
      for (Index x = 0; x < parts[0]; ++x)
        r.push_back(
            {{cut(0, x), cut(1, y), cut(2, z)}, {cut(0, x + 1), cut(1, y + 1), cut(2, z + 1)}});
  return r;
}

}  // namespace crest::kernel
