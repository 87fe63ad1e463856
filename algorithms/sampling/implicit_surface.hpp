// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A surface F = 0, F < 0 inside, and its exact Monge forms.
#include <memory>
#include <utility>

#include "algorithms/sampling/jet.hpp"
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/monge_form.hpp"

namespace crest::sampling {

using kernel::cross, kernel::dot, kernel::norm, kernel::Vec3;
using kernel::operator+, kernel::operator-, kernel::operator*;
using Point = kernel::Vector3<Real>;

/// F over plain numbers and over the jets the library needs (see implicit()).
class ImplicitSurface {
 public:
  template <class T>
  using Arguments = std::array<T, 3>;

  virtual ~ImplicitSurface() = default;
  virtual Real value(const Point& p) const = 0;
  virtual Jet<1, 1> evaluate(const Arguments<Jet<1, 1>>& p) const = 0;
  virtual Jet<3, 1> evaluate(const Arguments<Jet<3, 1>>& p) const = 0;
  virtual Jet<2, 2> evaluate(const Arguments<Jet<2, 2>>& p) const = 0;
  virtual Jet<2, 4> evaluate(const Arguments<Jet<2, 4>>& p) const = 0;
};

/// The surface of a formula written once: f(x, y, z) for any number type, with square,
/// exponential and root of jet.hpp.
template <class Formula>
std::shared_ptr<const ImplicitSurface> implicit(Formula formula) {
  class Surface final : public ImplicitSurface {
   public:
    explicit Surface(Formula f) : f_(std::move(f)) {}
    Real value(const Point& p) const override { return f_(p[0], p[1], p[2]); }
    Jet<1, 1> evaluate(const Arguments<Jet<1, 1>>& p) const override {
      return f_(p[0], p[1], p[2]);
    }
    Jet<3, 1> evaluate(const Arguments<Jet<3, 1>>& p) const override {
      return f_(p[0], p[1], p[2]);
    }
    Jet<2, 2> evaluate(const Arguments<Jet<2, 2>>& p) const override {
      return f_(p[0], p[1], p[2]);
    }
    Jet<2, 4> evaluate(const Arguments<Jet<2, 4>>& p) const override {
      return f_(p[0], p[1], p[2]);
    }

   private:
    Formula f_;
  };
  return std::make_shared<Surface>(std::move(formula));
}

struct ValueAndGradient {
  Real value;
  Point gradient;
};
ValueAndGradient gradient(const ImplicitSurface& surface, const Point& p);

/// The Monge form of kernel/geometry/monge_form.hpp with n = grad F / |grad F| (outward).
/// Requires: p within rounding of the surface, grad F not zero there, F four times differentiable.
/// Guarantees: k1 >= k2; computed in extended precision and rounded once. The sign of d1 is
///   arbitrary, and so is d1 itself at an umbilic.
/// The height over the tangent plane is solved as a power series: z <- z - F(x, y, z) / |grad F|
/// gains one order a step (implicit function theorem).
kernel::MongeForm monge_form(const ImplicitSurface& surface, const Point& p);
inline kernel::MongeForm monge_form(const ImplicitSurface& surface, const Vec3& p) {
  return monge_form(surface, Point{p[0], p[1], p[2]});
}

/// The point origin + t direction, t > 0, with F = 0, by Newton's method kept inside a bracket.
/// Requires: F(origin) < 0 and F > 0 far along the ray; the first guess is t = 1. Where the ray
///   meets the surface more than once, one of the meetings.
/// Throws: std::invalid_argument if F does not change sign.
Point project_along_ray(const ImplicitSurface& surface, const Point& origin,
                        const Point& direction);

inline Point to_point(const Vec3& p) {
  return {p[0], p[1], p[2]};
}
inline Vec3 to_vec3(const Point& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

}  // namespace crest::sampling
