// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/surface.hpp"

#include <optional>

#include "certify/second/periods.hpp"

namespace crest::recheck {
namespace {

using Monomials2 = Monomials<2>;
using Monomials3 = Monomials<3>;

/// The series h(p, q), h(0, 0) = 0, with f(p, q, h) = f(0, 0, 0): degree by degree, as the part of
/// f of degree k is what lower parts of h give, and F_m times the one of degree k.
Jet2 height_of(const Jet3& f, int degree) {
  const Monomials2& two = Monomials2::get();
  const Monomials3& three = Monomials3::get();
  const Index m = Monomials3::unit(2);
  const Model step = -inverse(f[m]);
  std::vector<Jet2> powers(static_cast<Index>(degree) + 1);  // of h, those of index 0 unused
  for (int k = 1; k <= degree; ++k) {
    const auto begin = [&](int d) { return two.count[static_cast<Index>(d)]; };
    for (Index l = 2; l <= static_cast<Index>(k); ++l)
      for (Index a = begin(1); a < begin(k); ++a)
        for (Index b = begin(k - two.degree[a]); b < begin(k - two.degree[a] + 1); ++b)
          powers[l].at(two.product[a][b]).add_product(powers[1][a], powers[l - 1][b]);
    Jet2 rest;
    for (Index i = 1; i < f.size(); ++i) {
      if (i == m || three.degree[i] > k || f[i].is_zero()) continue;
      const auto& e = three.exponents[i];
      const Index pq = two.find({e[0], e[1]});
      if (e[2] == 0) {
        if (three.degree[i] == k) rest.at(pq) += f[i];
        continue;
      }
      const Jet2& power = powers[static_cast<Index>(e[2])];
      for (Index b = begin(k - e[0] - e[1]); b < begin(k - e[0] - e[1] + 1); ++b)
        rest.at(two.product[pq][b]).add_product(f[i], power[b]);
    }
    for (Index b = begin(k); b < begin(k + 1); ++b) powers[1].at(b) = step * rest[b];
  }
  return powers[1];
}

/// The derivatives of x of order 1, 2, 3 as forms, with jets of degree context.jet_order.
std::array<Form, 3> derivatives(const Jet2& x) {
  const int r = context.jet_order;
  const auto derived = [r](const Jet2& f, std::size_t i, int degree) {
    const Scope scope(r + degree);
    return f.derivative(i);
  };
  const Jet2 x1 = derived(x, 0, 2), x2 = derived(x, 1, 2);
  const Jet2 x11 = derived(x1, 0, 1), x12 = derived(x1, 1, 1), x22 = derived(x2, 1, 1);
  return {Form{x1.cut(), x2.cut()}, Form{x11.cut(), scaled(x12.cut(), 2, 1), x22.cut()},
          Form{derived(x11, 0, 0), scaled(derived(x11, 1, 0), 3, 1),
               scaled(derived(x22, 0, 0), 3, 1), derived(x22, 1, 0)}};
}

Form operator+(Form a, const Form& b) {
  for (Index k = 0; k < a.size(); ++k) a[k] += b[k];
  return a;
}
Form multiple(const Jet2& factor, const Form& f) {
  Form r;
  for (const Jet2& x : f) r.push_back(factor * x);
  return r;
}
Form multiple(int factor, const Form& f) {
  Form r;
  for (const Jet2& x : f) r.push_back(scaled(x, factor, 1));
  return r;
}

/// Of a height over coordinates in which I is `flat` + h_i h_j.
Forms of_height(const Jet2& h, const Form& flat, int sign) {
  const auto d = derivatives(h);
  return {flat + product(d[0], d[0]), multiple(sign, d[1]), multiple(sign, d[2]),
          product(d[0], d[1])};
}

Forms of_immersion(const std::array<Jet2, 3>& x) {
  std::array<std::array<Form, 3>, 3> d;
  for (Index k = 0; k < 3; ++k) d[k] = derivatives(x[k]);
  Forms f;
  for (Index k = 0; k < 3; ++k) {
    const Form &a = d[(k + 1) % 3][0], &b = d[(k + 2) % 3][0];
    const Jet2 normal = a[0] * b[1] - b[0] * a[1];
    const Forms part = {product(d[k][0], d[k][0]), multiple(normal, d[k][1]),
                        multiple(normal, d[k][2]), product(d[k][0], d[k][1])};
    if (k == 0)
      f = part;
    else
      f = {f.i + part.i, f.l + part.l, f.t + part.t, f.c + part.c};
  }
  return f;
}

bool is_affine(const Jet2& x) {
  return x.degree() <= 1 && x[1].degree() == 0 && x[2].degree() == 0;
}

/// The height field that x is if two coordinates are affine and independent.
std::optional<Forms> of_height_field(const std::array<Jet2, 3>& x) {
  for (Index k = 0; k < 3; ++k) {
    const Jet2 &a = x[(k + 1) % 3], &b = x[(k + 2) % 3];
    if (!is_affine(a) || !is_affine(b)) continue;
    const int sign = (a[1] * b[2] - a[2] * b[1]).sign();
    if (sign == 0) continue;
    const Form flat = {Jet2(a[1] * a[1] + b[1] * b[1]), Jet2(scaled(a[1] * a[2] + b[1] * b[2], 2)),
                       Jet2(a[2] * a[2] + b[2] * b[2])};
    return of_height(x[k], flat, sign);
  }
  return std::nullopt;
}

}  // namespace

Model dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator*(const Model& s, const Vector& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
Model determinant(const Vector& a, const Vector& b, const Vector& c) {
  Model d;
  for (Index k = 0; k < 3; ++k)
    d += (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]) * c[k];
  return d;
}

Jet2 evaluate(const Form& f, const Direction& v) {
  Jet2 r = f[0], power = v[1];
  for (Index k = 1; k < f.size(); ++k) {
    r = r * v[0] + f[k] * power;
    if (k + 1 < f.size()) power = power * v[1];
  }
  return r;
}
Form product(const Form& a, const Form& b) {
  Form r(a.size() + b.size() - 1);
  for (Index i = 0; i < a.size(); ++i)
    for (Index j = 0; j < b.size(); ++j) r[i + j] += a[i] * b[j];
  return r;
}
Form quintic(const Forms& f) {
  return product(f.i, f.t) + multiple(-3, product(f.l, f.c));
}
Jet2 extremality(const Forms& f, const Direction& v) {
  return evaluate(f.i, v) * evaluate(f.t, v) - scaled(evaluate(f.l, v) * evaluate(f.c, v), 3, 1);
}

Operator operator_of(const Forms& f) {
  const Jet2 &i11 = f.i[0], &i22 = f.i[2], &l11 = f.l[0], &l22 = f.l[2];
  const Jet2 i12 = scaled(f.i[1], 1, 2), l12 = scaled(f.l[1], 1, 2);
  return {scaled(i22 * l11 - i11 * l22, 1, 2), i22 * l12 - i12 * l22, i11 * l12 - i12 * l11};
}
Model definite(const Forms& f, const Operator& a, const std::array<int, 2>& w) {
  const Model &i11 = f.i[0][0], &i22 = f.i[2][0], &a11 = a.a11[0];
  const Model i12 = scaled(f.i[1][0], 1, 2);
  return (scaled(i11, w[0]) + scaled(i12, w[1])) * (scaled(a11, w[0]) + scaled(a.a12[0], w[1])) +
         (scaled(i12, w[0]) + scaled(i22, w[1])) * (scaled(a.a21[0], w[0]) - scaled(a11, w[1]));
}
Jet2 root(const Operator& a) {
  return sqrt(a.a11 * a.a11 + a.a12 * a.a21);
}

std::array<Direction, 2> directions(const Form& i, const Operator& a, const std::array<int, 2>& w) {
  const Jet2 q = inverse(root(a)), i12 = scaled(i[1], 1, 2);
  const Direction v = {Jet2(w[0]) + (scaled(a.a11, w[0], 1) + scaled(a.a12, w[1], 1)) * q,
                       Jet2(w[1]) + (scaled(a.a21, w[0], 1) - scaled(a.a11, w[1], 1)) * q};
  return {v, Direction{-(i12 * v[0] + i[2] * v[1]), i[0] * v[0] + i12 * v[1]}};
}
std::array<int, 2> direction(int number) {
  return number < 64 ? std::array<int, 2>{32, number - 32} : std::array<int, 2>{96 - number, 32};
}

Surface::Surface(const Certificate& c) : implicit_(c.implicit) {
  const Scope scope;
  context.precision = 128;
  const std::vector<std::string> xyz = {"x", "y", "z"}, uv = {"u", "v"};
  for (Index k = 0; k < c.texts.size(); ++k)
    parts_.push_back(Expression::parse(c.texts[k], implicit_ ? xyz
                                                   : k < 3   ? uv
                                                             : std::vector<std::string>()));
  if (implicit_) return;
  for (std::size_t d = 0; d < 2; ++d) {
    const Ball length = parts_[4 + 2 * d].evaluate<Ball>({}) - parts_[3 + 2 * d].evaluate<Ball>({});
    if (!length.is_positive()) throw Rejected("the domain's bounds are not certainly in order");
    if (c.periodic[d]) prove_period(d);
  }
}

void Surface::prove_period(std::size_t direction) const {
  const auto from = linear_in_pi(parts_[3 + 2 * direction]),
             to = linear_in_pi(parts_[4 + 2 * direction]);
  const std::string name = direction == 0 ? "u" : "v";
  if (!from || !to || !(to->a - from->a).is_zero())
    throw Rejected("the domain's length in " + name + " is not shown to be a multiple of 2 pi");
  const Rational q = (to->b - from->b) / Rational(2);
  for (Index k = 0; k < 3; ++k)
    if (!is_invariant(parts_[k], static_cast<int>(direction), q))
      throw Rejected("the period in " + name + " is not shown for coordinate " + "xyz"[k]);
}

Foot Surface::foot(const Fibre& fibre, int steps) const {
  const auto slope = [&](const Model& s) {
    const Scope scope(1);
    std::vector<Jet<Model, 1>> x;
    for (Index k = 0; k < 3; ++k)
      x.emplace_back(fibre.base[k] + s * fibre.along[k], std::array<Model, 1>{fibre.along[k]});
    const Interval d = f().evaluate(x)[1].range();
    require(d.lower().sign() > 0, "(F): grad F . m > 0");
    return inverse(d).ball();
  };
  const auto step = [&](const Model& t, const Ball& q) {
    const Vector x = fibre.base + t * fibre.along;
    return t - f().evaluate<Model>({x[0], x[1], x[2]}) * Model(q);
  };
  const Float h = Interval(fibre.h).lower();
  const auto within = [&](const Model& s) {
    require(s.range().inside(Interval(-fibre.h).upper(), h), "(F): F has a zero in |s| <= h");
  };
  const Ball q = slope(Model(Ball::radius(fibre.h)));
  const Model t = step(Model(), q.middle()).middle();
  within(t);
  Model s = step(t, q);
  within(s);
  for (int k = 0; k < steps; ++k) s = step(s.middle(), slope(s));
  return {s, fibre.base + s * fibre.along};
}

Jet3 Surface::expand(const Vector& x, const Frame& frame, int degree) const {
  const Scope scope(degree);
  std::vector<Jet3> at;
  for (Index k = 0; k < 3; ++k)
    at.emplace_back(x[k], Vector{frame.axis[0][k], frame.axis[1][k], frame.axis[2][k]});
  return f().evaluate(at);
}

Forms Surface::forms(const Jet3& f, int sign) const {
  require(f[Monomials3::unit(2)].sign() == sign, "F_m has no zero");
  const Form flat = {Jet2(1.0), Jet2(), Jet2(1.0)};
  return of_height(height_of(f, jet_degree()), flat, sign);
}

Forms Surface::forms(const Model& u, const Model& v) const {
  std::array<Jet2, 3> x;
  {
    const Scope scope(jet_degree());
    std::vector<Jet2> at;
    for (std::size_t d = 0; d < 2; ++d) {
      const Ball from = parts_[3 + 2 * d].evaluate<Ball>({}),
                 length = parts_[4 + 2 * d].evaluate<Ball>({}) - from;
      std::array<Model, 2> slopes;
      slopes[d] = Model(length);
      at.emplace_back(Model(from) + Model(length) * (d == 0 ? u : v), slopes);
    }
    for (Index k = 0; k < 3; ++k) x[k] = parts_[k].evaluate(at);
  }
  if (const auto height = of_height_field(x)) return *height;
  return of_immersion(x);
}

}  // namespace crest::recheck
