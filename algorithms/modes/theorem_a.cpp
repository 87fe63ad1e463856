// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/theorem_a.hpp"

#include "algorithms/modes/degenerate_exact.hpp"

namespace crest::modes {

namespace {

using kernel::Rational;
using Matrix = Conic<Rational>;

Matrix rational(const Conic<Integer>& a) {
  Matrix b;
  for (std::size_t k = 0; k < 6; ++k) b.c[k] = a.c[k];
  return b;
}

Rational inner(const Matrix& a, const Matrix& b) {
  return a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2] +
         2 * (a.c[3] * b.c[3] + a.c[4] * b.c[4] + a.c[5] * b.c[5]);
}

Matrix square(const Matrix& a) {
  const auto& [xx, yy, zz, xy, yz, xz] = a.c;
  return {{xx * xx + xy * xy + xz * xz, xy * xy + yy * yy + yz * yz, xz * xz + yz * yz + zz * zz,
           xx * xy + xy * yy + xz * yz, xy * xz + yy * yz + yz * zz, xx * xz + xy * yz + xz * zz}};
}

/// mode^2 of a traceless matrix that is not zero.
Rational squared_mode(const Matrix& a) {
  const Rational d = a.det(), s = inner(a, a);
  return 54 * d * d / (s * s * s);
}

}  // namespace

std::optional<CriticalTensor> critical_tensor(const std::array<const Tensor*, 4>& corners) {
  const auto forms = exact_forms<4>(corners);
  if (!forms) return std::nullopt;
  const Matrix bar = rational(forms->vanishing[0]);
  const Rational s = inner(bar, bar);
  CriticalTensor result;
  result.squared_mode = 1 - squared_mode(bar);
  if (result.squared_mode.is_zero()) return result;
  // The unit Tbar's formula times s: Tbar^2 - (tr Tbar^3 / s) Tbar - (s / 3) I.
  Matrix star = square(bar);
  const Rational third = inner(star, bar) / s;
  for (std::size_t k = 0; k < 6; ++k) star.c[k] -= third * bar.c[k] + (k < 3 ? Rational(s / 3) : 0);
  std::array<Rational, 4> b;
  Rational sum = 0;
  int up = 0, down = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    sum += b[k] = inner(rational(forms->coordinates[k]), star);
    up += b[k] > 0;
    down += b[k] < 0;
  }
  if (up < 4 && down < 4) return result;
  for (Rational& x : b) x /= sum;
  result.weights = b;
  result.mode_sign = star.det().sign() * (up ? 1 : -1);
  return result;
}

}  // namespace crest::modes
