// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/mesh_surface.hpp"

#include <tbb/blocked_range.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include "algorithms/sampling/handles.hpp"
#include "algorithms/sampling/uniform.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::sampling {
namespace {

using kernel::Index;
using kernel::Triangle;

constexpr Real kPi = 3.14159265358979323846264338327950288L;
constexpr int kSmoothingRounds = 6;
constexpr Real kJitter = 0.2L;  // of a cell, each way

struct Grid {
  std::vector<Point> points;  // body
  std::vector<Triangle> faces;
};

/// Calls f(i) for each index; every call writes its own result, so threads do not matter.
template <class F>
void for_each_index(std::size_t n, const F& f) {
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, n, 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) f(i);
  });
}

struct Icosahedron {
  std::array<Point, 12> corners;
  std::array<std::array<Index, 3>, 20> faces;
};
Icosahedron icosahedron() {
  const Real g = (1 + std::sqrt(Real(5))) / 2;
  return {{{{-1, g, 0},
            {1, g, 0},
            {-1, -g, 0},
            {1, -g, 0},
            {0, -1, g},
            {0, 1, g},
            {0, -1, -g},
            {0, 1, -g},
            {g, 0, -1},
            {g, 0, 1},
            {-g, 0, -1},
            {-g, 0, 1}}},
          {{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
            {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
            {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}}};
}

/// Directions of the icosahedron whose sides are cut into n; neighbouring faces share the points of
/// their sides.
class SphereGrid {
 public:
  explicit SphereGrid(Index n) : n_(n), base_(icosahedron()) {
    for (const Point& p : base_.corners) grid_.points.push_back((1 / norm(p)) * p);
    for (const auto& f : base_.faces) fill(f);
  }
  Grid grid_;

 private:
  Index add(const Point& p) {
    grid_.points.push_back((1 / norm(p)) * p);
    return static_cast<Index>(grid_.points.size() - 1);
  }
  /// Point k of n from corner a to corner b.
  Index on_side(Index a, Index b, Index k) {
    if (k == 0) return a;
    if (k == n_) return b;
    if (a > b) return on_side(b, a, n_ - k);
    auto [at, fresh] = sides_.try_emplace({a, b}, 0);
    if (fresh) {
      at->second = static_cast<Index>(grid_.points.size());
      for (Index j = 1; j < n_; ++j)
        add(Real(n_ - j) * base_.corners[a] + Real(j) * base_.corners[b]);
    }
    return at->second + k - 1;
  }
  void fill(const std::array<Index, 3>& f) {
    const auto& [a, b, c] = f;
    std::vector<std::vector<Index>> rows(n_ + 1);  // row i has n - i + 1 points
    for (Index i = 0; i <= n_; ++i)
      for (Index j = 0; i + j <= n_; ++j) {
        if (i == 0)
          rows[i].push_back(on_side(a, b, j));
        else if (j == 0)
          rows[i].push_back(on_side(a, c, i));
        else if (i + j == n_)
          rows[i].push_back(on_side(b, c, i));
        else
          rows[i].push_back(add(Real(n_ - i - j) * base_.corners[a] + Real(j) * base_.corners[b] +
                                Real(i) * base_.corners[c]));
      }
    for (Index i = 0; i < n_; ++i)
      for (Index j = 0; i + j < n_; ++j) {
        grid_.faces.push_back({rows[i][j], rows[i][j + 1], rows[i + 1][j]});
        if (i + j + 1 < n_)
          grid_.faces.push_back({rows[i][j + 1], rows[i + 1][j + 1], rows[i + 1][j]});
      }
  }
  Index n_;
  Icosahedron base_;
  std::map<std::pair<Index, Index>, Index> sides_;
};

Grid star_grid(const Surface& s, int vertices, bool rotate) {
  const double n = std::round(std::sqrt((vertices - 2) / 10.0));
  Grid grid = std::move(SphereGrid(static_cast<Index>(std::max(1.0, n))).grid_);
  const Surface::Rotation turn = generic_rotation(1);
  for (Point& p : grid.points) {
    if (rotate) p = turn * p;
    // Plain rays starve the tips of long surfaces, affine images stretch their sides: halfway.
    for (std::size_t i = 0; i < 3; ++i) p[i] = s.centre[i] + std::sqrt(s.reach[i]) * p[i];
  }
  return grid;
}

/// The two triangles of cell (i, j) with corners a b / c d, the diagonal alternating.
void add_cell(Grid& grid, Index i, Index j, Index a, Index b, Index c, Index d) {
  if ((i + j) % 2 == 0) {
    grid.faces.push_back({a, b, d});
    grid.faces.push_back({a, d, c});
  } else {
    grid.faces.push_back({a, b, c});
    grid.faces.push_back({b, d, c});
  }
}

Grid torus_grid(const Surface& s, int vertices) {
  // Even numbers of cells close the pattern of diagonals.
  const double ratio = static_cast<double>(s.size / s.tube);
  const auto even = [](double x) {
    return static_cast<Index>(2 * std::max(2.0, std::round(x / 2)));
  };
  const Index cells_v = even(std::sqrt(vertices / ratio));
  const Index cells_u = even(static_cast<double>(vertices) / cells_v);
  Uniform uniform(1);
  const auto jitter = [&] { return kJitter * (2 * Real(uniform()) - 1); };
  Grid grid;
  for (Index i = 0; i < cells_u; ++i)
    for (Index j = 0; j < cells_v; ++j) {
      const Real u = 2 * kPi * (Real(i) + jitter()) / Real(cells_u);
      const Real v = 2 * kPi * (Real(j) + jitter()) / Real(cells_v);
      const Real rho = s.size + s.tube * std::cos(v);
      grid.points.push_back({rho * std::cos(u), rho * std::sin(u), s.tube * std::sin(v)});
    }
  const auto at = [&](Index i, Index j) { return (i % cells_u) * cells_v + j % cells_v; };
  for (Index i = 0; i < cells_u; ++i)
    for (Index j = 0; j < cells_v; ++j)
      add_cell(grid, i, j, at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1));
  return grid;
}

Grid patch_grid(const Surface& s, int vertices) {
  const Index cells =
      static_cast<Index>(std::max(2.0, std::round(std::sqrt(static_cast<double>(vertices)) - 1)));
  Uniform uniform(2);
  Grid grid;
  const auto place = [&](Index i) {
    const bool inside = i != 0 && i != cells;
    const Real shift = kJitter * (2 * Real(uniform()) - 1);
    return 2 * (Real(i) + (inside ? shift : 0)) / Real(cells) - 1;
  };
  for (Index i = 0; i <= cells; ++i)
    for (Index j = 0; j <= cells; ++j) {
      const Real u = place(i);
      const Real v = place(j);
      grid.points.push_back(s.chart(u, v));
    }
  const auto at = [&](Index i, Index j) { return i * (cells + 1) + j; };
  for (Index i = 0; i < cells; ++i)
    for (Index j = 0; j < cells; ++j)
      add_cell(grid, i, j, at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1));
  return grid;
}

void project_all(const Surface& s, std::vector<Point>& points) {
  for_each_index(points.size(), [&](std::size_t v) {
    const Point origin = s.ray_origin(points[v]);
    points[v] = project_along_ray(*s.implicit, origin, points[v] - origin);
  });
}

/// Moves each point halfway to the mean of its neighbours, along the tangent plane. Closed meshes.
void smooth(const Surface& s, Grid& grid) {
  std::vector<Point> sum(grid.points.size(), Point{});
  std::vector<int> count(grid.points.size(), 0);
  for (const Triangle& f : grid.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      // In a closed mesh every neighbour follows the vertex in exactly one face.
      sum[f[k]] = sum[f[k]] + grid.points[f[(k + 1) % 3]];
      ++count[f[k]];
    }
  for_each_index(grid.points.size(), [&](std::size_t v) {
    const Point g = gradient(*s.implicit, grid.points[v]).gradient;
    const Point move = (Real(1) / Real(count[v])) * sum[v] - grid.points[v];
    grid.points[v] = grid.points[v] + Real(0.5L) * (move - (dot(move, g) / dot(g, g)) * g);
  });
  project_all(s, grid.points);
}

}  // namespace

SurfaceSample sample(const Surface& surface, int vertices, bool rotate, Forms forms) {
  if (vertices < 12 || vertices > 100000000)
    throw std::invalid_argument("sample: the number of vertices must be from 12 to 10^8");
  Grid grid;
  switch (surface.shape) {
    case Surface::Shape::star:
      grid = star_grid(surface, vertices, rotate);
      break;
    case Surface::Shape::torus:
      grid = torus_grid(surface, vertices);
      break;
    case Surface::Shape::patch:
      grid = patch_grid(surface, vertices);
      break;
  }
  project_all(surface, grid.points);
  if (surface.shape != Surface::Shape::patch)
    for (int round = 0; round < kSmoothingRounds; ++round) smooth(surface, grid);

  SurfaceSample out;
  out.known = surface.known;
  out.faces = std::move(grid.faces);
  out.points.resize(grid.points.size());
  out.forms.resize(forms == Forms::exact ? grid.points.size() : 0);
  for_each_index(out.points.size(), [&](std::size_t v) {
    out.points[v] = to_vec3(surface.to_world(grid.points[v]));
    if (forms == Forms::exact) out.forms[v] = surface.monge_form(out.points[v]);
  });
  return out;
}

SurfaceSample sample(const std::string& name, const std::vector<double>& parameters, int vertices,
                     bool rotate, Forms forms) {
  if (name == "handles") {
    if (parameters.size() > 1 ||
        (!parameters.empty() && parameters[0] != std::floor(parameters[0])))
      throw std::invalid_argument("handles: one parameter, the genus, a whole number");
    return sample_handles(parameters.empty() ? 2 : static_cast<int>(parameters[0]), vertices,
                          rotate);
  }
  return sample(make_surface(name, parameters, rotate), vertices, rotate, forms);
}

double mean_edge_length(const std::vector<Vec3>& points, const std::vector<Triangle>& faces) {
  double sum = 0;
  for (const Triangle& f : faces)
    for (std::size_t k = 0; k < 3; ++k)
      sum += kernel::distance(points[f[k]], points[f[(k + 1) % 3]]);
  return faces.empty() ? 0 : sum / (3.0 * static_cast<double>(faces.size()));
}

void add_normal_noise(std::vector<Vec3>& points, const std::vector<Vec3>& normals, double sigma,
                      std::uint64_t seed) {
  if (!normals.empty() && normals.size() != points.size())
    throw std::invalid_argument("add_normal_noise: one normal a point, or none");
  Uniform uniform(seed);
  // Box and Muller; std::normal_distribution differs between standard libraries.
  const auto normal = [&] {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * static_cast<double>(kPi) * uniform());
  };
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (normals.empty()) {
      for (double& x : points[v]) x += sigma * normal();
    } else {
      const double s = sigma * normal();
      for (std::size_t i = 0; i < 3; ++i) points[v][i] += s * normals[v][i];
    }
  }
}

std::vector<Vec3> normals(const SurfaceSample& sample) {
  std::vector<Vec3> result;
  result.reserve(sample.forms.size());
  for (const kernel::MongeForm& m : sample.forms) result.push_back(m.n);
  return result;
}

}  // namespace crest::sampling
