// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/umbilics.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/smooth_ridges/square_enclosure.hpp"

namespace crest::smooth_ridges {
namespace {

using kernel::Interval;
using Square = std::array<Interval, 2>;

Interval around(double x, double radius) {
  return Interval(x) + Interval(-radius, radius);
}
std::array<Interval, 3> in_space(std::size_t axis, const Square& z, const Interval& height) {
  const auto [i, j] = plane_axes(axis);
  std::array<Interval, 3> x;
  x[i] = z[0];
  x[j] = z[1];
  x[axis] = height;
  return x;
}

/// The graph's axis should stay the steepest of grad F.
bool settle_axis(ImplicitMap<double, 1>& f, SurfacePoint& p) {
  const Vec3 x = in_space(p);
  const auto value = f(x);
  const Vec3 g = {value.coefficient(1, 0, 0), value.coefficient(0, 1, 0),
                  value.coefficient(0, 0, 1)};
  std::size_t best = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::fabs(g[k]) > std::fabs(g[best])) best = k;
  p.axis = best;
  const auto [i, j] = plane_axes(best);
  p.z = {x[i], x[j]};
  p.height = x[best];
  return settle(f, p);
}

/// Newton's step for (a, b) = 0.
template <class Geometry>
std::array<double, 2> newton_step(const Geometry& g) {
  const auto s = shape_of(g.template first<1>(), g.template second<1>());
  const double ap = s.a.coefficient(1, 0), aq = s.a.coefficient(0, 1);
  const double bp = s.b.coefficient(1, 0), bq = s.b.coefficient(0, 1);
  const double det = ap * bq - aq * bp;
  return {-(bq * s.a[0] - aq * s.b[0]) / det, -(ap * s.b[0] - bp * s.a[0]) / det};
}

/// Enclosures of the surface's jets over squares, of either kind.
class Enclosure {
 public:
  explicit Enclosure(const Surface& surface) {
    if (surface.is_implicit())
      implicit_.emplace(surface);
    else
      map_.emplace(surface);
  }
  bool implicit() const { return implicit_.has_value(); }

  kernel::Jet<Interval, 3, 4> space(std::size_t axis, const Square& z, const Interval& height) {
    return (*implicit_)(in_space(axis, z, height));
  }
  MapGeometry<Interval, 4> map(const Square& z) { return {(*map_)(z)}; }

 private:
  std::optional<ImplicitMap<Interval, 4>> implicit_;
  std::optional<ParametricMap<Interval, 4>> map_;
};

Interval slope(const kernel::Jet<Interval, 3, 4>& f, std::size_t axis) {
  return axis == 0   ? f.coefficient(1, 0, 0)
         : axis == 1 ? f.coefficient(0, 1, 0)
                     : f.coefficient(0, 0, 1);
}

GraphGeometry<Interval, 4> graph(const kernel::Jet<Interval, 3, 4>& f, std::size_t axis) {
  return {GraphJet<Interval, 4>::of(f, axis), slope(f, axis).inf() > 0 ? 1 : -1};
}

class Proof {
 public:
  Proof(Enclosure& enclosure, const SurfacePoint& guess, double radius)
      : enclosure_(enclosure), guess_(guess), radius_(radius) {}

  /// over: on Q, of half-size `radius`.
  std::optional<Umbilic> run(const Over& over) {
    const kernel::RoundUpward guard;
    const Square q = square(radius_);
    if (!enclosure_.implicit())
      return with([&](const Square& z) { return enclosure_.map(z); }, over);
    if (!find_heights(q)) return std::nullopt;
    if (holds_zero(slope(enclosure_.space(guess_.axis, q, heights_), guess_.axis)))
      return std::nullopt;
    return with(
        [&](const Square& z) {
          const Interval h = narrow(z);
          return graph(enclosure_.space(guess_.axis, z, h), guess_.axis);
        },
        over);
  }

 private:
  Square square(double r) const { return {around(guess_.z[0], r), around(guess_.z[1], r)}; }

  /// geometry(square): enclosures of the jets over a part of Q.
  template <class GeometryOf>
  std::optional<Umbilic> with(const GeometryOf& geometry, const Over& over) {
    const auto centre = geometry(square(0));
    for (int k = 16; k >= 6; k -= 2) {
      const double rho = std::ldexp(radius_, -k);
      const auto at = geometry(square(rho));
      if (!krawczyk(centre, at, rho)) continue;
      Interval own(0);
      if (enclosure_.implicit()) own = narrow(square(rho));
      const auto branches =
          blow_up({forms_of<1>(at), over.forms,
                   shape_of(at.template first<1>(), at.template second<1>()), over.shape},
                  radius_);
      if (!branches) return std::nullopt;
      return Umbilic{
          guess_,   rho, radius_, {heights_.inf(), heights_.sup()}, {own.inf(), own.sup()},
          *branches};
    }
    return std::nullopt;
  }

  /// K(U0) within the interior of U0.
  template <class Geometry>
  static bool krawczyk(const Geometry& centre, const Geometry& over, double rho) {
    const auto s = shape_of(centre.template first<0>(), centre.template second<0>());
    const auto d = shape_of(over.template first<1>(), over.template second<1>());
    const std::array<Interval, 4> j = {d.a.coefficient(1, 0), d.a.coefficient(0, 1),
                                       d.b.coefficient(1, 0), d.b.coefficient(0, 1)};
    std::array<double, 4> m;
    for (std::size_t k = 0; k < 4; ++k) m[k] = 0.5 * (j[k].inf() + j[k].sup());
    const double det = m[0] * m[3] - m[1] * m[2];
    const std::array<double, 4> y = {m[3] / det, -m[1] / det, -m[2] / det, m[0] / det};
    const Interval box(-rho, rho);
    for (std::size_t r = 0; r < 2; ++r) {
      const Interval y0(y[2 * r]), y1(y[2 * r + 1]);
      const Interval rest0 = Interval(r == 0 ? 1 : 0) - (y0 * j[0] + y1 * j[2]);
      const Interval rest1 = Interval(r == 1 ? 1 : 0) - (y0 * j[1] + y1 * j[3]);
      const Interval k = -(y0 * s.a[0] + y1 * s.b[0]) + rest0 * box + rest1 * box;
      if (!(k.inf() > -rho && k.sup() < rho)) return false;
    }
    return true;
  }

  /// F has opposite signs at the two ends of heights_ over q.
  bool find_heights(const Square& q) {
    double half = 2 * radius_;
    for (int i = 0; i < 8; ++i, half *= 1.5) {
      heights_ = around(guess_.height, half);
      const Interval low = value(q, heights_.inf()), high = value(q, heights_.sup());
      if (!holds_zero(low) && !holds_zero(high) && (low.inf() > 0) != (high.inf() > 0)) return true;
    }
    return false;
  }
  /// F over q at a height, in mean value form.
  Interval value(const Square& q, double height) {
    const Interval h(height);
    const auto centre = enclosure_.space(guess_.axis, square(0), h);
    const auto over = enclosure_.space(guess_.axis, q, h);
    const auto [i, j] = plane_axes(guess_.axis);
    const Interval r(-radius_, radius_);
    return centre[0] + slope(over, i) * r + slope(over, j) * r;
  }
  /// The graph's heights over a part of q, by interval Newton.
  Interval narrow(const Square& z) {
    Interval h = heights_;
    for (int i = 0; i < 6; ++i) {
      const Interval m(h.inf() + 0.5 * (h.sup() - h.inf()));
      const Interval step = m - enclosure_.space(guess_.axis, z, m)[0] /
                                    slope(enclosure_.space(guess_.axis, z, h), guess_.axis);
      h = Interval(std::max(h.inf(), step.inf()), std::min(h.sup(), step.sup()));
    }
    return h;
  }

  Enclosure& enclosure_;
  SurfacePoint guess_;
  double radius_;
  Interval heights_{0};
};

}  // namespace

UmbilicFinder::UmbilicFinder(const Surface& surface) {
  if (surface.is_implicit())
    value_.emplace(surface), jet_.emplace(surface);
  else
    map_.emplace(surface);
}

std::optional<SurfacePoint> UmbilicFinder::operator()(SurfacePoint p, double reach) {
  double gone = 0;
  for (int i = 0; i < 40; ++i) {
    if (value_ && !settle_axis(*value_, p)) return std::nullopt;
    std::array<double, 2> step;
    if (jet_) {
      const auto f = (*jet_)(in_space(p));
      step = newton_step(GraphGeometry<double, 3>{GraphJet<double, 3>::of(f, p.axis), 1});
    } else {
      step = newton_step(MapGeometry<double, 3>{(*map_)(p.z)});
    }
    const double length = std::hypot(step[0], step[1]);
    gone += length;
    if (!(gone <= reach)) return std::nullopt;
    p.z = {p.z[0] + step[0], p.z[1] + step[1]};
    if (length < 1e-14 * (1 + std::hypot(p.z[0], p.z[1]))) {
      if (value_ && !settle(*value_, p)) return std::nullopt;
      return p;
    }
  }
  return std::nullopt;
}

std::optional<Umbilic> prove_umbilic(const Surface& surface, const SurfacePoint& guess,
                                     double radius) {
  Enclosure enclosure(surface);
  SquareEnclosure squares(surface);
  // Half of the first R that is proven: a checker's enclosures are others.
  constexpr int kInARow = 3;
  int proofs = 0;
  for (int i = 0; i <= 60; ++i, radius *= 0.7071) {
    const auto over = squares(guess, radius);
    const auto proven = over ? Proof(enclosure, guess, radius).run(*over) : std::nullopt;
    proofs = proven ? proofs + 1 : 0;
    if (proofs == kInARow) return proven;
  }
  return std::nullopt;
}

}  // namespace crest::smooth_ridges
