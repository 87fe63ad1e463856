// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/field_counts.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "algorithms/modes/tensors.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::modes {
namespace {

using kernel::Rational;
using Four = std::array<Symmetric, 4>;

/// By Gram-Schmidt, twice: sure where every tensor keeps much more than what roundings make.
bool surely_independent(const Four& given) {
  std::array<Symmetric, 4> basis;
  for (std::size_t i = 0; i < 4; ++i) {
    Symmetric x = deviator(given[i], 0).t;
    const double size = std::sqrt(product(x, x));
    if (!(size > 0x1p-400 && size < 0x1p400)) return false;
    for (double& e : x) e /= size;
    for (int twice = 0; twice < 2; ++twice)
      for (std::size_t k = 0; k < i; ++k) {
        const double c = product(x, basis[k]);
        for (std::size_t e = 0; e < 6; ++e) x[e] -= c * basis[k][e];
      }
    const double left = std::sqrt(product(x, x));
    if (!(left > 1e-6)) return false;
    for (double& e : x) e /= left;
    basis[i] = x;
  }
  return true;
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
  std::atomic<std::size_t> constant = 0, dependent = 0;
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, field.mesh.tets().size(), 2048),
                       [&](const auto& range) {
                         std::size_t equal = 0, singular = 0;
                         for (std::size_t i = range.begin(); i < range.end(); ++i) {
                           const auto& v = field.mesh.tets()[i];
                           const Four t = {field.tensors[v[0]], field.tensors[v[1]],
                                           field.tensors[v[2]], field.tensors[v[3]]};
                           const bool same = t[0] == t[1] && t[0] == t[2] && t[0] == t[3];
                           equal += same ? 1 : 0;
                           singular += same || (!surely_independent(t) && are_dependent(t)) ? 1 : 0;
                         }
                         constant += equal;
                         dependent += singular;
                       });
  counts.constant_tets = constant;
  counts.rank_deficient_tets = dependent;
  return counts;
}

}  // namespace crest::modes
