// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Data section" (periods) and "Foot"; the surface at all points of a piece (T = Model),
// or at one point (T = Ball).
#include "certify/second/certificate.hpp"
#include "certify/second/expression.hpp"
#include "certify/second/forms.hpp"

namespace crest::recheck {

/// Fibres: base + s along, |s| <= h.
template <class T>
struct Fibre {
  Vector<T> base, along;
  Ball h;
};
template <class T>
struct Foot {
  T s;
  Vector<T> x;
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
  template <class T>
  Foot<T> foot(const Fibre<T>& fibre, int steps) const;
  /// Kind 0: F as jet in frame coordinates.
  template <class T>
  Jet3<T> expand(const Vector<T>& x, const Frame& frame, int degree) const;
  /// The forms with jets of degree context.jet_order (T of 2 at most); kind 0: of the graph of F's
  /// jet, which has jet_degree().
  template <class T>
  Forms<T> forms(const Jet3<T>& f, int sign) const;
  /// Kind 1: at these unit coordinates.
  template <class T>
  Forms<T> forms(const T& u, const T& v) const;

 private:
  void prove_period(std::size_t direction) const;

  bool implicit_;
  std::vector<Expression> parts_;
};

template <class T>
Foot<T> Surface::foot(const Fibre<T>& fibre, int steps) const {
  const auto slope = [&](const T& s) {
    const Scope scope(1);
    std::vector<Jet<T, 1>> x;
    for (Index k = 0; k < 3; ++k)
      x.emplace_back(fibre.base[k] + s * fibre.along[k], std::array<T, 1>{fibre.along[k]});
    const Interval d = range_of(f().evaluate(x)[1]);
    require(d.lower() > 0, "(F): grad F . m > 0");
    return inverse(d).ball();
  };
  const auto step = [&](const T& t, const Ball& q) {
    const Vector<T> x = moved(fibre.base, t, fibre.along);
    return t - f().evaluate<T>({x[0], x[1], x[2]}) * T(q);
  };
  const Interval h(fibre.h);
  const auto within = [&](const T& s) {
    require(range_of(s).inside(-h.lower(), h.lower()), "(F): F has a zero in |s| <= h");
  };
  const Ball q = slope(T(Ball::radius(fibre.h)));
  const T t = step(T(), q.middle()).middle();
  within(t);
  T s = step(t, q);
  within(s);
  for (int k = 0; k < steps; ++k) s = step(s.middle(), slope(s));
  return {s, moved(fibre.base, s, fibre.along)};
}

template <class T>
Jet3<T> Surface::expand(const Vector<T>& x, const Frame& frame, int degree) const {
  const Scope scope(degree);
  std::vector<Jet3<T>> at;
  for (Index k = 0; k < 3; ++k)
    at.emplace_back(x[k], Vector<T>{frame.axis[0][k], frame.axis[1][k], frame.axis[2][k]});
  return f().evaluate(at);
}

template <class T>
Forms<T> Surface::forms(const Jet3<T>& f, int sign) const {
  require(f[Monomials<3>::unit(2)].sign() == sign, "F_m has no zero");
  const Form<T> flat = {Jet2<T>(1.0), Jet2<T>(), Jet2<T>(1.0)};
  return forms_of_height(height_of(f, jet_degree()), flat, sign);
}

template <class T>
Forms<T> Surface::forms(const T& u, const T& v) const {
  std::array<Jet2<T>, 3> x;
  {
    const Scope scope(jet_degree());
    std::vector<Jet2<T>> at;
    for (std::size_t d = 0; d < 2; ++d) {
      const Ball from = parts_[3 + 2 * d].evaluate<Ball>({}),
                 length = parts_[4 + 2 * d].evaluate<Ball>({}) - from;
      std::array<T, 2> slopes;
      slopes[d] = T(length);
      at.emplace_back(T(from) + T(length) * (d == 0 ? u : v), slopes);
    }
    for (Index k = 0; k < 3; ++k) x[k] = parts_[k].evaluate(at);
  }
  if (const auto height = forms_of_height_field(x)) return *height;
  return forms_of_immersion(x);
}

}  // namespace crest::recheck
