// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/field_counts.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <vector>

#include "algorithms/modes/tensors.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::modes {
namespace {

using kernel::Rational;
using Four = std::array<Symmetric, 4>;

/// By the inverse of C, the matrix of their cosines: its trace is more than one over the least
/// eigenvalue of C. The deviators' own errors, of 2^-46 of their sizes, change C by less than
/// 2^-41, the roundings of its elimination without pivoting by less than 2^-47. Deviators of size
/// at most 8.
bool surely_independent(const std::array<const Deviator*, 4>& d) {
  // G = L D L^T, in scale; inverse: L^-1.
  std::array<std::array<double, 4>, 4> g, inverse;
  std::array<double, 4> sizes;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = i; k < 4; ++k) g[i][k] = product(d[i]->t, d[k]->t);
    sizes[i] = g[i][i];
    const double error = 0x1p46 * d[i]->error;
    if (!(sizes[i] > 0x1p-200 && sizes[i] > error * error)) return false;
  }
  double trace = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(g[i][i] > 0)) return false;
    const double over = 1 / g[i][i];
    inverse[i][i] = 1;
    for (std::size_t j = 0; j < i; ++j) {
      double sum = 0;
      for (std::size_t k = j; k < i; ++k) sum -= g[k][i] * inverse[k][j];
      inverse[i][j] = sum;
    }
    for (std::size_t j = 0; j <= i; ++j) trace += sizes[j] * inverse[i][j] * inverse[i][j] * over;
    for (std::size_t r = i + 1; r < 4; ++r) {
      const double factor = g[i][r] * over;
      for (std::size_t k = r; k < 4; ++k) g[r][k] -= factor * g[i][k];
    }
    for (std::size_t r = i + 1; r < 4; ++r) g[i][r] *= over;
  }
  return trace < 0x1p38;
}

bool are_dependent(const Four& given) {
  std::array<std::array<Rational, 6>, 4> rows;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::array<Rational, 6> t = {given[i][0], given[i][1], given[i][2],
                                       given[i][3], given[i][4], given[i][5]};
    rows[i] = {
        2 * t[0] - t[1] - t[2], 2 * t[1] - t[0] - t[2], 2 * t[2] - t[0] - t[1], t[3], t[4], t[5]};
  }
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 6 && rank < 4; ++column) {
    std::size_t pivot = rank;
    while (pivot < 4 && rows[pivot][column] == 0) ++pivot;
    if (pivot == 4) continue;
    std::swap(rows[pivot], rows[rank]);
    for (std::size_t r = rank + 1; r < 4; ++r) {
      const Rational factor = rows[r][column] / rows[rank][column];
      for (std::size_t k = column; k < 6; ++k) rows[r][k] -= factor * rows[rank][k];
    }
    ++rank;
  }
  return rank < 4;
}

}  // namespace

FieldCounts count_field(const ModeField& field) {
  FieldCounts counts;
  counts.zero_vertices = static_cast<std::size_t>(
      std::count_if(field.tensors.begin(), field.tensors.end(), is_isotropic));
  const int scale = scale_of(field.tensors);
  std::vector<Deviator> deviators(field.tensors.size());
  using Range = tbb::blocked_range<std::size_t>;
  kernel::parallel_for(Range(0, deviators.size(), 2048), [&](const Range& range) {
    for (std::size_t v = range.begin(); v < range.end(); ++v)
      deviators[v] = deviator(field.tensors[v], scale);
  });
  std::atomic<std::size_t> constant = 0, dependent = 0;
  kernel::parallel_for(Range(0, field.mesh.tets().size(), 2048), [&](const Range& range) {
    std::size_t equal = 0, singular = 0;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const auto& v = field.mesh.tets()[i];
      if (surely_independent(
              {&deviators[v[0]], &deviators[v[1]], &deviators[v[2]], &deviators[v[3]]}))
        continue;
      const Four t = {field.tensors[v[0]], field.tensors[v[1]], field.tensors[v[2]],
                      field.tensors[v[3]]};
      const bool same = t[0] == t[1] && t[0] == t[2] && t[0] == t[3];
      equal += same ? 1 : 0;
      singular += same || are_dependent(t) ? 1 : 0;
    }
    constant += equal;
    dependent += singular;
  });
  counts.constant_tets = constant;
  counts.rank_deficient_tets = dependent;
  return counts;
}

}  // namespace crest::modes
