// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/jet_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace crest::ridges {
namespace {

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

inline __attribute__((always_inline)) void monomials(const PointLanes& p, Lanes* m) {
  m[0] = p.live;
#pragma GCC unroll 8
  for (int d = 1; d <= 8; ++d) {
#pragma GCC unroll 9
    for (int j = 0; j < d; ++j) m[offset(d) + j] = m[offset(d - 1) + j] * p.x;
    m[offset(d) + d] = m[offset(d - 1) + d - 1] * p.y;
  }
}

// Two points a step: the sums live in memory, and a step is bound by storing them.
CREST_CLONES void accumulate(std::span<const PointLanes> rows, MomentSums& s) {
  for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
    const PointLanes &p = rows[i], &q = rows[i + 1];
    Lanes m[kMoments], n[kMoments];
    monomials(p, m);
    monomials(q, n);
#pragma GCC unroll 45
    for (int k = 0; k < kMoments; ++k) s.moment[k] += m[k] + n[k];
#pragma GCC unroll 15
    for (int k = 0; k < kMonomials; ++k) s.value[k] += m[k] * p.z + n[k] * q.z;
    s.square += p.z * p.z + q.z * q.z;
  }
}

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

void set_up(const MomentSums& sums, NormalEquations& s) {
  for (std::size_t i = 0; i < kMonomials; ++i) {
    for (std::size_t j = i; j < kMonomials; ++j) s.row[i][j] = sums.moment[kGram.moment[i][j]];
    s.row[i][kMonomials] = sums.value[i];
  }
}

// Eliminates up to wanted[lane] columns; columns[lane] says how many were independent.
CREST_CLONES void eliminate(NormalEquations& s, const int* wanted, int* columns) {
  constexpr double kLoss = 1e-8;  // square of the sine below which a column is called dependent
  Lanes diagonal[kMonomials];
  for (int j = 0; j < kMonomials; ++j) diagonal[j] = s.row[j][j];
  bool alive[kLanes];
  for (std::size_t l = 0; l < kLanes; ++l) {
    alive[l] = true;
    columns[l] = 0;
  }
  for (int j = 0; j < kMonomials; ++j) {
    for (std::size_t l = 0; l < kLanes; ++l) {
      const double pivot = s.row[j][j][l];
      alive[l] = alive[l] && j < wanted[l] && pivot > kLoss * diagonal[j][l];
      s.inverse[j][l] = alive[l] ? 1 / std::sqrt(pivot) : 0.0;
      columns[l] += alive[l];
    }
    for (int k = j; k <= kMonomials; ++k) s.row[j][k] *= s.inverse[j];
    for (int i = j + 1; i < kMonomials; ++i) {
      const Lanes factor = s.row[j][i];
      for (int k = i; k <= kMonomials; ++k) s.row[i][k] -= factor * s.row[j][k];
    }
  }
}

int degree_of(int columns) {
  return columns >= 15 ? 4 : columns >= 10 ? 3 : columns >= 6 ? 2 : columns >= 3 ? 1 : 0;
}

// Unused columns have inverse 0 and so coefficient 0.
CREST_CLONES void solve(const NormalEquations& s, Lanes* c) {
  for (int i = kMonomials - 1; i >= 0; --i) {
    Lanes rest = s.row[i][kMonomials];
    for (int k = i + 1; k < kMonomials; ++k) rest -= s.row[i][k] * c[k];
    c[i] = rest * s.inverse[i];
  }
}

// The squared length of U^-T g.
CREST_CLONES void propagated_square(const NormalEquations& s, const JetFit::Gradient& g,
                                    Lanes& square) {
  Lanes y[kMonomials];
  square = Lanes{};
  for (int r = 1; r < kMonomials; ++r) {
    Lanes rest = {};
    if (r < 6) rest = g.by[r];
    for (int k = 1; k < r; ++k) rest -= s.row[k][r] * y[k];
    y[r] = rest * s.inverse[r];
    square += y[r] * y[r];
  }
}

// Columns that make no full degree are not used; those before them stay as they are.
int trim(NormalEquations& s, std::size_t lane, int columns) {
  const int degree = degree_of(columns);
  for (int j = degree > 0 ? offset(degree + 1) : 0; j < kMonomials; ++j) s.inverse[j][lane] = 0;
  return degree;
}

}  // namespace

JetFit::JetFit(int max_degree) : max_degree_(max_degree) {}

std::array<Jet, kLanes> JetFit::fit(std::span<const PointLanes> rows,
                                    const std::array<std::size_t, kLanes>& count) {
  accumulate(rows, sums_);
  set_up(sums_, equations_);
  int wanted[kLanes], columns[kLanes];
  for (std::size_t l = 0; l < kLanes; ++l) {
    const int points = static_cast<int>(std::min<std::size_t>(count[l], 1000));
    wanted[l] = std::min(offset(max_degree_ + 1), offset(degree_of(points) + 1));
  }
  eliminate(equations_, wanted, columns);
  int degree[kLanes];
  for (std::size_t l = 0; l < kLanes; ++l) degree[l] = trim(equations_, l, columns[l]);
  solve(equations_, solution_);
  std::array<Jet, kLanes> jets;
  for (std::size_t l = 0; l < kLanes; ++l) jets[l] = jet_of(l, count[l], degree[l]);
  return jets;
}

Jet JetFit::jet_of(std::size_t lane, std::size_t count, int degree) const {
  Jet jet;
  jet.degree = degree;
  if (degree == 0) return jet;
  const int n = offset(degree + 1);
  double smallest = equations_.inverse[0][lane], largest = smallest, explained = 0;
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    jet.c[k] = solution_[i][lane];
    smallest = std::min(smallest, equations_.inverse[i][lane]);
    largest = std::max(largest, equations_.inverse[i][lane]);
    const double y = equations_.row[i][kMonomials][lane];
    explained += y * y;
  }
  jet.condition = largest / smallest;
  constexpr double kRounding = 0x1p-52;  // of the sum of squares: less is not seen
  const double square = sums_.square[lane];
  const double freedom = std::max(1.0, static_cast<double>(count) - n);
  jet.residual = std::sqrt(std::max(square - explained, kRounding * square) / freedom);
  return jet;
}

std::array<double, kLanes> JetFit::propagate(const Gradient& gradient) const {
  Lanes square;
  propagated_square(equations_, gradient, square);
  std::array<double, kLanes> root;
  for (std::size_t l = 0; l < kLanes; ++l) root[l] = std::sqrt(square[l]);
  return root;
}

}  // namespace crest::ridges
