// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/quadratic.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>

#include <bit>
#include <cmath>
#include <limits>

#include "kernel/arithmetic/rational.hpp"
#include "kernel/geometry/input_error.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::splines {

using kernel::operator*;
using kernel::Rational;

namespace {

/// Magnitudes of samples: the largest, and the step of which all are multiples.
struct Magnitudes {
  double largest = 0;
  int lowest_bit = std::numeric_limits<int>::max();
};

template <class Native>
Magnitudes magnitudes_of(const std::vector<Native>& samples) {
  return kernel::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, samples.size(), 1 << 16), Magnitudes{},
      [&](const auto& range, Magnitudes m) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          const auto x = static_cast<double>(samples[i]);
          m.largest = std::max(m.largest, std::fabs(x));
          if constexpr (std::is_integral_v<Native>) {
            m.lowest_bit = 0;
          } else if (x != 0) {
            // 53 bits of mantissa, less the zeros at its end.
            const auto bits = std::bit_cast<std::uint64_t>(x) | std::uint64_t{1} << 52;
            m.lowest_bit = std::min(m.lowest_bit, std::ilogb(x) - 52 + std::countr_zero(bits));
          }
        }
        return m;
      },
      [](const Magnitudes& a, const Magnitudes& b) {
        return Magnitudes{std::fmax(a.largest, b.largest), std::min(a.lowest_bit, b.lowest_bit)};
      });
}

/// A sample before the first or behind the last along one axis: 2 f_0 - f_1.
struct Share {
  std::size_t at;
  int weight;
};
std::array<Share, 2> shares(int v, std::size_t size) {
  const auto n = static_cast<int>(size);
  if (v < 0) return {{{0, 2}, {1, -1}}};
  if (v >= n) return {{{size - 1, 2}, {size - 2, -1}}};
  return {{{static_cast<std::size_t>(v), 1}, {0, 0}}};
}

}  // namespace

QuadraticSpline::QuadraticSpline(kernel::SampledGrid grid, Border border)
    : grid_(std::move(grid)), border_(border) {
  const int first = border == Border::extend ? 0 : 1;
  for (std::size_t k = 0; k < 3; ++k) {
    if (grid_.size[k] < 3)
      throw kernel::InputError(fmt::format(
          "samples: {} x {} x {} have no cube round an interior one; give a volume of 3 x 3 x 3 or "
          "more",
          grid_.size[0], grid_.size[1], grid_.size[2]));
    cubes_[k] = static_cast<int>(grid_.size[k]) - 2 * first;
  }
  frame_ = LatticeFrame(grid_, first);
  const Magnitudes m =
      std::visit([](const auto& samples) { return magnitudes_of(samples); }, grid_.samples);
  // An extended sample is at most 27 times as large. Coefficients are multiples of 2^-7 steps, sums
  // on the way below 2^6 times the largest sample.
  largest_ = border == Border::extend ? 27 * m.largest : m.largest;
  if (m.largest == 0) {
    exact_ = true;
  } else if (std::isfinite(64 * largest_) && m.lowest_bit > -1000) {
    step_ = std::ldexp(1, m.lowest_bit - 7);
    bits_ = std::ilogb(largest_) + 2 - (m.lowest_bit - 7);
    exact_ = bits_ + 4 < 53;
  }
}

std::size_t QuadraticSpline::cube_count() const {
  std::size_t count = 1;
  for (const int n : cubes_) count *= static_cast<std::size_t>(n);
  return count;
}

template <class T>
Stencil<T> QuadraticSpline::stencil(const Cube& cube) const {
  const int from = frame_.first() - 1;
  const auto& size = grid_.size;
  return std::visit(
      [&](const auto& samples) {
        Stencil<T> f;
        const auto inside = [&](std::size_t k) {
          return cube[k] + from >= 0 && cube[k] + from + 2 < static_cast<int>(size[k]);
        };
        if (inside(0) && inside(1) && inside(2)) {
          const auto* p = samples.data() + static_cast<std::size_t>(cube[0] + from) +
                          size[0] * (static_cast<std::size_t>(cube[1] + from) +
                                     size[1] * static_cast<std::size_t>(cube[2] + from));
          for (std::size_t z = 0; z < 3; ++z)
            for (std::size_t y = 0; y < 3; ++y)
              for (std::size_t x = 0; x < 3; ++x)
                f[x + 3 * y + 9 * z] = static_cast<T>(p[x + size[0] * (y + size[1] * z)]);
          return f;
        }
        for (int i = 0; i < 27; ++i) {
          T sum(0);
          for (const Share& z : shares(cube[2] + from + i / 9, size[2]))
            for (const Share& y : shares(cube[1] + from + i / 3 % 3, size[1]))
              for (const Share& x : shares(cube[0] + from + i % 3, size[0]))
                if (const int w = x.weight * y.weight * z.weight; w != 0)
                  sum = sum + static_cast<T>(w) *
                                  static_cast<T>(samples[x.at + size[0] * (y.at + size[1] * z.at)]);
          f[static_cast<std::size_t>(i)] = sum;
        }
        return f;
      },
      grid_.samples);
}
template Stencil<double> QuadraticSpline::stencil(const Cube&) const;
template Stencil<long double> QuadraticSpline::stencil(const Cube&) const;
template Stencil<Rational> QuadraticSpline::stencil(const Cube&) const;

Cube QuadraticSpline::cube_at(const Vec3& lattice) const {
  Cube cube;
  for (std::size_t k = 0; k < 3; ++k)
    cube[k] = std::clamp(static_cast<int>(std::floor(0.5 * lattice[k])), 0, cubes_[k] - 1);
  return cube;
}

ValueAndGradient QuadraticSpline::evaluate(const Vec3& p) const {
  ValueAndGradient one;
  evaluate({&p, 1}, {&one, 1});
  return one;
}

void QuadraticSpline::evaluate(std::span<const Vec3> points,
                               std::span<ValueAndGradient> values) const {
  Cube known = {-1, -1, -1};
  CubeCoefficients<double> a;  // of the known cube: points in a row are often near
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 x = frame_.to_lattice(points[i]);
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) inside &= x[k] >= 0 && x[k] <= 2 * cubes_[k];
    if (!inside) {
      values[i] = {NAN, {NAN, NAN, NAN}};
      continue;
    }
    const Cube cube = cube_at(x);
    if (cube != known) {
      known = cube;
      a = cube_coefficients(stencil<double>(cube));
    }
    Vec3 from_centre;
    for (std::size_t k = 0; k < 3; ++k) from_centre[k] = x[k] - (2 * cube[k] + 1);
    const std::size_t t = locate(from_centre[0], from_centre[1], from_centre[2]);
    const auto r =
        kernel::value_and_gradient_at(tetrahedron_net(a, t), barycentric(t, from_centre));
    values[i] = {r.value, frame_.gradient_to_world(gradient(t, r.gradient))};
  }
}

std::vector<ValueAndGradient> QuadraticSpline::evaluate(std::span<const Vec3> points) const {
  std::vector<ValueAndGradient> values(points.size());
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 1024),
                       [&](const auto& range) {
                         evaluate(points.subspan(range.begin(), range.size()),
                                  std::span(values).subspan(range.begin(), range.size()));
                       });
  return values;
}

namespace {

std::size_t slot_of(const Lattice& p) {
  return static_cast<std::size_t>(62 + p[0] + 5 * p[1] + 25 * p[2]);
}

/// The conditions inside a cube whose word is C, and what their failure makes the gradient jump by
/// at the centre.
struct Jumps {
  struct Condition {
    std::size_t u, v, p, q;
    double factor;
  };
  std::vector<Condition> intra, inter;

  explicit Jumps(const kernel::SampledGrid& grid) {
    // 2 |grad l|, but for a factor 2 between pyramids; by the axes of the triangle's plane.
    const auto plane = [&](std::size_t i, std::size_t k) {
      return 2 * std::sqrt(1 / (grid.spacing[i] * grid.spacing[i]) +
                           1 / (grid.spacing[k] * grid.spacing[k]));
    };
    for (const Crossing& x : kCrossing) {
      if (x.junction == Junction::inter_cube) continue;
      const auto& [u, v] = x.opposite;
      Condition c{slot_of(u), slot_of(v), slot_of(x.triangle[0]), slot_of(x.triangle[1]), 0};
      std::size_t first = 0;
      while (u[first] == v[first]) ++first;
      if (x.junction == Junction::inter_pyramid) {
        // Centres of two faces: they differ along both axes.
        const std::size_t second = u[2] != v[2] ? 2 : 1;
        c.factor = 2 * plane(first, second);
        inter.push_back(c);
      } else {
        // Corners: the triangle has a corner and the face's centre.
        c.p = c.q;
        std::size_t face = 0;
        while (x.triangle[1][face] == 0) ++face;
        c.factor = plane(first, 3 - first - face);
        intra.push_back(c);
      }
    }
  }

  double largest(const CubeCoefficients<double>& a) const {
    double largest = 0;
    for (const Condition& c : intra)
      largest = std::max(largest, c.factor * std::fabs(a[c.u] + a[c.v] - 2 * a[c.q]));
    for (const Condition& c : inter)
      largest = std::max(largest,
                         c.factor * std::fabs(a[c.u] + a[c.v] - a[62] - 0.5 * (a[c.p] + a[c.q])));
    return largest;
  }
};

/// Places whose hull holds all coefficients: a_m and a_d are means of a_e, a_g and the centre of
/// a_c.
constexpr auto kHull = [] {
  std::array<std::uint8_t, 28> places{};
  std::size_t count = 0;
  for (int i = 0; i < 125; ++i) {
    const int x = i % 5, y = i / 5 % 5, z = i / 25;
    const int ends = (x % 4 == 0) + (y % 4 == 0) + (z % 4 == 0), odd = x % 2 + y % 2 + z % 2;
    if (odd == 3 || (odd == 0 && ends >= 2)) places[count++] = static_cast<std::uint8_t>(i);
  }
  return places;
}();

}  // namespace

SplineSummary summarise(const QuadraticSpline& spline) {
  const Jumps jumps(spline.grid());
  const Cube n = spline.cubes();
  struct Part {
    double low = HUGE_VAL, high = -HUGE_VAL, jump = -1;
    Cube where{};
    void join(const Part& o) {
      low = std::min(low, o.low);
      high = std::max(high, o.high);
      if (o.jump > jump || (o.jump == jump && o.where < where)) {
        jump = o.jump;
        where = o.where;
      }
    }
  };
  const Part all = kernel::parallel_reduce(
      tbb::blocked_range<int>(0, n[2]), Part{},
      [&](const auto& range, Part part) {
        for (int z = range.begin(); z < range.end(); ++z)
          for (int y = 0; y < n[1]; ++y)
            for (int x = 0; x < n[0]; ++x) {
              const Cube cube = {x, y, z};
              const auto a = cube_coefficients(spline.stencil<double>(cube));
              Part one;
              for (const std::uint8_t s : kHull) {
                one.low = std::min(one.low, a[s]);
                one.high = std::max(one.high, a[s]);
              }
              one.jump = jumps.largest(a);
              one.where = cube;
              part.join(one);
            }
        return part;
      },
      [](Part a, const Part& b) {
        a.join(b);
        return a;
      });
  SplineSummary summary;
  summary.low = all.low;
  summary.high = all.high;
  // Covers the roundings of factors and products.
  summary.gradient_jump = all.jump * (1 + 0x1p-48);
  Vec3 centre;
  for (std::size_t k = 0; k < 3; ++k) centre[k] = 2 * all.where[k] + 1;
  summary.where = spline.frame().to_world(centre);
  return summary;
}

}  // namespace crest::splines
