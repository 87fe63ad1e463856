// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/plane_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/formats/files.hpp"
#include "kernel/predicates/planar_field.hpp"

namespace crest::io {

using kernel::Index;
using kernel::Vec2;

void add_triangles(const PlaneGrid& grid, Diagonal diagonal, PlanarFieldFile& file) {
  const std::size_t nx = grid.nx, ny = grid.ny;
  const auto known = [&](std::size_t i) {
    return std::isfinite(grid.vectors[i][0]) && std::isfinite(grid.vectors[i][1]);
  };
  std::vector<Index> number(grid.points.size(), kernel::kNone);
  const auto use = [&](std::size_t i) {
    if (number[i] == kernel::kNone) {
      number[i] = static_cast<Index>(file.points.size());
      file.points.push_back(grid.points[i]);
      file.vectors.push_back(grid.vectors[i]);
    }
    return number[i];
  };
  std::size_t missing = 0;
  const auto add = [&](Index a, Index b, Index c, std::size_t cell) {
    const auto& p = file.points;
    if (kernel::orientation(p[a], p[b], p[c]) == kernel::Sign::negative) std::swap(b, c);
    file.triangles.push_back({a, b, c});
    file.cell_of.push_back(static_cast<std::int64_t>(cell));
  };
  for (std::size_t j = 0; j + 1 < ny; ++j)
    for (std::size_t i = 0; i + 1 < nx; ++i) {
      const std::size_t a = j * nx + i, b = a + 1, d = a + nx, c = d + 1;
      if (!known(a) || !known(b) || !known(c) || !known(d)) {
        ++missing;
        continue;
      }
      const auto& p = grid.points;
      // Up: from the corner with the least coordinates to that with the greatest.
      const bool rises = (p[c][0] - p[a][0] > 0) == (p[c][1] - p[a][1] > 0);
      bool first = diagonal == Diagonal::up ? rises : !rises;
      if (diagonal == Diagonal::shorter)
        first = std::hypot(p[c][0] - p[a][0], p[c][1] - p[a][1]) <=
                std::hypot(p[d][0] - p[b][0], p[d][1] - p[b][1]);
      const Index q[4] = {use(a), use(b), use(c), use(d)};
      const std::size_t cell = j * (nx - 1) + i;
      if (first) {
        add(q[0], q[1], q[2], cell);
        add(q[0], q[2], q[3], cell);
      } else {
        add(q[0], q[1], q[3], cell);
        add(q[1], q[2], q[3], cell);
      }
    }
  if (missing > 0)
    file.warnings.push_back(fmt::format("{} cells with a missing vector left out", missing));
  if (file.triangles.empty())
    fail("grid", "has no cell with four vectors", "give a grid of 2 by 2 points at least");
}

PlaneGrid grid_of_points(const std::vector<std::array<double, 4>>& points) {
  std::vector<double> x, y;
  for (const auto& p : points) {
    x.push_back(p[0]);
    y.push_back(p[1]);
  }
  for (auto* values : {&x, &y}) {
    std::sort(values->begin(), values->end());
    values->erase(std::unique(values->begin(), values->end()), values->end());
  }
  PlaneGrid grid{x.size(), y.size(), {}, {}};
  if (points.empty() || x.size() > 16 * points.size() / y.size() + 16)
    fail("points", "lie on no grid", "give rows and columns of points");
  for (const double b : y)
    for (const double a : x) grid.points.push_back({a, b});
  grid.vectors.assign(grid.points.size(), {std::nan(""), std::nan("")});
  const auto at = [](const std::vector<double>& values, double value) {
    return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), value) -
                                    values.begin());
  };
  for (const auto& p : points) grid.vectors[at(y, p[1]) * x.size() + at(x, p[0])] = {p[2], p[3]};
  return grid;
}

}  // namespace crest::io
