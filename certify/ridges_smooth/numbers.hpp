// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the formulas ask of number types besides + - *: models, and plain doubles.
#include <cmath>

#include "kernel/arithmetic/jet_tables.hpp"
#include "kernel/arithmetic/sparse_array.hpp"

namespace crest::certify::smooth {

template <class M>
M reciprocal(const M& x) {
  return inverse(x);
}
inline double reciprocal(double x) {
  return 1 / x;
}
template <class M>
M square_root(const M& x) {
  using std::sqrt;
  return sqrt(x);
}

/// c_k += x y; an empty place is zero.
template <class M, int Count>
void accumulate(kernel::SparseArray<M, Count>& c, std::size_t k, const M& x, const M& y) {
  using kernel::add_product;
  if (c.has(k))
    add_product(c.place(k), x, y);
  else
    c.make(k, [&] { return M(x * y); });
}

}  // namespace crest::certify::smooth
