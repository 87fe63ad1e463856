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

// The normal equations, row by row: 15 columns of the Gram matrix and the right-hand side. After
// elimination row j holds the factor's row and y_j: G = U^T U, U^T y = right-hand side.
constexpr int kWidth = kMonomials + 1;  // four groups of lanes
struct System {
  Lanes row[kMonomials][kWidth / 4];
  double at(int i, int j) const { return row[i][j / 4][j % 4]; }
};

struct GramTable {
  std::array<std::array<std::uint8_t, kMonomials>, kMonomials> moment{};
  constexpr GramTable() {
    for (std::size_t i = 0; i < kMonomials; ++i)
      for (std::size_t j = 0; j < kMonomials; ++j)
        moment[i][j] = static_cast<std::uint8_t>(
            index_of(kExponents.a[i] + kExponents.a[j], kExponents.b[i] + kExponents.b[j]));
  }
};
constexpr GramTable kGram;

// Eliminates up to `wanted` columns; returns how many were independent. `inverse[j]` is 1 / u_jj.
CREST_CLONES int eliminate(System& s, int wanted, double* inverse) {
  constexpr double kLoss = 1e-8;  // square of the sine below which a column is called dependent
  double diagonal[kMonomials];
  for (int j = 0; j < kMonomials; ++j) diagonal[j] = s.row[j][j / 4][j % 4];
  for (int j = 0; j < wanted; ++j) {
    const double pivot = s.row[j][j / 4][j % 4];
    if (!(pivot > kLoss * diagonal[j])) return j;
    inverse[j] = 1 / std::sqrt(pivot);
    for (int g = j / 4; g < kWidth / 4; ++g) s.row[j][g] *= inverse[j];
    for (int i = j + 1; i < wanted; ++i) {
      const double factor = s.row[j][i / 4][i % 4];
      for (int g = i / 4; g < kWidth / 4; ++g) s.row[i][g] -= factor * s.row[j][g];
    }
  }
  return wanted;
}

int degree_of(int columns) {
  return columns >= 15 ? 4 : columns >= 10 ? 3 : columns >= 6 ? 2 : columns >= 3 ? 1 : 0;
}

// (G^-1)_ii is the squared length of U^-T e_i; the four cubic columns are solved together.
double largest_cubic_variance(const System& s, const double* inverse, int n) {
  constexpr int kFirst = 6;
  Lanes y[kMonomials] = {}, square = {};
  for (int r = kFirst; r < n; ++r) {
    Lanes rest = {};
    if (r < kFirst + 4) rest[r - kFirst] = 1;
    for (int k = kFirst; k < r; ++k) rest -= s.at(k, r) * y[k];
    y[r] = rest * inverse[r];
    square += y[r] * y[r];
  }
  return std::max(std::max(square[0], square[1]), std::max(square[2], square[3]));
}

}  // namespace

Jet fit_jet(std::span<const kernel::Vec3> local, int max_degree) {
  const Sums sums = sum_moments(local);
  double moment[kMoments];
  for (int i = 0; i < kMoments; ++i) moment[i] = total(sums.moment[i]);
  System system;
  for (std::size_t i = 0; i < kMonomials; ++i) {
    for (std::size_t j = 0; j < kMonomials; ++j)
      system.row[i][j / 4][j % 4] = moment[kGram.moment[i][j]];
    system.row[i][kMonomials / 4][kMonomials % 4] = total(sums.value[i]);
  }
  const int points = static_cast<int>(std::min<std::size_t>(local.size(), 1000));
  const int wanted = std::min(offset(max_degree + 1), offset(degree_of(points) + 1));
  double inverse[kMonomials];
  Jet jet;
  jet.degree = degree_of(eliminate(system, wanted, inverse));
  const int n = jet.degree > 0 ? offset(jet.degree + 1) : 0;
  if (n == 0) return jet;

  double explained = 0;
  for (int i = 0; i < n; ++i) explained += system.at(i, kMonomials) * system.at(i, kMonomials);
  for (int i = n - 1; i >= 0; --i) {
    double s = system.at(i, kMonomials);
    for (int k = i + 1; k < n; ++k) s -= system.at(i, k) * jet.c[static_cast<std::size_t>(k)];
    jet.c[static_cast<std::size_t>(i)] = s * inverse[i];
  }
  const auto [smallest, largest] = std::minmax_element(inverse, inverse + n);
  jet.condition = *largest / *smallest;
  if (n >= 10) {
    const double freedom = std::max(1.0, static_cast<double>(local.size()) - n);
    const double variance = std::max(0.0, total(sums.square) - explained) / freedom;
    jet.cubic_error = std::sqrt(variance * largest_cubic_variance(system, inverse, n));
  }
  return jet;
}

}  // namespace crest::ridges
