// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/exact_rays.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/predicates/segment_zero.hpp"

namespace crest::splines {

using kernel::operator*;
using kernel::operator+;

namespace {

/// The largest integer not above x.
int floor_of(const Rational& x) {
  using boost::multiprecision::denominator;
  using boost::multiprecision::numerator;
  auto q = numerator(x) / denominator(x);
  if (q * denominator(x) > numerator(x)) --q;
  return static_cast<int>(q);
}

/// The coordinates whose even integers are the partition's planes.
std::array<Rational, 9> plane_coordinates(const ExactPoint& x) {
  return {x[0],        x[1],        x[2],        x[0] + x[1], x[0] - x[1],
          x[0] + x[2], x[0] - x[2], x[1] + x[2], x[1] - x[2]};
}

/// A quadratic on [from, to].
struct Segment {
  Rational from, to, b0, b1, b2;
  /// Whether it has a zero in [from, x].
  bool zero_until(const Rational& x) const {
    if (x < from) return false;
    const auto [c1, c2] = until(x < to ? x : to);
    return kernel::exact_segment_zero(b0, c1, c2);
  }
  /// Whether x is its first zero.
  bool first_zero_at(const Rational& x) const {
    if (x < from || x > to) return false;
    if (x == from) return b0 == 0;
    const auto [c1, c2] = until(x);
    // On [from, x] it is (1 - s) (b0 (1 - s) + 2 c1 s).
    return c2 == 0 && b0 != 0 && (c1 == 0 || (c1 < 0) == (b0 < 0));
  }

 private:
  /// b1 and b2 of the part [from, x].
  std::array<Rational, 2> until(const Rational& x) const {
    if (from == to) return {b1, b2};
    const Rational s = (x - from) / (to - from), r = 1 - s;
    const Rational c1 = r * b0 + s * b1;
    return {c1, r * c1 + s * (r * b1 + s * b2)};
  }
};

/// The least double with a zero until there. Requires: there is one on the segment.
double least_double_with_zero(const Segment& segment) {
  // Bisection over doubles around the root that doubles compute.
  const double b0 = static_cast<double>(segment.b0), b1 = static_cast<double>(segment.b1),
               b2 = static_cast<double>(segment.b2);
  const double from = static_cast<double>(segment.from), to = static_cast<double>(segment.to);
  const double h = b0 - b1, a = b0 - 2 * b1 + b2, d = std::sqrt(std::fmax(0, h * h - a * b0));
  const double side = b0 < 0 ? -1 : 1;
  const double s = b0 == 0 ? 0 : side * h > 0 ? b0 / (h + side * d) : (h - side * d) / a;
  double guess = from + (to - from) * std::clamp(std::isfinite(s) ? s : 0.5, 0.0, 1.0);
  double low = guess, high = guess;
  double step = std::fmax(std::fabs(guess), 1e-300) * 0x1p-52;
  while (segment.zero_until(Rational(low))) {
    high = low;
    low = next_down(low - step);
    step *= 4;
  }
  step = std::fmax(std::fabs(guess), 1e-300) * 0x1p-52;
  while (!segment.zero_until(Rational(high))) {
    low = high;
    high = next_up(high + step);
    step *= 4;
  }
  while (next_up(low) < high) {
    const double middle = low + 0.5 * (high - low);
    const double m = middle <= low ? next_up(low) : middle;
    (segment.zero_until(Rational(m)) ? high : low) = m;
  }
  return high;
}

}  // namespace

ExactPoint ExactRay::at(const Rational& t) const {
  return origin + t * direction;
}

struct ExactRays::Piece {
  Cube cube;
  std::size_t tetrahedron;
  QuadraticNet<Rational> net;
  /// Barycentric coordinates.
  std::array<Rational, 4> place(const ExactPoint& x) const {
    ExactPoint from_centre;
    for (std::size_t k = 0; k < 3; ++k) from_centre[k] = x[k] - (2 * cube[k] + 1);
    return barycentric(tetrahedron, from_centre);
  }
};

ExactRays::ExactRays(const QuadraticSpline& spline, double level)
    : spline_(spline), frame_(spline.grid(), spline.frame().first()), level_(level) {}

ExactRay ExactRays::lift(const Ray& ray) const {
  return {frame_.to_lattice(ray.origin), frame_.direction_to_lattice(ray.direction)};
}

std::optional<std::array<Rational, 2>> ExactRays::clip(const ExactRay& ray) const {
  Rational from = 0, to = 0;
  bool bounded = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational side(2 * spline_.cubes()[k]);
    const Rational &o = ray.origin[k], &d = ray.direction[k];
    if (d == 0) {
      if (o < 0 || o > side) return std::nullopt;
      continue;
    }
    Rational enter = -o / d, leave = (side - o) / d;
    if (leave < enter) std::swap(enter, leave);
    if (enter > from) from = enter;
    if (!bounded || leave < to) to = leave;
    bounded = true;
  }
  if (!bounded || to < from) return std::nullopt;
  return std::array<Rational, 2>{from, to};
}

ExactRays::Piece ExactRays::piece_at(const ExactPoint& x) const {
  Piece piece;
  ExactPoint from_centre;
  for (std::size_t k = 0; k < 3; ++k) {
    piece.cube[k] = std::clamp(floor_of(Rational(x[k] / 2)), 0, spline_.cubes()[k] - 1);
    from_centre[k] = x[k] - (2 * piece.cube[k] + 1);
  }
  piece.tetrahedron = locate(from_centre[0], from_centre[1], from_centre[2]);
  if (spline_.exact()) {
    const auto net =
        tetrahedron_net(cube_coefficients(spline_.stencil<double>(piece.cube)), piece.tetrahedron);
    std::copy(net.c.begin(), net.c.end(), piece.net.c.begin());
  } else {
    piece.net = tetrahedron_net(cube_coefficients(spline_.stencil<Rational>(piece.cube)),
                                piece.tetrahedron);
  }
  for (Rational& c : piece.net.c) c -= level_;
  return piece;
}

std::optional<Hit> ExactRays::first_zero(const ExactRay& ray, const Rational& from,
                                         const Rational& to, RayCounts& counts) const {
  std::vector<Rational> cuts = {from, to};
  const auto at_origin = plane_coordinates(ray.origin), slopes = plane_coordinates(ray.direction);
  for (std::size_t k = 0; k < 9; ++k) {
    if (slopes[k] == 0) continue;
    Rational low = at_origin[k] + from * slopes[k], high = at_origin[k] + to * slopes[k];
    if (high < low) std::swap(low, high);
    for (int plane = 2 * floor_of(Rational(low / 2)); plane <= high; plane += 2)
      if (plane > low && plane < high) cuts.push_back(Rational((plane - at_origin[k]) / slopes[k]));
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  if (cuts.size() == 1) cuts.push_back(cuts.front());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Rational &a = cuts[i], &b = cuts[i + 1];
    const Piece piece = piece_at(ray.at(Rational((a + b) / 2)));
    ++counts.tetrahedra;
    const auto start = piece.place(ray.at(a)), end = piece.place(ray.at(b));
    const auto from_start = kernel::blossom_step(piece.net, start);
    const Segment segment{a, b, kernel::value_at(from_start, start),
                          kernel::value_at(from_start, end), kernel::value_at(piece.net, end)};
    if (!kernel::exact_segment_zero(segment.b0, segment.b1, segment.b2)) continue;
    Hit hit;
    hit.hit = hit.climbed = true;
    hit.cube = piece.cube;
    hit.tetrahedron = static_cast<std::uint8_t>(piece.tetrahedron);
    hit.t = hit.t_hi = least_double_with_zero(segment);
    // A zero that is a double is its own bracket.
    hit.t_lo =
        segment.first_zero_at(Rational(hit.t_hi)) ? hit.t_hi : std::fmax(0, next_down(hit.t_hi));
    hit.tangent = segment.b1 * segment.b1 == segment.b0 * segment.b2;
    return hit;
  }
  return std::nullopt;
}

}  // namespace crest::splines
