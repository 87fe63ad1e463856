// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_cubic/errors.hpp"

#include <algorithm>
#include <cmath>

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"
#include "certify/spline_cubic/evaluate.hpp"
#include "kernel/arithmetic/interval.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::certify::spline_cubic {
namespace {

using kernel::Interval;
using kernel::Rational;
using Sample = std::array<double, 4>;

/// Cube coordinates of a point.
template <class Number>
std::array<Number, 3> cube_coordinates(const SplineCubicData& data, const Sample& sample) {
  std::array<Number, 3> x;
  for (std::size_t d = 0; d < 3; ++d) {
    const Number low(data.box[2 * d]);
    x[d] = (Number(sample[d]) - low) * Number(static_cast<double>(data.cubes[d])) /
           (Number(data.box[2 * d + 1]) - low);
  }
  return x;
}

/// Calls f(place) for the cubes from `first` to `last`, until one call is false.
template <class F>
bool all_cubes(const std::array<std::size_t, 3>& first, const std::array<std::size_t, 3>& last,
               const F& f) {
  CubePlace place{first};
  for (place.at[2] = first[2]; place.at[2] <= last[2]; ++place.at[2])
    for (place.at[1] = first[1]; place.at[1] <= last[1]; ++place.at[1])
      for (place.at[0] = first[0]; place.at[0] <= last[0]; ++place.at[0])
        if (!f(place)) return false;
  return true;
}

/// From a cube's centre, in halves of its sides.
template <class Number>
std::array<Number, 3> from_centre(const std::array<Number, 3>& x, const CubePlace& place) {
  std::array<Number, 3> y;
  for (std::size_t d = 0; d < 3; ++d)
    y[d] = twice(x[d]) - Number(static_cast<double>(2 * place.at[d] + 1));
  return y;
}

class Errors {
 public:
  Errors(const SplineCubicCertificate& c, const Domain& domain) : c_(c), domain_(domain) {}

  void check(std::size_t number) const {
    const Sample& sample = c_.data.samples[number];
    for (std::size_t d = 0; d < 3; ++d)
      require(sample[d] >= c_.data.box[2 * d] && sample[d] <= c_.data.box[2 * d + 1],
              "sample {} is not in the box", number);
    if (!surely_near(sample)) check_exactly(number, sample);
  }

 private:
  /// Whether intervals show it, for every cube and every tetrahedron in which the sample may be.
  bool surely_near(const Sample& sample) const {
    const kernel::RoundUpward guard;
    const auto x = cube_coordinates<Interval>(c_.data, sample);
    std::array<std::size_t, 3> first{}, last{};
    for (std::size_t d = 0; d < 3; ++d) {
      if (!is_defined(x[d])) return false;
      const double most = static_cast<double>(c_.data.cubes[d]) - 1;
      first[d] = static_cast<std::size_t>(std::clamp(x[d].inf(), 0.0, most));
      last[d] = static_cast<std::size_t>(std::clamp(x[d].sup(), 0.0, most));
      if (last[d] > first[d] + 1) return false;
    }
    return all_cubes(first, last,
                     [&](const CubePlace& place) { return near_in(sample, x, place); });
  }
  bool near_in(const Sample& sample, const std::array<Interval, 3>& x,
               const CubePlace& place) const {
    if (!domain_.holds(place.number(c_.data.cubes))) return false;
    const auto y = from_centre(x, place);
    const auto form = load<Interval>(c_.data, place, [](double v) { return Interval(v); });
    for (unsigned number = 0; number < kTetrahedra; ++number) {
      const Tetrahedron tet = tetrahedron(number);
      const auto l = barycentrics(tet, y);
      // Every point of the cube is in the cone of one of them.
      if (l[1].sup() < 0 || l[2].sup() < 0 || l[3].sup() < 0) continue;
      const Interval difference = value(form, tet, l) - Interval(sample[3]);
      if (!(is_defined(difference) && difference.sup() <= c_.error &&
            difference.inf() >= -c_.error))
        return false;
    }
    return true;
  }

  void check_exactly(std::size_t number, const Sample& sample) const {
    const auto x = cube_coordinates<Rational>(c_.data, sample);
    std::array<std::size_t, 3> first{}, last{};
    for (std::size_t d = 0; d < 3; ++d) {
      const auto floor = static_cast<std::size_t>(numerator(x[d]) / denominator(x[d]));
      const bool plane = denominator(x[d]) == 1;
      last[d] = std::min<std::size_t>(floor, c_.data.cubes[d] - 1);
      first[d] = plane && floor > 0 ? floor - 1 : last[d];
    }
    bool far = false;
    const bool nowhere = all_cubes(first, last, [&](const CubePlace& place) {
      if (!domain_.holds(place.number(c_.data.cubes))) return true;
      far = !is_near(sample, x, place);
      return false;
    });
    require(!nowhere, "sample {} is not in the domain", number);
    require(!far, "sample {} differs from the spline by more than stated", number);
  }
  bool is_near(const Sample& sample, const std::array<Rational, 3>& x,
               const CubePlace& place) const {
    const auto y = from_centre(x, place);
    const auto form = load<Rational>(c_.data, place, [](double v) { return Rational(v); });
    for (unsigned number = 0; number < kTetrahedra; ++number) {
      const auto l = barycentrics(tetrahedron(number), y);
      if (std::ranges::any_of(l, [](const Rational& b) { return b < 0; })) continue;
      const Rational difference = value(form, tetrahedron(number), l) - Rational(sample[3]);
      return abs(difference) <= Rational(c_.error);
    }
    return false;  // never: the tetrahedra fill the cube
  }

  const SplineCubicCertificate& c_;
  const Domain& domain_;
};

}  // namespace

void check_errors(const SplineCubicCertificate& c, const Domain& domain) {
  const Errors errors(c, domain);
  constexpr std::size_t kPiece = 256;
  const std::size_t count = c.data.samples.size();
  parallel_for((count + kPiece - 1) / kPiece, [] { return 0; },
               [&](int, std::size_t piece) {
                 for (std::size_t i = piece * kPiece; i < std::min(count, (piece + 1) * kPiece);
                      ++i)
                   errors.check(i);
               });
}

}  // namespace crest::certify::spline_cubic
