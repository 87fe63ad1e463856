// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The deviators of a simplex as functions of the eigenvector, in doubles with errors (SPEC.md,
// lemma 8): m(v) = (v.M_k v)_k, M = diag(1, 0, -1), diag(0, 1, -1), xy, yz, xz, are coordinates of
// v v^T - I / 3; the same of the corners' tensors are the rows of a matrix L. m(v) s = b L.
#include <array>
#include <cmath>

#include "certify/modes_curves/wide_ball.hpp"

namespace crest::certify::curves {

/// xx yy zz xy yz xz.
template <class Number>
using Symmetric = std::array<Number, 6>;
template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class Number>
Vector<Number> times(const Symmetric<Number>& m, const Vector<Number>& v) {
  return {m[0] * v[0] + m[3] * v[1] + m[5] * v[2], m[3] * v[0] + m[1] * v[1] + m[4] * v[2],
          m[5] * v[0] + m[4] * v[1] + m[2] * v[2]};
}
template <class Number>
Number determinant(const Symmetric<Number>& m) {
  return m[0] * (m[1] * m[2] - m[4] * m[4]) - m[3] * (m[3] * m[2] - m[4] * m[5]) +
         m[5] * (m[3] * m[4] - m[1] * m[5]);
}
inline int sign_of(const Ball& x) {
  return x.mid > x.rad ? 1 : x.mid < -x.rad ? -1 : 0;
}
inline double near(const Ball& x) {
  return x.mid;
}
inline double near(const WideBall& x) {
  return x.hi;
}

/// n tensors, reduced: L in the basis of n pivot columns is the unit matrix and a rest.
template <class Number, std::size_t n>
class Span {
 public:
  /// Scaled by a power of two, so that the largest number is near 1.
  explicit Span(const std::array<const std::array<double, 6>*, n>& tensors) {
    double most = 0;
    for (const auto* t : tensors)
      for (const double x : *t) most = std::max(most, std::fabs(x));
    int exponent = 0;
    std::frexp(most, &exponent);
    // Halves, as 2^1024 is no double; what underflows is in the radius.
    const double half = std::ldexp(1.0, -(exponent / 2)),
                 rest = std::ldexp(1.0, exponent / 2 - exponent);
    for (std::size_t i = 0; i < n; ++i) {
      std::array<Number, 6> t;
      for (std::size_t k = 0; k < 6; ++k) t[k] = scaled((*tensors[i])[k], half, rest);
      rows_[i] = {t[0] - t[2], t[1] - t[2], t[3] + t[3], t[4] + t[4], t[5] + t[5]};
      for (std::size_t j = 0; j < n; ++j) inverse_[i][j] = Number(i == j ? 1 : 0);
    }
    reduce();
  }

  /// False: dependent tensors, or errors too large to tell.
  bool independent() const { return independent_; }

  /// v.B_i v = b_i / s.
  Symmetric<Number> dual(std::size_t i) const {
    Symmetric<Number> b{};
    for (std::size_t r = 0; r < n; ++r) add(inverse_[r][i], pivots_[r], b);
    return b;
  }
  /// v.C v = 0 iff v v^T - I / 3 is in the span: for each k < 5 - n.
  Symmetric<Number> conic(std::size_t k) const {
    Symmetric<Number> c{};
    add(Number(1), free_[k], c);
    for (std::size_t r = 0; r < n; ++r) add(-rows_[r][free_[k]], pivots_[r], c);
    return c;
  }

 private:
  static Number scaled(double x, double a, double b) {
    const double y = x * a * b;
    return Number(Ball(y, std::fabs(y) < 0x1p-960 ? 0x1p-1020 : 0));
  }

  /// Adds factor M_k.
  static void add(const Number& factor, std::size_t k, Symmetric<Number>& m) {
    if (k < 2) {
      m[k] = m[k] + factor;
      m[2] = m[2] - factor;
    } else {
      m[k + 1] = m[k + 1] + factor;
    }
  }

  /// Gauss and Jordan's, the largest number first.
  void reduce() {
    std::array<bool, 5> used{};
    for (std::size_t step = 0; step < n; ++step) {
      std::size_t row = step, column = 0;
      double best = -1;
      for (std::size_t i = step; i < n; ++i)
        for (std::size_t k = 0; k < 5; ++k)
          if (!used[k] && std::fabs(near(rows_[i][k])) > best)
            best = std::fabs(near(rows_[i][k])), row = i, column = k;
      if (sign_of(rows_[row][column]) == 0) return;
      std::swap(rows_[row], rows_[step]);
      std::swap(inverse_[row], inverse_[step]);
      used[column] = true;
      pivots_[step] = column;
      const Number factor = Number(1) / rows_[step][column];
      rows_[step][column] = Number(1);
      for (std::size_t k = 0; k < 5; ++k)
        if (!used[k]) rows_[step][k] = rows_[step][k] * factor;
      for (Number& x : inverse_[step]) x = x * factor;
      for (std::size_t i = 0; i < n; ++i)
        if (i != step) subtract(i, step, column, used);
    }
    for (std::size_t k = 0, at = 0; k < 5; ++k)
      if (!used[k]) free_[at++] = k;
    independent_ = true;
  }
  void subtract(std::size_t i, std::size_t step, std::size_t column,
                const std::array<bool, 5>& used) {
    const Number factor = rows_[i][column];
    rows_[i][column] = Number(0);
    for (std::size_t k = 0; k < 5; ++k)
      if (!used[k]) rows_[i][k] = rows_[i][k] - factor * rows_[step][k];
    for (std::size_t j = 0; j < n; ++j)
      inverse_[i][j] = inverse_[i][j] - factor * inverse_[step][j];
  }

  std::array<std::array<Number, 5>, n> rows_;
  std::array<std::array<Number, n>, n> inverse_;
  std::array<std::size_t, n> pivots_{};
  std::array<std::size_t, 5 - n> free_{};
  bool independent_ = false;
};

}  // namespace crest::certify::curves
