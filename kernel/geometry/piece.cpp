// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/piece.hpp"

namespace crest::kernel {

GridSize parts_of(const GridSize& size, Index count) {
  GridSize best{1, 1, 1};
  double least = 0;
  for (Index x = 1; x <= count; ++x)
    for (Index y = 1; x * y <= count; ++y) {
      const Index z = count / (x * y);
      if (x * y * z != count || x > size[0] || y > size[1] || z > size[2]) continue;
      const double a = double(size[0]) / x, b = double(size[1]) / y, c = double(size[2]) / z;
      // Ties: fewer cuts along x, along which samples lie next to each other in files.
      const double surface = a * b + b * c + c * a;
      if (least == 0 || surface < least) {
        least = surface;
        best = {x, y, z};
      }
    }
  return least > 0 || count <= 1 ? best : parts_of(size, count - 1);
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
