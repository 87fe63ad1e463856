// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/jet_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace crest::ridges {
namespace {

constexpr int kMonomials = 15;
constexpr int kMoments = 45;  // x^a y^b, a + b <= 8
constexpr int kCubic = 6;     // the first of the four cubic monomials

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
CREST_CLONES void accumulate(const std::vector<PointLanes>& rows, Sums& s) {
  s = Sums{};
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

// The normal equations of the four vertices: 15 columns of the Gram matrix (upper triangle) and
// the right-hand side. After elimination row j holds the factor's row and y_j: G = U^T U,
// U^T y = right-hand side.
struct Systems {
  Lanes row[kMonomials][kMonomials + 1];
  Lanes inverse[kMonomials];  // 1 / u_jj, or 0 for a column that is not used
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

void set_up(const Sums& sums, Systems& s) {
  for (std::size_t i = 0; i < kMonomials; ++i) {
    for (std::size_t j = i; j < kMonomials; ++j) s.row[i][j] = sums.moment[kGram.moment[i][j]];
    s.row[i][kMonomials] = sums.value[i];
  }
}

// Eliminates up to wanted[lane] columns; columns[lane] says how many were independent.
CREST_CLONES void eliminate(Systems& s, const int* wanted, int* columns) {
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

struct Solution {
  Lanes c[kMonomials];
  Lanes cubic_variance;  // largest (G^-1)_ii of the cubic columns
};

// Unused columns have inverse 0 and so coefficient 0.
CREST_CLONES void solve(const Systems& s, Solution& solution) {
  solution = Solution{};
  for (int i = kMonomials - 1; i >= 0; --i) {
    Lanes rest = s.row[i][kMonomials];
    for (int k = i + 1; k < kMonomials; ++k) rest -= s.row[i][k] * solution.c[k];
    solution.c[i] = rest * s.inverse[i];
  }
  // (G^-1)_ii is the squared length of U^-T e_i.
  for (int column = kCubic; column < kCubic + 4; ++column) {
    Lanes y[kMonomials], square = {};
    for (int r = column; r < kMonomials; ++r) {
      Lanes rest = {};
      if (r == column) rest += 1;
      for (int k = column; k < r; ++k) rest -= s.row[k][r] * y[k];
      y[r] = rest * s.inverse[r];
      square += y[r] * y[r];
    }
    const auto larger = square > solution.cubic_variance;
    solution.cubic_variance = larger ? square : solution.cubic_variance;
  }
}

// Columns that make no full degree are not used; those before them stay as they are.
int trim(Systems& s, std::size_t lane, int columns) {
  const int degree = degree_of(columns);
  for (int j = degree > 0 ? offset(degree + 1) : 0; j < kMonomials; ++j) s.inverse[j][lane] = 0;
  return degree;
}

}  // namespace

std::array<Jet, kLanes> fit_jets(const NeighbourhoodLanes& local, int max_degree) {
  Sums sums;
  accumulate(local.rows, sums);
  Systems systems;
  set_up(sums, systems);
  int wanted[kLanes], columns[kLanes];
  for (std::size_t l = 0; l < kLanes; ++l) {
    const int points = static_cast<int>(std::min<std::size_t>(local.size[l], 1000));
    wanted[l] = std::min(offset(max_degree + 1), offset(degree_of(points) + 1));
  }
  eliminate(systems, wanted, columns);
  std::array<Jet, kLanes> jets;
  for (std::size_t l = 0; l < kLanes; ++l) jets[l].degree = trim(systems, l, columns[l]);
  Solution solution;
  solve(systems, solution);

  for (std::size_t l = 0; l < kLanes; ++l) {
    Jet& jet = jets[l];
    if (jet.degree == 0) continue;
    const int n = offset(jet.degree + 1);
    double smallest = systems.inverse[0][l], largest = smallest, explained = 0;
    for (int i = 0; i < n; ++i) {
      jet.c[static_cast<std::size_t>(i)] = solution.c[i][l];
      smallest = std::min(smallest, systems.inverse[i][l]);
      largest = std::max(largest, systems.inverse[i][l]);
      const double y = systems.row[i][kMonomials][l];
      explained += y * y;
    }
    jet.condition = largest / smallest;
    if (jet.degree < 3) continue;
    const double freedom = std::max(1.0, static_cast<double>(local.size[l]) - n);
    const double variance = std::max(0.0, sums.square[l] - explained) / freedom;
    jet.cubic_error = std::sqrt(variance * solution.cubic_variance[l]);
  }
  return jets;
}

}  // namespace crest::ridges
