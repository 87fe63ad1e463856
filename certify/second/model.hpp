// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Models on a piece": polynomials in two coordinates u, v of a triangle with one bound of
// what they leave out, all in integers: f = 2^exponent (sum c_ij u^i v^j + what is at most radius)
// at every point of the triangle. Integers are rounded to 57 bits together, so sums of products fit
// into 128; every rounding adds to the radius.
#include <array>
#include <cstdint>

#include "certify/second/interval.hpp"
#include "certify/second/series.hpp"

namespace crest::recheck {

/// u = l1 - (l0 + l2) / 2, v = l2 - (l0 + l1) / 2 in barycentric coordinates. Operations keep
/// degree context.order (at most 5).
class Model {
 public:
  Model() = default;
  Model(double x) : Model(Ball(x)) {}
  /// A constant, for each number of the ball.
  explicit Model(const Ball& constant);
  /// The affine function with this value at corner 0, and differences to it at the others.
  static Model linear(const Ball& value, const Ball& to1, const Ball& to2);

  int degree() const { return degree_; }
  bool is_zero() const {
    return radius_ == 0 && c_[0] == 0 &&
           std::all_of(c_.begin(), c_.end(), [](auto c) { return c == 0; });
  }
  /// An enclosure of the values on the triangle: the hull of the Bernstein coefficients.
  Interval range() const;
  int sign() const { return range().sign(); }
  /// The polynomial.
  Model middle() const;
  void add_product(const Model& a, const Model& b);

  Model& operator+=(const Model& b);
  friend Model operator+(Model a, const Model& b) { return a += b; }
  friend Model operator-(const Model& a, const Model& b) { return a + -b; }
  friend Model operator*(const Model& a, const Model& b) {
    Model m;
    m.add_product(a, b);
    return m;
  }
  Model operator-() const;
  friend Model scaled(const Model& x, slong n, slong d);

 private:
  static constexpr std::size_t kTerms = 21;
  struct Wide;
  friend Model applied(const Function& f, const Model& g);

  int degree_ = 0;
  slong exponent_ = 0;
  std::int64_t radius_ = 0;
  std::array<std::int64_t, kTerms> c_{};  ///< of u^i v^j, by degrees; zero beyond degree_
};

Model scaled(const Model& x, slong n, slong d = 1);
Model applied(const Function& f, const Model& g);
Model inverse(const Model& x);
/// Requires a range that is positive, or zero alone.
Model sqrt(const Model& x);
Model log(const Model& x);
Model exp(const Model& x);
Model sin(const Model& x);
Model cos(const Model& x);
Model power(const Model& x, unsigned n);

inline Interval range_of(const Ball& x) {
  return Interval(x);
}
inline Interval range_of(const Model& x) {
  return x.range();
}

}  // namespace crest::recheck
