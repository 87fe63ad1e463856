// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/comparison.hpp"

#include <algorithm>
#include <cmath>

namespace crest::splines {
namespace {

using kernel::SampledGrid;

double sample(const SampledGrid& grid, const Cube& i) {
  return grid.at(static_cast<std::size_t>(i[0]) +
                 grid.size[0] * (static_cast<std::size_t>(i[1]) +
                                 grid.size[1] * static_cast<std::size_t>(i[2])));
}

int last(const SampledGrid& grid, std::size_t axis) {
  return static_cast<int>(grid.size[axis]) - 1;
}

/// The cell of unit side that holds v, and v from its lowest corner.
struct Cell {
  Cube at;
  Vec3 x;
};
Cell cell_of(const SampledGrid& grid, const Vec3& v) {
  Cell cell;
  for (std::size_t k = 0; k < 3; ++k) {
    cell.at[k] = std::clamp(static_cast<int>(std::floor(v[k])), 0, last(grid, k) - 1);
    cell.x[k] = v[k] - cell.at[k];
  }
  return cell;
}

/// Tensor product of weights and their derivatives along the axes; `at` is the first sample.
template <std::size_t N>
ValueAndGradient product(const std::array<std::array<double, N>, 3>& w,
                         const std::array<std::array<double, N>, 3>& d, const Cube& at,
                         const auto& value) {
  ValueAndGradient r{0, {0, 0, 0}};
  for (std::size_t z = 0; z < N; ++z)
    for (std::size_t y = 0; y < N; ++y)
      for (std::size_t x = 0; x < N; ++x) {
        const double f = value(Cube{at[0] + static_cast<int>(x), at[1] + static_cast<int>(y),
                                    at[2] + static_cast<int>(z)});
        r.value += w[0][x] * w[1][y] * w[2][z] * f;
        r.gradient[0] += d[0][x] * w[1][y] * w[2][z] * f;
        r.gradient[1] += w[0][x] * d[1][y] * w[2][z] * f;
        r.gradient[2] += w[0][x] * w[1][y] * d[2][z] * f;
      }
  return r;
}

ValueAndGradient interpolated(const SampledGrid& grid, const Vec3& v, const auto& value) {
  const Cell cell = cell_of(grid, v);
  std::array<std::array<double, 2>, 3> w, d;
  for (std::size_t k = 0; k < 3; ++k) {
    w[k] = {1 - cell.x[k], cell.x[k]};
    d[k] = {-1, 1};
  }
  return product(w, d, cell.at, value);
}

}  // namespace

ValueAndGradient linear_on_partition(const SampledGrid& grid, const Vec3& v) {
  const Cell cell = cell_of(grid, v);
  Vec3 p;  // in the lattice, from the centre
  for (std::size_t k = 0; k < 3; ++k) p[k] = 2 * cell.x[k] - 1;
  const std::size_t t = locate(p[0], p[1], p[2]);
  const Tetrahedron& s = kTetrahedron[t];
  std::array<double, 4> b{};
  for (int i = 0; i < 8; ++i) {
    const Cube corner = {i & 1, i >> 1 & 1, i >> 2};
    const double f =
        sample(grid, {cell.at[0] + corner[0], cell.at[1] + corner[1], cell.at[2] + corner[2]});
    const Lattice x = {2 * corner[0] - 1, 2 * corner[1] - 1, 2 * corner[2] - 1};
    b[kC] += f / 8;
    if (x[s.face_axis] == s.face_sign) b[kD] += f / 4;
    if (x == s.corners[kA]) b[kA] = f;
    if (x == s.corners[kB]) b[kB] = f;
  }
  const auto l = barycentric(t, p);
  Vec3 g = gradient(t, b);
  for (double& x : g) x *= 2;
  return {l[0] * b[0] + l[1] * b[1] + l[2] * b[2] + l[3] * b[3], g};
}

ValueAndGradient freudenthal_quadratic(const SampledGrid& grid, const Vec3& v) {
  Cube at;
  Vec3 x;  // in the cube of side 2, scaled to side 1
  for (std::size_t k = 0; k < 3; ++k) {
    const int whole = last(grid, k) / 2;
    const int cube = std::clamp(static_cast<int>(std::floor(v[k] / 2)), 0, whole - 1);
    at[k] = 2 * cube;
    x[k] = (v[k] - at[k]) / 2;
  }
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t k) { return x[i] > x[k]; });
  // Corners: from the lowest along the axes in this order.
  std::array<Cube, 4> corner = {at, at, at, at};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = i + 1; k < 4; ++k) corner[k][order[i]] += 2;
  std::array<double, 4> l = {1 - x[order[0]], x[order[0]] - x[order[1]], x[order[1]] - x[order[2]],
                             x[order[2]]};
  QuadraticNet<double> net;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i; k < 4; ++k) {
      const Cube middle = {(corner[i][0] + corner[k][0]) / 2, (corner[i][1] + corner[k][1]) / 2,
                           (corner[i][2] + corner[k][2]) / 2};
      const double mean = 0.5 * (sample(grid, corner[i]) + sample(grid, corner[k]));
      net.c[n++] = i == k ? mean : 2 * sample(grid, middle) - mean;
    }
  const auto r = kernel::value_and_gradient_at(net, l);
  ValueAndGradient s{r.value, {}};
  for (std::size_t i = 0; i < 3; ++i)
    s.gradient[order[i]] = 0.5 * (r.gradient[i + 1] - r.gradient[i]);
  return s;
}

ValueAndGradient trilinear(const SampledGrid& grid, const Vec3& v) {
  return interpolated(grid, v, [&](const Cube& i) { return sample(grid, i); });
}

ValueAndGradient trilinear_differences(const SampledGrid& grid, const Vec3& v) {
  ValueAndGradient r = trilinear(grid, v);
  for (std::size_t k = 0; k < 3; ++k)
    r.gradient[k] = interpolated(grid, v, [&](const Cube& i) {
                      Cube low = i, high = i;
                      low[k] = std::max(low[k] - 1, 0);
                      high[k] = std::min(high[k] + 1, last(grid, k));
                      return (sample(grid, high) - sample(grid, low)) / (high[k] - low[k]);
                    }).value;
  return r;
}

ValueAndGradient triquadratic(const SampledGrid& grid, const Vec3& v) {
  Cube first;
  std::array<std::array<double, 3>, 3> w, d;
  for (std::size_t k = 0; k < 3; ++k) {
    const int near = std::clamp(static_cast<int>(std::floor(v[k] + 0.5)), 1, last(grid, k) - 1);
    const double u = v[k] - near;
    first[k] = near - 1;
    w[k] = {0.5 * (0.5 - u) * (0.5 - u), 0.75 - u * u, 0.5 * (0.5 + u) * (0.5 + u)};
    d[k] = {u - 0.5, -2 * u, u + 0.5};
  }
  return product(w, d, first, [&](const Cube& i) { return sample(grid, i); });
}

}  // namespace crest::splines
