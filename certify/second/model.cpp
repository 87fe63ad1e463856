// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/model.hpp"

#include <algorithm>

namespace crest::recheck {
namespace {

constexpr int kDegree = 5;
constexpr std::size_t kTerms = 21;

/// Upper bounds that Arb's functions for magnitudes work on.
struct Magnitudes {
  explicit Magnitudes(std::size_t n) : size(n) {
    for (std::size_t i = 0; i < size; ++i) mag_init(&at[i]);
  }
  Magnitudes(const Magnitudes&) = delete;
  Magnitudes& operator=(const Magnitudes&) = delete;
  ~Magnitudes() {
    for (std::size_t i = 0; i < size; ++i) mag_clear(&at[i]);
  }
  std::size_t size;
  std::array<mag_struct, kTerms> at;
};

/// Of (l0 + l1 + l2)^n times a polynomial in barycentric coordinates, as integers.
using Homogeneous = std::vector<std::array<long, kDegree + 1>>;  // [power of l1][power of l2]

Homogeneous times(const Homogeneous& p, const std::array<long, 3>& linear) {
  Homogeneous r(p.size() + 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; i + j < p.size(); ++j) {
      r[i][j] += linear[0] * p[i][j];
      r[i + 1][j] += linear[1] * p[i][j];
      r[i][j + 1] += linear[2] * p[i][j];
    }
  return r;
}

/// Row by Bernstein coefficient, column by u^i v^j.
std::vector<std::vector<Ball>> bernstein(int degree) {
  const Scope scope;
  context.precision = 128;
  const auto terms = static_cast<std::size_t>((degree + 1) * (degree + 2) / 2);
  std::vector<std::vector<Ball>> rows(terms, std::vector<Ball>(terms));
  Homogeneous multinomial = {{1}};
  for (int k = 0; k < degree; ++k) multinomial = times(multinomial, {1, 1, 1});
  std::size_t column = 0;
  for (int d = 0; d <= degree; ++d)
    for (int j = 0; j <= d; ++j, ++column) {
      Homogeneous p = {{1}};
      for (int k = 0; k < d - j; ++k) p = times(p, {-1, 2, -1});  // 2 u
      for (int k = 0; k < j; ++k) p = times(p, {-1, -1, 2});      // 2 v
      for (int k = d; k < degree; ++k) p = times(p, {1, 1, 1});
      std::size_t row = 0;
      for (std::size_t a = 0; a < p.size(); ++a)
        for (std::size_t b = 0; a + b < p.size(); ++b)
          rows[row++][column] = Ball(Rational(p[a][b], static_cast<ulong>(multinomial[a][b]) << d));
    }
  return rows;
}

const std::vector<std::vector<Ball>>& bernstein_rows(int degree) {
  static const std::array<std::vector<std::vector<Ball>>, kDegree + 1> all = {
      bernstein(0), bernstein(1), bernstein(2), bernstein(3), bernstein(4), bernstein(5)};
  return all[static_cast<std::size_t>(degree)];
}

/// A bound of the terms of a * b beyond degree n, as |u^i v^j| <= 2^-min(i, j).
void bound_beyond(mag_t sum, const std::vector<Ball>& a, const std::vector<Ball>& b, int da, int db,
                  int n) {
  Magnitudes x(a.size()), y(b.size()), by_shift(kDegree + 1);
  for (std::size_t i = 0; i < a.size(); ++i) arb_get_mag(&x.at[i], a[i].get());
  for (std::size_t i = 0; i < b.size(); ++i) arb_get_mag(&y.at[i], b[i].get());
  std::size_t i = 0;
  for (int d = 0; d <= da; ++d)
    for (int j = 0; j <= d; ++j, ++i) {
      if (mag_is_zero(&x.at[i])) continue;
      const int first = std::max(n + 1 - d, 0);
      auto k = static_cast<std::size_t>(first * (first + 1) / 2);
      for (int e = first; e <= db; ++e)
        for (int l = 0; l <= e; ++l, ++k)
          mag_addmul(&by_shift.at[static_cast<std::size_t>(std::min(j + l, d + e - j - l))],
                     &x.at[i], &y.at[k]);
    }
  mag_zero(sum);
  for (std::size_t s = 0; s < by_shift.size; ++s) {
    mag_mul_2exp_si(&by_shift.at[s], &by_shift.at[s], -static_cast<slong>(s));
    mag_add(sum, sum, &by_shift.at[s]);
  }
}

}  // namespace

Model Model::linear(const Ball& value, const Ball& to1, const Ball& to2) {
  Model m;
  m.grow(1);
  m.c_[0] = value + scaled(to1 + to2, 1, 3);
  m.c_[1] = scaled(to1, 2, 3);
  m.c_[2] = scaled(to2, 2, 3);
  return m;
}

void Model::grow(int degree) {
  if (degree <= degree_) return;
  degree_ = degree;
  c_.resize(static_cast<std::size_t>((degree + 1) * (degree + 2) / 2));
}

Interval Model::range() const {
  if (degree_ == 0) return Interval(c_[0]);
  bool first = true;
  Float lower, upper;
  for (const std::vector<Ball>& row : bernstein_rows(degree_)) {
    Ball b;
    arb_dot(b.get(), nullptr, 0, row[0].get(), 1, c_[0].get(), 1, static_cast<slong>(row.size()),
            context.precision);
    const Interval i(b);
    if (first || i.lower() < lower) lower = i.lower();
    if (first || upper < i.upper()) upper = i.upper();
    first = false;
  }
  return {lower, upper};
}

Model Model::middle() const {
  Model m = *this;
  for (Ball& b : m.c_) b = b.middle();
  return m;
}

void Model::add_product(const Model& a, const Model& b) {
  const int n = context.order;
  grow(std::min(n, a.degree_ + b.degree_));
  for (int d = 0; d <= a.degree_; ++d)
    for (int j = 0; j <= d; ++j) {
      const Ball& x = a.c_[at(d - j, j)];
      if (x.is_zero()) continue;
      for (int e = 0; e <= b.degree_ && d + e <= n; ++e)
        for (int l = 0; l <= e; ++l)
          arb_addmul(c_[at(d - j + e - l, j + l)].get(), x.get(), b.c_[at(e - l, l)].get(),
                     context.precision);
    }
  if (a.degree_ + b.degree_ > n) {
    Magnitudes sum(1);
    bound_beyond(&sum.at[0], a.c_, b.c_, a.degree_, b.degree_, n);
    mag_add(arb_radref(c_[0].get()), arb_radref(c_[0].get()), &sum.at[0]);
  }
  for (const Ball& c : c_) c.finite();
}

Model& Model::operator+=(const Model& b) {
  grow(b.degree_);
  for (std::size_t i = 0; i < b.c_.size(); ++i) c_[i] = c_[i] + b.c_[i];
  return *this;
}
Model Model::operator-() const {
  Model m = *this;
  for (Ball& b : m.c_) b = -b;
  return m;
}
Model operator*(const Model& a, const Model& b) {
  Model m;
  m.add_product(a, b);
  return m;
}
Model scaled(const Model& x, slong n, slong d) {
  Model m = x;
  for (Ball& b : m.c_) b = scaled(b, n, d);
  return m;
}

/// f(g): the Taylor polynomial of f at the middle c of g's range, in g - c, with Lagrange's
/// remainder.
Model applied(const Function& f, const Model& g) {
  if (f.kind == Function::Kind::power) return power(g, f.exponent);
  if (g.degree_ == 0) return Model(value_of(f, g.c_[0]));
  const int n = context.order;
  const Interval range = g.range();
  const Ball c(range.middle());
  const Ball last = series(f, range.ball(), n + 1).back();
  const std::vector<Ball> t = series(f, c, n);
  const Model delta = g - Model(c);
  Model r(t.back());
  for (int k = n - 1; k >= 0; --k) r = r * delta + Model(t[static_cast<std::size_t>(k)]);
  const Ball error = last * power(range.ball() - c, static_cast<unsigned>(n + 1));
  Ball radius;
  arb_get_mag(arb_radref(radius.get()), error.get());
  r.c_[0] = r.c_[0] + radius;
  return r;
}

Model inverse(const Model& x) {
  return applied({Function::Kind::inverse}, x);
}
Model sqrt(const Model& x) {
  return applied({Function::Kind::sqrt}, x);
}
Model log(const Model& x) {
  return applied({Function::Kind::log}, x);
}
Model exp(const Model& x) {
  return applied({Function::Kind::exp}, x);
}
Model sin(const Model& x) {
  return applied({Function::Kind::sin}, x);
}
Model cos(const Model& x) {
  return applied({Function::Kind::cos}, x);
}
Model power(const Model& x, unsigned n) {
  if (n == 0) return Model(1.0);
  if (n == 1) return x;
  const Model half = power(x, n / 2);
  const Model square = half * half;
  return n % 2 == 0 ? square : square * x;
}

}  // namespace crest::recheck
