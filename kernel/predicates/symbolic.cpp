// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/symbolic.hpp"

#include <algorithm>

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

Sign symbolic_product(const Vec3& d, const Vec3& e) {
  for (std::size_t i = 0; i < 3; ++i)
    if (d[i] != 0 && e[i] != 0) return sign_of(d[i]) * sign_of(e[i]);
  // Now each axis is missing from d or from e, so at most one term of a mixed product is non-zero.
  for (const auto& [i, j] : {std::pair{0u, 1u}, {0u, 2u}, {1u, 2u}}) {
    const Sign s = sign_of(d[i]) * sign_of(e[j]);
    const Sign t = sign_of(d[j]) * sign_of(e[i]);
    if (s != Sign::zero && t == Sign::zero) return s;
    if (t != Sign::zero && s == Sign::zero) return t;
    if (s != Sign::zero)
      return sign_of(Rational(d[i]) * Rational(e[j]) + Rational(d[j]) * Rational(e[i]));
  }
  return Sign::zero;
}

}  // namespace crest::kernel
