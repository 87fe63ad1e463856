// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/sine_projection.hpp"

#include <tbb/blocked_range.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "algorithms/splines/grid_sums.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::splines {
namespace {

using Eigen::MatrixXd;

/// The eigenvectors of difference times its transpose, of size n: sines, orthonormal and symmetric.
MatrixXd sines(std::size_t n) {
  MatrixXd s(n, n);
  const double scale = std::sqrt(2 / static_cast<double>(n + 1));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      // Reduced: the sine's argument stays small.
      const std::size_t turn = (i + 1) * (j + 1) % (2 * n + 2);
      s(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          scale *
          std::sin(std::numbers::pi * static_cast<double>(turn) / static_cast<double>(n + 1));
    }
  return s;
}

/// The eigenvalues; those of sum times its transpose are 4 less these.
std::vector<double> eigenvalues(std::size_t n) {
  std::vector<double> l(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double half =
        std::sin(std::numbers::pi * static_cast<double>(k + 1) / static_cast<double>(2 * (n + 1)));
    l[k] = 4 * half * half;
  }
  return l;
}

void transform(GridArray& a, std::size_t axis) {
  const auto n = static_cast<Eigen::Index>(a.size[axis]);
  const MatrixXd s = sines(a.size[axis]);
  if (axis == 0) {
    const std::size_t columns = a.size[1] * a.size[2];
    kernel::parallel_for(tbb::blocked_range<std::size_t>(0, columns, 64), [&](const auto& range) {
      Eigen::Map<MatrixXd> part(&a.x[range.begin() * a.size[0]], n,
                                static_cast<Eigen::Index>(range.size()));
      part = (s * part).eval();
    });
    return;
  }
  // Slabs of rows across the axis: each a matrix of a row's length times n.
  const std::size_t slabs = axis == 1 ? a.size[2] : a.size[1];
  const auto rows = static_cast<Eigen::Index>(a.size[0]);
  const std::size_t start = axis == 1 ? a.size[0] * a.size[1] : a.size[0];
  const std::size_t stride = axis == 1 ? a.size[0] : a.size[0] * a.size[1];
  kernel::parallel_for(std::size_t{0}, slabs, [&](std::size_t slab) {
    Eigen::Map<MatrixXd, 0, Eigen::OuterStride<>> part(
        &a.x[slab * start], rows, n, Eigen::OuterStride<>(static_cast<Eigen::Index>(stride)));
    part = (part * s).eval();
  });
}

/// Solves the normal equations: transforms along the axes, divides by `eigenvalue` of the places,
/// transforms back.
template <class Eigenvalue>
void solve(GridArray& residual, std::initializer_list<std::size_t> axes,
           const Eigenvalue& eigenvalue) {
  for (const std::size_t axis : axes) transform(residual, axis);
  for (std::size_t k = 0; k < residual.size[2]; ++k)
    for (std::size_t j = 0; j < residual.size[1]; ++j)
      for (std::size_t i = 0; i < residual.size[0]; ++i)
        residual.at(i, j, k) /= eigenvalue(i, j, k);
  for (const std::size_t axis : axes) transform(residual, axis);
}

class Projection {
 public:
  explicit Projection(CubicModel& model) : model_(model) {
    for (std::size_t d = 0; d < 3; ++d) {
      cubes_[d] = model.domain.cubes[d];
      vertices_[d] = cubes_[d] + 1;
      l_[d] = eigenvalues(cubes_[d]);
    }
  }

  /// V: delta_x delta_y delta_z f = 1/2 sum of sigma_d delta_b delta_c g_d.
  void vertices() {
    GridArray f = take(model_.vertices, 0, vertices_);
    std::array<GridArray, 3> g{take(model_.vertices, 1, vertices_),
                               take(model_.vertices, 2, vertices_),
                               take(model_.vertices, 3, vertices_)};
    GridArray r = difference(difference(difference(f, 0), 1), 2);
    for (std::size_t d = 0; d < 3; ++d) r.add(-0.5, mixed(g[d], d));
    solve(r, {0, 1, 2}, [&](std::size_t i, std::size_t j, std::size_t k) {
      const double x = l_[0][i], y = l_[1][j], z = l_[2][k];
      return x * y * z + ((4 - x) * y * z + x * (4 - y) * z + x * y * (4 - z)) / 4;
    });
    f -= difference_transposed(difference_transposed(difference_transposed(r, 0), 1), 2);
    for (std::size_t d = 0; d < 3; ++d) {
      const auto [b, c] = kAcross[d];
      g[d].add(0.5, sum_transposed(difference_transposed(difference_transposed(r, c), b), d));
      put(g[d], model_.vertices, d + 1);
    }
    put(f, model_.vertices, 0);
  }

  /// E_a: sigma_b delta_c t_b + delta_b sigma_c t_c = 1/2 (sigma_a sigma_b delta_c g_b +
  /// sigma_a delta_b sigma_c g_c - delta_a delta_b delta_c g_a), slab by slab across a.
  void slopes(std::size_t a) {
    const auto [b, c] = kAcross[a];
    auto edges = vertices_;
    edges[a] = cubes_[a];
    GridArray tb = take(model_.slopes, 2 * a, edges), tc = take(model_.slopes, 2 * a + 1, edges);
    const auto g = [&](std::size_t d) { return take(model_.vertices, d + 1, vertices_); };
    GridArray r = difference(sum(tb, b), c);
    r += sum(difference(tc, b), c);
    r.add(-0.5, difference(sum(sum(g(b), a), b), c));
    r.add(-0.5, sum(difference(sum(g(c), a), b), c));
    r.add(0.5, difference(difference(difference(g(a), a), b), c));
    solve(r, {b, c}, [&](std::size_t i, std::size_t j, std::size_t k) {
      const std::array<std::size_t, 3> at{i, j, k};
      const double lb = l_[b][at[b]], lc = l_[c][at[c]];
      return (4 - lb) * lc + lb * (4 - lc);
    });
    tb -= sum_transposed(difference_transposed(r, c), b);
    tc -= difference_transposed(sum_transposed(r, c), b);
    put(tb, model_.slopes, 2 * a);
    put(tc, model_.slopes, 2 * a + 1);
  }

 private:
  /// sigma along an axis, delta across.
  static GridArray mixed(const GridArray& g, std::size_t axis) {
    const auto [b, c] = kAcross[axis];
    return difference(difference(sum(g, axis), b), c);
  }
  /// A component of numbers at vertices, of the first places of each axis.
  template <class Numbers>
  GridArray take(const std::vector<Numbers>& from, std::size_t component,
                 const std::array<std::size_t, 3>& size) const {
    GridArray r(size);
    for_each(r, [&](double& x, std::size_t vertex) { x = from[vertex][component]; });
    return r;
  }
  template <class Numbers>
  void put(GridArray& from, std::vector<Numbers>& to, std::size_t component) const {
    for_each(from, [&](double& x, std::size_t vertex) { to[vertex][component] = x; });
  }
  template <class Visit>
  void for_each(GridArray& a, const Visit& visit) const {
    for (std::size_t k = 0; k < a.size[2]; ++k)
      for (std::size_t j = 0; j < a.size[1]; ++j)
        for (std::size_t i = 0; i < a.size[0]; ++i)
          visit(a.at(i, j, k), model_.domain.vertex(i, j, k));
  }

  CubicModel& model_;
  std::array<std::size_t, 3> cubes_, vertices_;
  std::array<std::vector<double>, 3> l_;
};

}  // namespace

void project_to_c1(CubicModel& model) {
  Projection projection(model);
  projection.vertices();
  for (std::size_t a = 0; a < 3; ++a) projection.slopes(a);
}

}  // namespace crest::splines
