// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Models on a piece": polynomials in two coordinates u, v of a triangle, with balls as
// coefficients. A function is enclosed if at every point of the triangle it is the value of the
// polynomial for some numbers in the balls; so the remainder is the radius of the constant
// coefficient.
#include <array>
#include <vector>

#include "certify/second/interval.hpp"
#include "certify/second/series.hpp"

namespace crest::recheck {

/// u = l1 - (l0 + l2) / 2, v = l2 - (l0 + l1) / 2 in barycentric coordinates. Operations keep
/// degree context.order (at most 5).
class Model {
 public:
  Model() : c_(1) {}
  Model(double x) : c_{Ball(x)} {}
  explicit Model(Ball constant) : c_{std::move(constant)} {}
  /// The affine function with this value at corner 0, and differences to it at the others.
  static Model linear(const Ball& value, const Ball& to1, const Ball& to2);

  int degree() const { return degree_; }
  bool is_zero() const { return degree_ == 0 && c_[0].is_zero(); }
  /// An enclosure of the values on the triangle: the hull of the Bernstein coefficients.
  Interval range() const;
  int sign() const { return range().sign(); }
  /// The polynomial of the balls' middles.
  Model middle() const;
  void add_product(const Model& a, const Model& b);

  Model& operator+=(const Model& b);
  friend Model operator+(Model a, const Model& b) { return a += b; }
  friend Model operator-(const Model& a, const Model& b) { return a + -b; }
  friend Model operator*(const Model& a, const Model& b);
  Model operator-() const;
  friend Model scaled(const Model& x, slong n, slong d);

 private:
  static std::size_t at(int i, int j) {
    return static_cast<std::size_t>((i + j) * (i + j + 1) / 2 + j);
  }
  void grow(int degree);
  friend Model applied(const Function& f, const Model& g);

  int degree_ = 0;
  std::vector<Ball> c_;  ///< of u^i v^j at `at(i, j)`: by degrees
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

}  // namespace crest::recheck
