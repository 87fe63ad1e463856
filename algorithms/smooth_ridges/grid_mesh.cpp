// SPDX-License-Identifier: GPL-3.0-or-later
// Start triangulations of parametric surfaces.
#include <algorithm>
#include <cmath>

#include "algorithms/smooth_ridges/initial_mesh.hpp"

namespace crest::smooth_ridges {
namespace {

constexpr double kOffset = 0.0137;  // of a period
constexpr double kJitter = 0.2;     // of a cell, each way

/// Evenly spread over [-1, 1): the plastic number's sequence (Roberts 2018).
double pattern(std::size_t i, std::size_t j, std::size_t direction) {
  const double a = direction == 0 ? 0.7548776662466927 : 0.5698402909980532;
  const double b = direction == 0 ? 0.5497004779019703 : 0.8566748838545029;
  const double x = 0.5 + a * static_cast<double>(i) + b * static_cast<double>(j);
  return 2 * (x - std::floor(x)) - 1;
}

class UnitGrid {
 public:
  UnitGrid(const Surface& surface, int target) : surface_(surface), metric_(surface) {
    choose_cells(target);
  }

  Triangulation make() {
    for (std::size_t i = 0; i < rows(0); ++i)
      for (std::size_t j = 0; j < rows(1); ++j) add_vertex(i, j);
    for (std::size_t i = 0; i < cells_[0]; ++i)
      for (std::size_t j = 0; j < cells_[1]; ++j) add_cell(i, j);
    return {std::move(vertices_), std::move(faces_), std::move(lifts_), edge_rules(surface_)};
  }

 private:
  struct Corner {
    Index vertex;
    std::array<int, 2> wraps;
    std::array<double, 2> unwrapped;
  };

  std::size_t rows(std::size_t direction) const {
    return cells_[direction] + (surface_.periodic(direction) ? 0 : 1);
  }

  /// Cells near square in the mean metric; at least what makes the grid a complex.
  void choose_cells(int target) {
    constexpr int kSamples = 16;
    std::array<double, 2> size{};
    for (int i = 0; i < kSamples; ++i)
      for (int j = 0; j < kSamples; ++j) {
        const auto x = metric_({(i + 0.5) / kSamples, (j + 0.5) / kSamples});
        const auto norm = [&](int a, int b) {
          double sum = 0;
          for (const auto& c : x) sum += c.coefficient(a, b) * c.coefficient(a, b);
          return std::sqrt(sum);
        };
        size[0] += norm(1, 0);
        size[1] += norm(0, 1);
      }
    const double ratio = size[0] > 0 && size[1] > 0 ? size[0] / size[1] : 1;
    const double cells = target / 2.0;
    for (std::size_t d = 0; d < 2; ++d) {
      const double wanted = std::sqrt(cells * (d == 0 ? ratio : 1 / ratio));
      const double least = surface_.periodic(d) ? 5 : 2;
      cells_[d] = static_cast<std::size_t>(std::clamp(std::round(wanted), least, cells));
      if (d == 0) continue;
      const double rest = std::round(cells / static_cast<double>(cells_[1]));
      cells_[0] = static_cast<std::size_t>(std::max(surface_.periodic(0) ? 5.0 : 2.0, rest));
    }
  }

  void add_vertex(std::size_t i, std::size_t j) {
    Vertex v{};
    std::array<int, 2> wraps{};
    const std::array<std::size_t, 2> at = {i, j};
    for (std::size_t d = 0; d < 2; ++d) {
      const double n = static_cast<double>(cells_[d]);
      const bool fixed = !surface_.periodic(d) && (at[d] == 0 || at[d] == cells_[d]);
      const double shift = fixed ? 0 : kJitter * pattern(i, j, d);
      double x = (static_cast<double>(at[d]) + shift) / n;
      if (surface_.periodic(d)) {
        x += kOffset;
        const double whole = std::floor(x);
        x = (x - whole + 1) - 1;  // a multiple of 2^-52
        wraps[d] = static_cast<int>(whole) + (x < 1 ? 0 : 1);
        if (!(x < 1)) x = 0;
      }
      v[d] = x;
    }
    vertices_.push_back(v);
    wraps_.push_back(wraps);
  }

  Corner corner(std::size_t i, std::size_t j) const {
    const std::array<std::size_t, 2> at = {i, j};
    std::array<std::size_t, 2> in = at;
    Corner c{};
    for (std::size_t d = 0; d < 2; ++d)
      if (at[d] == rows(d)) {
        in[d] = 0;
        c.wraps[d] = 1;
      }
    c.vertex = static_cast<Index>(in[0] * rows(1) + in[1]);
    for (std::size_t d = 0; d < 2; ++d) {
      c.wraps[d] += wraps_[c.vertex][d];
      c.unwrapped[d] = vertices_[c.vertex][d] + c.wraps[d];
    }
    return c;
  }

  double distance(const Corner& a, const Corner& b) {
    const double du = b.unwrapped[0] - a.unwrapped[0], dv = b.unwrapped[1] - a.unwrapped[1];
    const auto x =
        metric_({(a.unwrapped[0] + b.unwrapped[0]) / 2, (a.unwrapped[1] + b.unwrapped[1]) / 2});
    double sum = 0;
    for (const auto& c : x) {
      const double d = c.coefficient(1, 0) * du + c.coefficient(0, 1) * dv;
      sum += d * d;
    }
    return sum;
  }

  void add_cell(std::size_t i, std::size_t j) {
    const Corner a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                 d = corner(i, j + 1);
    if (distance(a, c) <= distance(b, d)) {
      add_face({a, b, c});
      add_face({a, c, d});
    } else {
      add_face({a, b, d});
      add_face({b, c, d});
    }
  }

  void add_face(const std::array<Corner, 3>& corners) {
    unsigned lift = 0;
    for (std::size_t d = 0; d < 2; ++d) {
      const int least = std::min({corners[0].wraps[d], corners[1].wraps[d], corners[2].wraps[d]});
      for (std::size_t k = 0; k < 3; ++k)
        if (corners[k].wraps[d] > least) lift |= 1u << (3 * d + k);
    }
    faces_.push_back({corners[0].vertex, corners[1].vertex, corners[2].vertex});
    lifts_.push_back(static_cast<std::uint8_t>(lift));
  }

  const Surface& surface_;
  ParametricMap<double, 1> metric_;
  std::array<std::size_t, 2> cells_{};
  std::vector<Vertex> vertices_;
  std::vector<std::array<int, 2>> wraps_;
  std::vector<Triangle> faces_;
  std::vector<std::uint8_t> lifts_;
};

}  // namespace

Triangulation grid_mesh(const Surface& surface, int target) {
  return UnitGrid(surface, target).make();
}

}  // namespace crest::smooth_ridges
