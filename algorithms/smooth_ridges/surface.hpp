// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The smooth surface that expressions define (certify/ridges_smooth/SPEC.md, "Data section").
//
// Implicit: S = {F = 0} inside a box. Parametric: X(u, v) on a rectangle, always evaluated in unit
// coordinates (U, V) in [0, 1]^2 with u = u0 + (u1 - u0) U, v = v0 + (v1 - v0) V.
#include <array>
#include <string>
#include <vector>

#include "certify/ridges_smooth/records.hpp"
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/expressions/enclosures.hpp"

namespace crest::smooth_ridges {

using kernel::cross, kernel::determinant, kernel::dot, kernel::norm, kernel::Vec3;
using kernel::operator+, kernel::operator-, kernel::operator*;

class Surface {
 public:
  using Box = std::array<double, 6>;  ///< x0, x1, y0, y1, z0, z1

  /// F in x, y, z.
  /// Throws: kernel::ExpressionError for F; std::invalid_argument for a box that is not finite or
  ///   has an upper bound not above the lower one, or an expression defined nowhere in the box.
  static Surface implicit(const std::string& f, const Box& box);

  /// x, y, z in u, v; the domain u0, u1, v0, v1 (constants, pi and e allowed); periodic in u, in v.
  /// Throws: kernel::ExpressionError, its message led by the expression's name;
  ///   std::invalid_argument if u0 < u1 or v0 < v1 is not certain, or a direction stated periodic
  ///   is not provably so by the rules of SPEC.md, or an expression is defined nowhere.
  static Surface parametric(const std::array<std::string, 3>& coordinates,
                            const std::array<std::string, 4>& domain,
                            const std::array<bool, 2>& periodic);

  bool is_implicit() const { return implicit_; }
  /// Implicit: F. Parametric: x, y, z.
  const std::vector<kernel::Expression>& functions() const { return functions_; }
  /// Parametric: u0, u1, v0, v1.
  const std::vector<kernel::Expression>& domain() const { return domain_; }
  const Box& box() const { return box_; }
  bool periodic(std::size_t direction) const { return periodic_[direction]; }
  bool any_period() const { return periodic_[0] || periodic_[1]; }
  certify::SmoothSurfaceData data() const;

 private:
  bool implicit_ = true;
  std::vector<kernel::Expression> functions_, domain_;
  Box box_{};
  std::array<bool, 2> periodic_{};
};

/// Whether x, y, z provably do not change when the variable `direction` (0: u, 1: v) grows by
/// upper - lower (SPEC.md, "Data section": a rational multiple of 2 pi; growths).
bool provably_periodic(const std::vector<kernel::Expression>& coordinates,
                       const kernel::Expression& lower, const kernel::Expression& upper,
                       std::size_t direction);

/// F and its derivatives up to Order over any number type. Not for two threads at a time.
template <class T, int Order>
class ImplicitMap {
 public:
  using Number = kernel::Jet<T, 3, Order>;
  explicit ImplicitMap(const Surface& surface)
      : f_(kernel::jet_evaluator<T, 3, Order>(surface.functions()[0])) {}
  Number operator()(const std::array<T, 3>& p) {
    const std::array<Number, 3> at = {Number::variable(0, p[0]), Number::variable(1, p[1]),
                                      Number::variable(2, p[2])};
    return f_(at);
  }
  /// In the coordinates of a frame: derivatives along its vectors (exact doubles).
  Number along(const std::array<T, 3>& p, const std::array<Vec3, 3>& frame) {
    std::array<Number, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = Number::constant(p[i]);
      // Of degree one the last variable comes first.
      for (std::size_t k = 0; k < 3; ++k)
        if (frame[k][i] != 0) at[i].set(3 - k, T(frame[k][i]));
    }
    return f_(at);
  }

 private:
  kernel::Evaluator<Number> f_;
};

/// X in unit coordinates and its derivatives with respect to them. Not for two threads at a time.
template <class T, int Order>
class ParametricMap {
 public:
  using Number = kernel::Jet<T, 2, Order>;
  explicit ParametricMap(const Surface& surface)
      : f_(kernel::jet_evaluator<T, 2, Order>(std::span(surface.functions()))) {
    for (std::size_t i = 0; i < 2; ++i) {
      start_[i] = kernel::jet_evaluator<T, 2, Order>(surface.domain()[2 * i])({});
      length_[i] = kernel::jet_evaluator<T, 2, Order>(surface.domain()[2 * i + 1])({}) - start_[i];
    }
  }
  std::array<Number, 3> operator()(const std::array<T, 2>& unit) {
    return of({Number::variable(0, unit[0]), Number::variable(1, unit[1])});
  }
  /// Along given jets of U and V.
  std::array<Number, 3> of(const std::array<Number, 2>& unit) {
    const std::array<Number, 2> at = {start_[0] + length_[0] * unit[0],
                                      start_[1] + length_[1] * unit[1]};
    return f_.template all<3>(at);
  }

 private:
  kernel::Evaluator<Number> f_;
  std::array<Number, 2> start_, length_;
};

}  // namespace crest::smooth_ridges
