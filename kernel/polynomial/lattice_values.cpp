// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/polynomial/lattice_values.hpp"

#include <cassert>
#include <utility>

#include "kernel/polynomial/dyadic.hpp"

namespace crest::kernel {

LatticeInverse inverse_of(const std::vector<Rational>& matrix, std::size_t count) {
  std::vector<Rational> m = matrix, r(count * count);
  for (std::size_t i = 0; i < count; ++i) r[i * count + i] = 1;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t pivot = k;
    while (m[pivot * count + k] == 0) ++pivot;
    for (std::size_t j = 0; j < count && pivot != k; ++j) {
      std::swap(m[pivot * count + j], m[k * count + j]);
      std::swap(r[pivot * count + j], r[k * count + j]);
    }
    const Rational scale = 1 / m[k * count + k];
    for (std::size_t i = 0; i < count; ++i) {
      const Rational factor = m[i * count + k] * scale;
      if (i == k || factor == 0) continue;
      for (std::size_t j = 0; j < count; ++j) {
        if (j >= k) m[i * count + j] -= factor * m[k * count + j];
        if (r[k * count + j] != 0) r[i * count + j] -= factor * r[k * count + j];
      }
    }
  }
  Integer common = 1;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      r[i * count + j] /= m[i * count + i];
      common = lcm(common, Integer(denominator(r[i * count + j])));
    }
  LatticeInverse inverse;
  inverse.denominator = common.convert_to<double>();
  assert(Integer(inverse.denominator) == common);
  for (const Rational& x : r) {
    const Rational n = x * common;
    inverse.numerators.push_back(n.convert_to<double>());
    assert(Rational(inverse.numerators.back()) == n);
  }
  return inverse;
}

}  // namespace crest::kernel
