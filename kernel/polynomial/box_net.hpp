// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bezier nets on the unit box (dimensions 1 to 3, any degree per axis): values, gradients,
// derivatives. (Parts and faces: box_parts.hpp. Products: bernstein_form.hpp.)
//
// Laws. (1) The gradient holds the partial derivatives. (2) A derivative's net has their values.
// (3) A raised net has the same values.
#include <utility>

#include "kernel/polynomial/bernstein_form.hpp"

namespace crest::kernel {

/// BoxBasis<N...> with the degree of one axis changed by Change.
template <int Axis, int Change, class B, class I>
struct Changed;
template <int Axis, int Change, int... N, std::size_t... I>
struct Changed<Axis, Change, BoxBasis<N...>, std::index_sequence<I...>> {
  using type = BoxBasis<(I == Axis ? N + Change : N)...>;
};
template <int Axis, int Change, class B>
using ChangedBasis =
    typename Changed<Axis, Change, B, std::make_index_sequence<std::size_t{B::dim}>>::type;

/// The partial derivative by x_Axis.
template <int Axis, class T, int... N>
auto derivative(const BoxNet<T, N...>& b) {
  using From = BoxBasis<N...>;
  using To = ChangedBasis<Axis, -1, From>;
  Net<T, To> r;
  const T degree(static_cast<int>(From::degrees[Axis]));
  for (std::size_t i = 0; i < To::count; ++i) {
    const std::size_t k = From::position(To::indices[i]);
    r.c[i] = degree * (b.c[k + From::stride(Axis)] - b.c[k]);
  }
  return r;
}

/// The same polynomial with the degree along Axis one higher.
template <int Axis, class T, int... N>
auto raised(const BoxNet<T, N...>& b) {
  using From = BoxBasis<N...>;
  using To = ChangedBasis<Axis, 1, From>;
  Net<T, To> r;
  constexpr std::size_t degree = To::degrees[Axis];
  for (std::size_t i = 0; i < To::count; ++i) {
    typename To::Index a = To::indices[i];
    const std::size_t k = a[Axis];
    const T up(static_cast<int>(k)), down(static_cast<int>(degree - k));
    if (k == degree) {
      --a[Axis];
      r.c[i] = b.c[From::position(a)];
      continue;
    }
    const std::size_t here = From::position(a);
    r.c[i] = k == 0 ? b.c[here]
                    : (up * b.c[here - From::stride(Axis)] + down * b.c[here]) /
                          T(static_cast<int>(degree));
  }
  return r;
}

template <class T, std::size_t Dim>
struct BoxValue {
  T value;
  std::array<T, Dim> gradient;
};
/// de Casteljau along the last axis; the lower axes' values and derivatives come recursively.
template <class T, int... N>
T box_value(std::array<T, BoxBasis<N...>::count> c, const std::array<T, sizeof...(N)>& x,
            int derivative_axis) {
  using Basis = BoxBasis<N...>;
  for (std::size_t axis = Basis::dim; axis-- > 0;) {
    const std::size_t stride = Basis::stride(axis);
    std::size_t degree = Basis::degrees[axis];
    if (static_cast<int>(axis) == derivative_axis) {
      if (degree == 0) return T(0);
      for (std::size_t i = 0; i < degree * stride; ++i)
        c[i] = T(static_cast<int>(degree)) * (c[i + stride] - c[i]);
      --degree;
    }
    const T s = T(1) - x[axis];
    for (; degree > 0; --degree)
      for (std::size_t i = 0; i < degree * stride; ++i) c[i] = s * c[i] + x[axis] * c[i + stride];
  }
  return c[0];
}

template <class T, int... N>
T value_at(const BoxNet<T, N...>& b, const std::array<T, sizeof...(N)>& x) {
  return box_value<T, N...>(b.c, x, -1);
}
template <class T, int... N>
BoxValue<T, sizeof...(N)> value_and_gradient_at(const BoxNet<T, N...>& b,
                                                const std::array<T, sizeof...(N)>& x) {
  BoxValue<T, sizeof...(N)> r;
  r.value = value_at(b, x);
  for (std::size_t k = 0; k < sizeof...(N); ++k)
    r.gradient[k] = box_value<T, N...>(b.c, x, static_cast<int>(k));
  return r;
}

}  // namespace crest::kernel
