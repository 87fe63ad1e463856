// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Uniform cubic B-splines sum c_ijk B(x - i) B(y - j) B(z - k) cell by cell: Bezier nets of value
// and derivatives, and values at points. Written once for any dimension and number type.
//
// A cell [i, i + 1]^Dim sees the coefficients i - 1 .. i + 2 along each axis: 4^Dim numbers, axis 0
// fastest. A net has as many, all cubic whatever the derivative's order (lower degrees raised), in
// the order of BoxBasis<3, ...>.
//
// Laws. (1) The net of order 0 holds convex combinations of the coefficients; the absolute weights
// of order k sum up to at most 2^k along that axis. (2) A polynomial of degree k has a net of order
// k that is constant.
#include <array>
#include <cstddef>

namespace crest::kernel {

/// The cubic Bezier values of the derivative of this order (0 to 3) on one interval.
template <class T>
inline std::array<T, 4> spline_bezier(const T& c0, const T& c1, const T& c2, const T& c3,
                                      int order) {
  if (order == 0) {
    const T six(6), four(4), three(3), two(2);
    return {(c0 + four * c1 + c2) / six, (two * c1 + c2) / three, (c1 + two * c2) / three,
            (c1 + four * c2 + c3) / six};
  }
  if (order == 1) {
    const T two(2), three(3);
    const T b0 = (c2 - c0) / two, b1 = c2 - c1, b2 = (c3 - c1) / two;
    return {b0, (b0 + two * b1) / three, (two * b1 + b2) / three, b2};
  }
  const T d0 = c0 - T(2) * c1 + c2, d1 = c1 - T(2) * c2 + c3;
  if (order == 2) return {d0, (T(2) * d0 + d1) / T(3), (d0 + T(2) * d1) / T(3), d1};
  const T t = d1 - d0;
  return {t, t, t, t};
}

constexpr std::size_t spline_count(int dim) {
  return dim == 0 ? 1 : 4 * spline_count(dim - 1);
}
template <class T, int Dim>
using SplineCell = std::array<T, spline_count(Dim)>;

/// The same for blocks of `stride` neighbours, in place. Doubles: factors 1/3 and 1/6 are rounded,
/// so that controls may differ from spline_bezier's by a few units in the last place.
template <int order, class T, std::size_t size>
void to_bezier(std::array<T, size>& c, std::size_t stride) {
  const T third = T(1) / T(3), sixth = T(1) / T(6), half = T(1) / T(2);
  for (std::size_t high = 0; high < size; high += 4 * stride)
    for (std::size_t low = high; low < high + stride; ++low) {
      T &c0 = c[low], &c1 = c[low + stride], &c2 = c[low + 2 * stride], &c3 = c[low + 3 * stride];
      if constexpr (order == 0) {
        const T a = c1 + c1, b = c2 + c2;
        const T first = (c0 + (a + a) + c2) * sixth, last = (c1 + (b + b) + c3) * sixth;
        const T second = (a + c2) * third, next = (c1 + b) * third;
        c0 = first, c1 = second, c2 = next, c3 = last;
      } else if constexpr (order == 1) {
        const T b0 = (c2 - c0) * half, b1 = c2 - c1, b2 = (c3 - c1) * half;
        c0 = b0, c1 = (b0 + (b1 + b1)) * third, c2 = ((b1 + b1) + b2) * third, c3 = b2;
      } else {
        const T d0 = c0 - (c1 + c1) + c2, d1 = c1 - (c2 + c2) + c3;
        if constexpr (order == 2)
          c0 = d0, c1 = ((d0 + d0) + d1) * third, c2 = (d0 + (d1 + d1)) * third, c3 = d1;
        else
          c0 = c1 = c2 = c3 = d1 - d0;
      }
    }
}

/// The net of a derivative, in place of the coefficients.
template <class T, int Dim>
void to_spline_net(SplineCell<T, Dim>& c, const std::array<int, Dim>& orders) {
  for (std::size_t axis = 0, stride = 1; axis < Dim; ++axis, stride *= 4) switch (orders[axis]) {
      case 0:
        to_bezier<0>(c, stride);
        break;
      case 1:
        to_bezier<1>(c, stride);
        break;
      case 2:
        to_bezier<2>(c, stride);
        break;
      default:
        to_bezier<3>(c, stride);
    }
}

/// The weights of c0 .. c3 in the derivative at t of [0, 1].
template <class T>
std::array<T, 4> spline_weights(const T& t, int order) {
  const T s = T(1) - t;
  switch (order) {
    case 0:
      return {s * s * s / T(6), (T(4) - T(6) * t * t + T(3) * t * t * t) / T(6),
              (T(4) - T(6) * s * s + T(3) * s * s * s) / T(6), t * t * t / T(6)};
    case 1:
      return {-s * s / T(2), (T(3) * t * t - T(4) * t) / T(2), (T(4) * s - T(3) * s * s) / T(2),
              t * t / T(2)};
    case 2:
      return {s, T(3) * t - T(2), T(3) * s - T(2), t};
    default:
      return {T(-1), T(3), T(-3), T(1)};
  }
}

/// A derivative at a point of the cell, from each axis' weights.
template <class T, int Dim>
T spline_value(const SplineCell<T, Dim>& c, const std::array<std::array<T, 4>, Dim>& weights) {
  SplineCell<T, Dim> r = c;
  std::size_t count = c.size();
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    count /= 4;
    const auto& w = weights[axis];
    for (std::size_t i = 0; i < count; ++i)
      r[i] = w[0] * r[4 * i] + w[1] * r[4 * i + 1] + w[2] * r[4 * i + 2] + w[3] * r[4 * i + 3];
  }
  return r[0];
}

}  // namespace crest::kernel
