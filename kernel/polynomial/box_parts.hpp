// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Parts of a box's Bezier net: both sides of a cut across an axis, faces.
//
// Laws. (1) Values of the parts of a split are values of the whole. (2) A face's net has the values
// on the face.
#include "kernel/polynomial/bernstein_form.hpp"

namespace crest::kernel {

/// Calls f(offset) at the first coefficient of every line along an axis.
template <class B, class F>
void for_each_line(std::size_t axis, F&& f) {
  for (std::size_t i = 0; i < B::count; ++i)
    if (B::indices[i][axis] == 0) f(i);
}

/// The two parts of a box cut at x_axis = t; each is the unit box again.
template <class N>
struct BoxHalves {
  N low, high;
};
template <class T, int... N>
BoxHalves<BoxNet<T, N...>> split(const BoxNet<T, N...>& b, std::size_t axis, const T& t) {
  using Basis = BoxBasis<N...>;
  BoxHalves<BoxNet<T, N...>> r{b, b};
  const std::size_t stride = Basis::stride(axis), degree = Basis::degrees[axis];
  const T s = T(1) - t;
  for_each_line<Basis>(axis, [&](std::size_t first) {
    const auto at = [&](std::size_t k) { return first + k * stride; };
    for (std::size_t level = 1; level <= degree; ++level) {
      for (std::size_t k = 0; k + level <= degree; ++k)
        r.high.c[at(k)] = s * r.high.c[at(k)] + t * r.high.c[at(k + 1)];
      r.low.c[at(level)] = r.high.c[first];
    }
  });
  return r;
}

/// BoxBasis<N...> without one axis.
template <int Axis, class B>
struct Dropped;
template <int A>
struct Dropped<0, BoxBasis<A>> {
  using type = SimplexBasis<1, 0>;
};
template <int A, int B>
struct Dropped<0, BoxBasis<A, B>> {
  using type = BoxBasis<B>;
};
template <int A, int B>
struct Dropped<1, BoxBasis<A, B>> {
  using type = BoxBasis<A>;
};
template <int A, int B, int C>
struct Dropped<0, BoxBasis<A, B, C>> {
  using type = BoxBasis<B, C>;
};
template <int A, int B, int C>
struct Dropped<1, BoxBasis<A, B, C>> {
  using type = BoxBasis<A, C>;
};
template <int A, int B, int C>
struct Dropped<2, BoxBasis<A, B, C>> {
  using type = BoxBasis<A, B>;
};

/// The net on the face x_Axis = 0 or 1 (in dimension 1: the end's value).
template <int Axis, class T, int... N>
auto restricted(const BoxNet<T, N...>& b, bool high) {
  using From = BoxBasis<N...>;
  using To = typename Dropped<Axis, From>::type;
  Net<T, To> r;
  std::size_t i = 0;
  for_each_line<From>(Axis, [&](std::size_t first) {
    r.c[i++] = b.c[first + (high ? From::degrees[Axis] * From::stride(Axis) : 0)];
  });
  return r;
}

}  // namespace crest::kernel
