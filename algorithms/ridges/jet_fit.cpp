// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/jet_fit.hpp"

#include <algorithm>
#include <cmath>

namespace crest::ridges {
namespace {

constexpr int kMonomials = 15;
constexpr int kMoments = 45;  // x^a y^b, a + b <= 8

// Four points at once. The order of the sums is fixed by the four lanes, not by the instruction
// set, so that every machine gets the same bits.
using Lanes = double __attribute__((vector_size(32)));

constexpr int offset(int degree) {
  return degree * (degree + 1) / 2;
}
// Monomials of one degree are ordered by descending power of x.
constexpr int index_of(int a, int b) {
  return offset(a + b) + b;
}

struct Exponents {
  std::array<int, kMonomials> a{}, b{};
  constexpr Exponents() {
    for (int d = 0, m = 0; d <= 4; ++d)
      for (int j = 0; j <= d; ++j, ++m) {
        a[static_cast<std::size_t>(m)] = d - j;
        b[static_cast<std::size_t>(m)] = j;
      }
  }
};
constexpr Exponents kExponents;

struct Sums {
  Lanes moment[kMoments];
  Lanes value[kMonomials];  // sum of z x^a y^b
  Lanes square;             // sum of z^2
};

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__)
#define CREST_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CREST_CLONES
#endif

CREST_CLONES void accumulate(const Lanes* x, const Lanes* y, const Lanes* z, const Lanes* live,
                             int groups, Sums& s) {
  s = Sums{};
  for (int g = 0; g < groups; ++g) {
    Lanes m[kMoments];
    m[0] = live[g];
#pragma GCC unroll 8
    for (int d = 1; d <= 8; ++d) {
#pragma GCC unroll 9
      for (int j = 0; j < d; ++j) m[offset(d) + j] = m[offset(d - 1) + j] * x[g];
      m[offset(d) + d] = m[offset(d - 1) + d - 1] * y[g];
    }
#pragma GCC unroll 45
    for (int i = 0; i < kMoments; ++i) s.moment[i] += m[i];
#pragma GCC unroll 15
    for (int i = 0; i < kMonomials; ++i) s.value[i] += m[i] * z[g];
    s.square += z[g] * z[g];
  }
}

double total(const Lanes& v) {
  return (v[0] + v[2]) + (v[1] + v[3]);
}

Sums sum_moments(std::span<const kernel::Vec3> local) {
  constexpr std::size_t kBlock = 64;  // groups of four points held at a time
  Lanes x[kBlock], y[kBlock], z[kBlock], live[kBlock];
  Sums sums{}, part;
  for (std::size_t begin = 0; begin < local.size(); begin += 4 * kBlock) {
    const std::size_t n = std::min(local.size() - begin, 4 * kBlock);
    const std::size_t groups = (n + 3) / 4;
    for (std::size_t i = 0; i < 4 * groups; ++i) {
      const bool used = i < n;
      const kernel::Vec3 p = used ? local[begin + i] : kernel::Vec3{};
      x[i / 4][i % 4] = p[0];
      y[i / 4][i % 4] = p[1];
      z[i / 4][i % 4] = p[2];
      live[i / 4][i % 4] = used ? 1.0 : 0.0;
    }
    accumulate(x, y, z, live, static_cast<int>(groups), part);
    if (begin == 0) {
      sums = part;
      continue;
    }
    for (int i = 0; i < kMoments; ++i) sums.moment[i] += part.moment[i];
    for (int i = 0; i < kMonomials; ++i) sums.value[i] += part.value[i];
    sums.square += part.square;
  }
  return sums;
}

// Lower triangular factor, rows stored contiguously: G = L L^T.
struct Factor {
  double l[kMonomials][kMonomials];
  int columns;  // complete degrees that could be factorised
};

Factor factorise(const double (&moment)[kMoments], int wanted) {
  constexpr double kLoss = 1e-8;  // square of the sine below which a column is called dependent
  Factor f;
  int i = 0;
  for (; i < wanted; ++i) {
    const auto ai = kExponents.a[static_cast<std::size_t>(i)];
    const auto bi = kExponents.b[static_cast<std::size_t>(i)];
    double pivot = 0;
    for (int j = 0; j <= i; ++j) {
      double s = moment[index_of(ai + kExponents.a[static_cast<std::size_t>(j)],
                                 bi + kExponents.b[static_cast<std::size_t>(j)])];
      if (j == i) pivot = s;
      for (int k = 0; k < j; ++k) s -= f.l[i][k] * f.l[j][k];
      f.l[i][j] = j < i ? s * f.l[j][j] : s;  // the diagonal holds 1 / l_jj
    }
    if (!(f.l[i][i] > kLoss * pivot)) break;
    f.l[i][i] = 1 / std::sqrt(f.l[i][i]);
  }
  f.columns = i;
  return f;
}

int degree_of(int columns) {
  return columns >= 15 ? 4 : columns >= 10 ? 3 : columns >= 6 ? 2 : columns >= 3 ? 1 : 0;
}

double largest_cubic_variance(const Factor& f, int n) {
  // (G^-1)_ii is the squared length of L^-1 e_i.
  double worst = 0;
  for (int i = 6; i < 10; ++i) {
    double y[kMonomials] = {}, square = 0;
    for (int r = i; r < n; ++r) {
      double s = r == i ? 1.0 : 0.0;
      for (int k = i; k < r; ++k) s -= f.l[r][k] * y[k];
      y[r] = s * f.l[r][r];
      square += y[r] * y[r];
    }
    worst = std::max(worst, square);
  }
  return worst;
}

}  // namespace

Jet fit_jet(std::span<const kernel::Vec3> local, int max_degree) {
  const Sums sums = sum_moments(local);
  double moment[kMoments], value[kMonomials];
  for (int i = 0; i < kMoments; ++i) moment[i] = total(sums.moment[i]);
  for (int i = 0; i < kMonomials; ++i) value[i] = total(sums.value[i]);

  const int points = static_cast<int>(std::min<std::size_t>(local.size(), 1000));
  const int wanted = std::min(offset(max_degree + 1), offset(degree_of(points) + 1));
  const Factor f = factorise(moment, wanted);
  Jet jet;
  jet.degree = degree_of(f.columns);
  const int n = jet.degree > 0 ? offset(jet.degree + 1) : 0;
  if (n == 0) return jet;

  double y[kMonomials], explained = 0, smallest = f.l[0][0], largest = f.l[0][0];
  for (int i = 0; i < n; ++i) {
    double s = value[i];
    for (int k = 0; k < i; ++k) s -= f.l[i][k] * y[k];
    y[i] = s * f.l[i][i];
    explained += y[i] * y[i];
    smallest = std::min(smallest, f.l[i][i]);
    largest = std::max(largest, f.l[i][i]);
  }
  for (int i = n - 1; i >= 0; --i) {
    double s = y[i];
    for (int k = i + 1; k < n; ++k) s -= f.l[k][i] * jet.c[static_cast<std::size_t>(k)];
    jet.c[static_cast<std::size_t>(i)] = s * f.l[i][i];
  }
  jet.condition = largest / smallest;
  if (n >= 10) {
    const double freedom = std::max(1.0, static_cast<double>(local.size()) - n);
    const double variance = std::max(0.0, total(sums.square) - explained) / freedom;
    jet.cubic_error = std::sqrt(variance * largest_cubic_variance(f, n));
  }
  return jet;
}

}  // namespace crest::ridges
