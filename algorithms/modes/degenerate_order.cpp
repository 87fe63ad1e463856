// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/degenerate_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algorithms/modes/small_matrix.hpp"

namespace crest::modes {

namespace {

using kernel::IntegerPolynomial;
using kernel::Rational;
using kernel::Vec3;
using kernel::operator*;

/// A number between two rationals.
struct Between {
  Rational low, high;

  Between() = default;
  Between(Rational a, Rational b) : low(std::move(a)), high(std::move(b)) {}
  Between(const Integer& x) : low(x), high(x) {}  // NOLINT: numbers convert

  int sign() const { return low > 0 ? 1 : high < 0 ? -1 : 0; }

  friend Between operator+(const Between& a, const Between& b) {
    return {a.low + b.low, a.high + b.high};
  }
  friend Between operator-(const Between& a, const Between& b) {
    return {a.low - b.high, a.high - b.low};
  }
  friend Between operator*(const Between& a, const Between& b) {
    const std::array<Rational, 4> ends{a.low * b.low, a.low * b.high, a.high * b.low,
                                       a.high * b.high};
    const auto [least, most] = std::minmax_element(ends.begin(), ends.end());
    return {*least, *most};
  }
};

Between value_at(const IntegerPolynomial& p, const Between& t) {
  Between sum = Integer(0);
  for (std::size_t k = p.coefficients().size(); k-- > 0;) sum = sum * t + p[k];
  return sum;
}

Conic<Between> enclosed(const Conic<Integer>& a) {
  Conic<Between> p;
  for (std::size_t k = 0; k < 6; ++k) p.c[k] = a.c[k];
  return p;
}

/// Near the eigenvector whose eigenvalue alone has its sign, that of det: it is the sum of the
/// others, so that all within 45 degrees are inside.
Vector3<Integer> inside(const Conic<Integer>& conic, int det_sign) {
  const auto c = ball(conic, largest({&conic, 1})).c;
  const Eigensystem axes =
      eigensystem({Vec3{c[0].mid, c[3].mid, c[5].mid}, Vec3{c[3].mid, c[1].mid, c[4].mid},
                   Vec3{c[5].mid, c[4].mid, c[2].mid}});
  const Vec3& e = axes.vectors[det_sign > 0 ? 0 : 2];
  Vector3<Integer> v;
  for (std::size_t k = 0; k < 3; ++k) v[k] = std::llround(0x1p+20 * e[k]);
  return v;
}

class ConicOrder {
 public:
  ConicOrder(const SimplexForms<Integer, 4>& forms, std::vector<ConicPoint> points)
      : forms_(forms),
        conic_(enclosed(forms.vanishing[0])),
        det_sign_(forms.vanishing[0].det().sign()),
        points_(std::move(points)) {
    const Vector3<Integer> polar = forms.vanishing[0].times(inside(forms.vanishing[0], det_sign_));
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const int side = sign([&] {
        const auto v = exact_direction(i);
        return polar[0] * v[0] + polar[1] * v[1] + polar[2] * v[2];
      });
      turned_.push_back(side != det_sign_);
    }
  }

  std::vector<Join> joins() {
    std::vector<std::size_t> order(points_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin() + 1, order.end(),
              [&](std::size_t a, std::size_t b) { return a != b && is_counterclockwise(a, b); });
    std::vector<Join> list;
    const std::size_t n = order.size(), first = is_curve_ahead() ? 0 : 1;
    for (std::size_t i = first; i < n + first; i += 2)
      list.push_back({order[i], order[(i + 1) % n]});
    return list;
  }

 private:
  Vector3<Between> exact_direction(std::size_t i) const {
    const ExactPoint& p = points_[i].point;
    const auto& r = p.root.rational();
    const Between t = r ? Between(*r, *r) : Between(p.root.low().value(), p.root.high().value());
    return {value_at(p.v[0], t), value_at(p.v[1], t), value_at(p.v[2], t)};
  }
  /// On e's half of the cone.
  Vector3<Between> direction(std::size_t i) const {
    const auto v = exact_direction(i);
    return turned_[i] ? Between(Integer(-1)) * v : v;
  }

  /// Of a value that is not 0, of the points' directions.
  template <class Value>
  int sign(const Value& value) {
    for (;; bits_ *= 2) {
      for (ConicPoint& p : points_)
        if (!p.point.root.rational()) p.point.root.refine(bits_);
      if (const int s = value().sign(); s != 0) return s;
    }
  }
  /// Points 0, a and b.
  bool is_counterclockwise(std::size_t a, std::size_t b) {
    return sign([&] {
             return kernel::dot(direction(0), kernel::cross(direction(a), direction(b)));
           }) > 0;
  }
  /// Whether the arc that goes on counterclockwise from point 0 is inside the tet.
  bool is_curve_ahead() {
    const Conic<Between> coordinate = enclosed(forms_.coordinates[points_[0].opposite]);
    const int slope = sign([&] {
      const auto v = direction(0);
      return kernel::dot(coordinate.times(v), kernel::cross(conic_.times(v), v));
    });
    return slope * det_sign_ == (points_[0].type == DegenerateType::linear ? 1 : -1);
  }

  const SimplexForms<Integer, 4>& forms_;
  Conic<Between> conic_;
  int det_sign_;
  std::vector<ConicPoint> points_;
  std::vector<bool> turned_;
  long bits_ = 64;
};

}  // namespace

std::vector<Join> joins_round_conic(const SimplexForms<Integer, 4>& forms,
                                    std::vector<ConicPoint> points) {
  return ConicOrder(forms, std::move(points)).joins();
}

}  // namespace crest::modes
