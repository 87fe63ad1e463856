// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Signs of all Bernstein coefficients of a form along a Bezier curve in a triangle.
#include <vector>

#include "certify/skeleton/frame.hpp"

namespace crest::certify::skeleton {

/// Binomials of one degree n: exact (n <= 50 in doubles, <= 128 in more than 128 bits).
template <class Number>
struct Binomials {
  std::vector<Number> degree, derivative;  ///< C(n, j), C(n - 1, k)
  std::vector<double> product;             ///< C(2n - 1, m), rounded

  explicit Binomials(std::size_t n = 0) {
    const auto row = [](auto& list, std::size_t k) {
      using Entry = typename std::decay_t<decltype(list)>::value_type;
      list = {Entry(1.0)};
      for (std::size_t j = 0; j < k; ++j)
        list.push_back(list.back() * Entry(static_cast<double>(k - j)) /
                       Entry(static_cast<double>(j + 1)));
    };
    if (n == 0) return;
    row(degree, n);
    row(derivative, n - 1);
    row(product, 2 * n - 1);
  }
};

/// sum_k C(n-1, k) (first_j da_k + second_j db_k) C(n, j) for k + j = m, m < 2n: the Bernstein
/// coefficients of a form along the curve with these control points, times C(2n-1, m).
template <class Number>
class Products {
 public:
  void compute(const std::vector<Point<Number>>& control, const LinearForms<Number>& forms,
               const Binomials<Number>& binomials) {
    const std::size_t n = control.size() - 1;
    sums_.assign(2 * n, Number(0.0));
    first_.resize(n + 1);
    second_.resize(n + 1);
    for (std::size_t j = 0; j <= n; ++j) {
      const auto& [a, b] = control[j];
      first_[j] = binomials.degree[j] * along(forms.first, a, b);
      second_[j] = binomials.degree[j] * along(forms.second, a, b);
    }
    for (std::size_t k = 0; k < n; ++k) {
      const Number da = binomials.derivative[k] * (control[k + 1].a - control[k].a),
                   db = binomials.derivative[k] * (control[k + 1].b - control[k].b);
      for (std::size_t j = 0; j <= n; ++j)
        if constexpr (std::is_same_v<Number, Big>)
          sums_[k + j].add_products(da, first_[j], db, second_[j], room_);
        else
          sums_[k + j] += da * first_[j] + db * second_[j];
    }
  }
  const std::vector<Number>& sums() const { return sums_; }

 private:
  static Number along(const std::array<Number, 3>& f, const Number& a, const Number& b) {
    return f[0] + (a * (f[1] - f[0]) + b * (f[2] - f[0]));
  }
  std::vector<Number> sums_, first_, second_;
  std::array<Number, 2> room_;
};

/// Whether all Bernstein coefficients of a form have the wanted sign; a point's a, b >= 0,
/// a + b <= 1. In numbers with this bound, where S bounds max |da| |first| + max |db| |second| and
/// u is half a unit: e1, e2 round once, a form's value at a corner is within 4 u M, M its
/// magnitude; at a control point all terms are below 5 M and the value within 40 u M; da within u
/// |da|; n <= 128 products a sum, each rounded thrice with its binomials: below (128 + 16 n) u S
/// C(2n-1, m). The last term covers underflow (below 2^-1074 an operation); da and db, which may
/// be lost as doubles, have one of their own. Where something overflows nothing is certain: no sum
/// or product makes a finite number of an infinite one.
enum class Answer { no, open, yes };
template <class Number>
Answer have_sign(const std::vector<Point<Number>>& control, const LinearForms<Number>& forms,
                 const Binomials<Number>& binomials, Products<Number>& products, int wanted) {
  products.compute(control, forms, binomials);
  const std::size_t n = control.size() - 1;
  double da = 0, db = 0;
  for (std::size_t k = 0; k < n; ++k) {
    da = std::max(da, std::fabs(to_double(control[k + 1].a - control[k].a)) + 0x1p-1074);
    db = std::max(db, std::fabs(to_double(control[k + 1].b - control[k].b)) + 0x1p-1074);
  }
  const double unit = static_cast<double>(128 + 16 * n) * unit_roundoff<Number>() *
                          (da * forms.magnitude_first + db * forms.magnitude_second) +
                      0x1p-1030;
  bool certain = true;
  const auto& sums = products.sums();
  for (std::size_t m = 0; m < sums.size(); ++m) {
    const double bound = unit * binomials.product[m], value = wanted * to_double(sums[m]);
    const bool finite = std::isfinite(value) && std::isfinite(bound);
    if (finite && value < -bound) return Answer::no;
    certain = certain && finite && value > bound;
  }
  return certain ? Answer::yes : Answer::open;
}

/// The same in rationals.
class ExactSigns {
 public:
  template <class Number>
  bool have(const std::vector<Point<Number>>& control, const LinearForms<Rational>& forms,
            int wanted) {
    control_.clear();
    for (const auto& [a, b] : control) control_.push_back({to_rational(a), to_rational(b)});
    products_.compute(control_, forms, Binomials<Rational>(control.size() - 1));
    return std::all_of(products_.sums().begin(), products_.sums().end(),
                       [&](const Rational& x) { return wanted * x > 0; });
  }

 private:
  std::vector<Point<Rational>> control_;
  Products<Rational> products_;
};

}  // namespace crest::certify::skeleton
