// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Data section" (periods), "Foot", "Graph", "Forms", "Height fields": the surface and
// what is derived from it at all points of a piece.
#include "certify/second/certificate.hpp"
#include "certify/second/expression.hpp"
#include "certify/second/jet.hpp"
#include "certify/second/model.hpp"

namespace crest::recheck {

using Jet2 = Jet<Model, 2>;
using Jet3 = Jet<Model, 3>;
using Vector = std::array<Model, 3>;
using Form = std::vector<Jet2>;  ///< f_k of v1^(n-k) v2^k
using Direction = std::array<Jet2, 2>;

/// The surface near the points of a piece, as jets in its two coordinates: I, L, T and
/// C(v, v, v) = X_v . X_vv, which give E(v) = I(v, v) T(v, v, v) - 3 L(v, v) C(v, v, v).
struct Forms {
  Form i, l, t, c;
};

/// A at the points of a piece: its entries A_11, A_12, A_21.
struct Operator {
  Jet2 a11, a12, a21;
};

Model dot(const Vector& a, const Vector& b);
Vector operator+(const Vector& a, const Vector& b);
Vector operator*(const Model& s, const Vector& a);
Model determinant(const Vector& a, const Vector& b, const Vector& c);
Jet2 evaluate(const Form& f, const Direction& v);
Form product(const Form& a, const Form& b);

/// The coefficients of E as a form of degree 5.
Form quintic(const Forms& f);
Jet2 extremality(const Forms& f, const Direction& v);
Operator operator_of(const Forms& f);
/// S(w), and sigma^2.
Model definite(const Forms& f, const Operator& a, const std::array<int, 2>& w);
/// v1 and v2 for w, of I and A, as jets.
/// Throws: Undefined if sigma^2 > 0 is left open.
std::array<Direction, 2> directions(const Form& i, const Operator& a, const std::array<int, 2>& w);
Jet2 root(const Operator& a);
/// w or c by its number.
std::array<int, 2> direction(int number);

/// Of the surface's own jet, for forms of degree context.jet_order.
inline int jet_degree() {
  return std::min(3 + context.jet_order, 5);
}

/// Fibres: base + s along, |s| <= h.
struct Fibre {
  Vector base, along;
  Ball h;
};
struct Foot {
  Model s;
  Vector x;
};

/// Kind 0: three vectors of one length, right-handed; and the sign of F_m along the last.
struct Frame {
  std::array<std::array<double, 3>, 3> axis;
  int sign = 1;
};

class Surface {
 public:
  /// Parses; proves the bounds of the domain and the periods (condition A for them).
  explicit Surface(const Certificate& c);

  bool implicit() const { return implicit_; }
  const Expression& f() const { return parts_[0]; }

  /// (F): the zero of F on each fibre, a second step with a better derivative for each of `steps`.
  /// Throws: Open, Undefined.
  Foot foot(const Fibre& fibre, int steps) const;
  /// Kind 0: F as jet in frame coordinates.
  Jet3 expand(const Vector& x, const Frame& frame, int degree) const;
  /// The forms with jets of degree context.jet_order (T of 2 at most); kind 0: of the graph of F's
  /// jet, which has jet_degree().
  Forms forms(const Jet3& f, int sign) const;
  /// Kind 1: at these unit coordinates.
  Forms forms(const Model& u, const Model& v) const;

 private:
  void prove_period(std::size_t direction) const;

  bool implicit_;
  std::vector<Expression> parts_;
};

}  // namespace crest::recheck
