// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/coarse_grid.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>

#include "kernel/geometry/parallel.hpp"

namespace crest::io {
namespace {

using kernel::Vec3;

double median_side(const kernel::TriangleMesh& mesh) {
  std::vector<double> lengths(mesh.face_count());
  kernel::parallel_for(tbb::blocked_range<kernel::Index>(0, mesh.face_count(), 16384),
                       [&](const auto& range) {
                         for (kernel::Index f = range.begin(); f != range.end(); ++f)
                           lengths[f] = kernel::distance(mesh.points()[mesh.faces()[f][0]],
                                                         mesh.points()[mesh.faces()[f][1]]);
                       });
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>((lengths.size() - 1) / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

double half_diagonal(const std::vector<Vec3>& points) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3& p : points) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  return 0.5 * kernel::distance(low, high);
}

struct Axis {
  const std::vector<Vec3>& points;
  std::size_t k;
  template <class Test>
  bool all(const Test& test) const {
    return std::all_of(points.begin(), points.end(), [&](const Vec3& p) { return test(p[k]); });
  }
  double reach() const {
    double reach = 0;
    for (const Vec3& p : points) reach = std::max(reach, std::fabs(p[k]));
    return reach;
  }
};

/// x is the double nearest to a multiple of 10^power.
bool is_decimal(double x, int power) {
  const double scale = std::pow(10.0, std::abs(power));
  const double multiple = std::nearbyint(power < 0 ? x * scale : x / scale);
  return std::fabs(multiple) < 0x1p53 && (power < 0 ? multiple / scale : multiple * scale) == x;
}

/// The largest power of two or ten above `least` that divides an axis, or 0. Powers of ten beyond
/// 22 are no doubles.
double grid_of(const Axis& axis, double least) {
  double grid = 0;
  for (int power = std::ilogb(least) + 1; power < 1024; ++power) {
    const double g = std::ldexp(1.0, power);
    if (!axis.all([&](double x) { return std::fmod(x, g) == 0; })) break;
    grid = g;
  }
  const int first = static_cast<int>(std::floor(std::log10(least))) + 1;
  for (int power = first; std::abs(power) <= 22; ++power) {
    if (!axis.all([&](double x) { return is_decimal(x, power); })) break;
    grid = std::max(grid, std::pow(10.0, power));
  }
  return grid;
}

}  // namespace

std::optional<std::string> coarse_grid(const kernel::TriangleMesh& mesh) {
  const double side = median_side(mesh), size = half_diagonal(mesh.points());
  const double least = std::max(side / 1024, 4 * side * (side / size) * (side / size));
  double coarsest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Axis axis{mesh.points(), k};
    if (axis.all([first = mesh.points()[0][k]](double x) { return x == first; })) continue;
    const double grid = std::isnormal(least) ? grid_of(axis, least) : 0;
    if (grid >= 0.5 * side && axis.reach() <= 0x1p20 * grid) continue;
    coarsest = std::max(coarsest, grid);
  }
  if (coarsest == 0) return std::nullopt;
  return fmt::format(
      "coordinates look rounded: they are multiples of {:.6g}, half of the edges are shorter than "
      "{:.6g}; curvatures, ridges and umbilics may be those of the rounding: export doubles, or "
      "move the mesh to the origin before it is rounded",
      coarsest, side);
}

}  // namespace crest::io
