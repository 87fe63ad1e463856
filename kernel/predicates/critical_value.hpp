// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Derivatives of a quadratic function on an edge or a triangle from its nodal values, and the
// critical values they give (paper 003, section 3.1; normal forms of certify/SPEC.md, claim 3).
//
// Differences of nodal values come first, so that equal values cancel without rounding.
#include <array>
#include <compare>

#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

/// End values a, b and midpoint value m.
struct EdgeValues {
  double a, b, m;
};

/// Corner values, then midpoint values of the sides c0 c1, c1 c2, c2 c0.
struct FaceValues {
  std::array<double, 3> corner, side;
  /// The same function with corner k first.
  FaceValues rotated(std::size_t k) const {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    return {{corner[k], corner[l], corner[m]}, {side[k], side[l], side[m]}};
  }
  /// Corners 0 and 1 exchanged.
  FaceValues mirrored() const {
    return {{corner[1], corner[0], corner[2]}, {side[0], side[2], side[1]}};
  }
  /// Lexicographic.
  auto operator<=>(const FaceValues&) const = default;
  /// Side k from its corner k to corner k + 1.
  EdgeValues edge(std::size_t k) const { return {corner[k], corner[(k + 1) % 3], side[k]}; }
};

/// 4 m - 3 a - b: the derivative at the end a.
template <class T>
T slope(double a, double b, double m) {
  return T(4.0) * (T(m) - T(a)) - (T(b) - T(a));
}
/// a + b - 2 m: a quarter of the second derivative.
template <class T>
T bend(double a, double b, double m) {
  return (T(a) - T(m)) + (T(b) - T(m));
}

/// At corner 0, for s along c0 c1 and t along c0 c2: first derivatives g, h and a quarter of the
/// second ones, p = f_ss / 4, q = f_st / 4, r = f_tt / 4.
template <class T>
struct FaceDerivatives {
  T g, h, p, q, r;
  explicit FaceDerivatives(const FaceValues& f)
      : g(slope<T>(f.corner[0], f.corner[1], f.side[0])),
        h(slope<T>(f.corner[0], f.corner[2], f.side[2])),
        p(bend<T>(f.corner[0], f.corner[1], f.side[0])),
        q((T(f.corner[0]) - T(f.side[0])) + (T(f.side[1]) - T(f.side[2]))),
        r(bend<T>(f.corner[0], f.corner[2], f.side[2])) {}
};

enum class ValueKind : std::uint8_t { vertex, edge, face };

/// The value of a node: of a vertex (corner[0]), of a line-critical point (corner[0], corner[1],
/// side[0]) or of a face-critical point. denominator: the sign of the point's second derivative
/// (of H for a face), which is not zero; positive for a vertex.
struct CriticalValue {
  ValueKind kind;
  Sign denominator;
  FaceValues f;
  static CriticalValue vertex(double a) {
    return {ValueKind::vertex, Sign::positive, {{a, 0, 0}, {0, 0, 0}}};
  }
  static CriticalValue edge(const EdgeValues& e, Sign second) {
    return {ValueKind::edge, second, {{e.a, e.b, 0}, {e.m, 0, 0}}};
  }
  static CriticalValue face(const FaceValues& f, Sign hessian) {
    return {ValueKind::face, hessian, f};
  }
};

/// The same critical value from data that do not depend on the order of the corners, in which zero
/// has no sign: of two nodes with equal normal forms the values are equal. (Not conversely.)
CriticalValue normal_form(const CriticalValue& value);

/// The value as corner[0] + numerator / denominator.
template <class T, ValueKind kind>
struct ValueFraction {
  T numerator, denominator;
  explicit ValueFraction(const FaceValues& f) {
    if constexpr (kind == ValueKind::vertex) {
      numerator = T(0.0);
      denominator = T(1.0);
    } else if constexpr (kind == ValueKind::edge) {
      // a - g^2 / (8 p)
      const T g = slope<T>(f.corner[0], f.corner[1], f.side[0]);
      numerator = T(0.0) - g * g;
      denominator = T(8.0) * bend<T>(f.corner[0], f.corner[1], f.side[0]);
    } else {
      // f0 + (g s + h t) / 2 with s = (h q - g r) / (4 (p r - q^2)), t = (g q - h p) / (the same).
      const FaceDerivatives<T> d(f);
      numerator = d.g * (d.h * d.q - d.g * d.r) + d.h * (d.g * d.q - d.h * d.p);
      denominator = T(8.0) * (d.p * d.r - d.q * d.q);
    }
  }
};

/// Doubles that enclose a value, a few units in the last place apart.
struct ValueRange {
  double low, high;
};
/// Exact for a vertex. Requires: a critical point inside its edge or face.
ValueRange value_range(const CriticalValue& value);

/// Where the point lies, to a few units in the last place, within [0, 1]: {x, 0} from a towards b
/// on an edge, {s, t} in a face.
std::array<double, 2> critical_place(const CriticalValue& value);

}  // namespace crest::kernel
