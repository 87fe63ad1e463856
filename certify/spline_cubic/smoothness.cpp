// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_cubic/smoothness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"
#include "certify/spline_cubic/cube_form.hpp"
#include "kernel/arithmetic/interval.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::certify::spline_cubic {
namespace {

using kernel::Interval;
using kernel::Rational;

/// 1 / h_b^2 + 1 / h_c^2 for the planes along each axis, h the cubes' sides.
template <class Number>
std::array<Number, 3> plane_slopes(const SplineCubicData& data) {
  std::array<Number, 3> squares;
  for (std::size_t d = 0; d < 3; ++d) {
    const Number inverse = Number(static_cast<double>(data.cubes[d])) /
                           (Number(data.box[2 * d + 1]) - Number(data.box[2 * d]));
    squares[d] = inverse * inverse;
  }
  return {squares[1] + squares[2], squares[0] + squares[2], squares[0] + squares[1]};
}
/// A bound for |8 r| that suffices: 8 J / (3 sqrt(1 / h_b^2 + 1 / h_c^2)), rounded down; below 0
/// where that is not known.
double sufficient(const SplineCubicCertificate& c) {
  const kernel::RoundUpward guard;
  double least = std::numeric_limits<double>::max();
  for (const Interval& square : plane_slopes<Interval>(c.data)) {
    const Interval bound = Interval(8) * Interval(c.jump) / (Interval(3) * sqrt(square));
    if (!is_defined(bound)) return -1;
    least = std::min(least, bound.inf());
  }
  return least;
}

class Residuals {
 public:
  explicit Residuals(const SplineCubicCertificate& c)
      : c_(c), enough_(sufficient(c)), slopes_(plane_slopes<Rational>(c.data)) {}

  /// The first corner of a cube where the bound does not hold.
  std::optional<unsigned> worse(const CubePlace& place) const {
    if (c_.data.integers && c_.jump == 0) return not_zero(place);
    const auto undecided = not_below(place);
    if (undecided == 0) return std::nullopt;
    const auto form = load<Rational>(c_.data, place, [](double x) { return Rational(x); });
    const Rational most = Rational(64) * Rational(c_.jump) * Rational(c_.jump);
    for (unsigned corner = 0; corner < 8; ++corner) {
      if ((undecided >> corner & 1U) == 0) continue;
      const Rational r = eight_residuals(form, corner);
      if (9 * r * r * *std::ranges::max_element(slopes_) > most) return corner;
    }
    return std::nullopt;
  }

 private:
  /// In units of u / 8 all is integers.
  std::optional<unsigned> not_zero(const CubePlace& place) const {
    const double scale = std::ldexp(1.0, -(c_.data.exponent - 3) / 2);
    const double rest = std::ldexp(1.0, -(c_.data.exponent - 3) + (c_.data.exponent - 3) / 2);
    const auto form = load<std::int64_t>(
        c_.data, place, [&](double x) { return static_cast<std::int64_t>(x * scale * rest); });
    for (unsigned corner = 0; corner < 8; ++corner)
      if (eight_residuals(form, corner) != 0) return corner;
    return std::nullopt;
  }
  /// The corners for which intervals do not show the bound.
  unsigned not_below(const CubePlace& place) const {
    const kernel::RoundUpward guard;
    const auto form = load<Interval>(c_.data, place, [](double x) { return Interval(x); });
    unsigned corners = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Interval r = eight_residuals(form, corner);
      if (!(is_defined(r) && r.inf() >= -enough_ && r.sup() <= enough_)) corners |= 1U << corner;
    }
    return corners;
  }

  const SplineCubicCertificate& c_;
  double enough_;
  std::array<Rational, 3> slopes_;
};

}  // namespace

void check_smoothness(const SplineCubicCertificate& c, const Domain& domain) {
  const Residuals residuals(c);
  const std::uint32_t nx = c.data.cubes[0], ny = c.data.cubes[1], nz = c.data.cubes[2];
  parallel_for(
      std::size_t{ny} * nz, [] { return 0; },
      [&](int, std::size_t row) {
        CubePlace place{{0, row % ny, row / ny}};
        for (std::size_t cube = row * nx; place.at[0] < nx; ++place.at[0], ++cube) {
          if (!domain.holds(cube)) continue;
          if (const auto corner = residuals.worse(place))
            throw Reject(
                c.jump == 0
                    ? fmt::format("not C1: r is not 0 at corner {} of cube {}", *corner, cube)
                    : fmt::format("the gradient jumps by more than stated at corner {} of cube {}",
                                  *corner, cube));
        }
      });
}

}  // namespace crest::certify::spline_cubic
