// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/skeleton/traps.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"

namespace crest::certify::skeleton {
namespace {

Rational cross(const Point<Rational>& p, const Point<Rational>& q) {
  return p.a * q.b - p.b * q.a;
}
Point<Rational> minus(const Point<Rational>& p, const Point<Rational>& q) {
  return {p.a - q.a, p.b - q.b};
}

/// v in the frame's coordinates times the triangle's area: at a point.
Point<Rational> flow(const Frame<Rational>& f, const Point<Rational>& p) {
  const auto at = [&](const std::array<Rational, 3>& w) {
    return Rational(w[0] + p.a * (w[1] - w[0]) + p.b * (w[2] - w[0]));
  };
  return {-at(f.determinant.second), at(f.determinant.first)};
}

/// The sign of the trace of J, by v(1, 0) - v(0, 0), v(0, 1) - v(0, 0).
int trace_sign(const Frame<Rational>& f) {
  const Point<Rational> o = flow(f, {0, 0}), a = minus(flow(f, {1, 0}), o),
                        b = minus(flow(f, {0, 1}), o);
  return static_cast<int>(kernel::sign_of(Rational(a.a + b.b)));
}

/// A form of the frame of a triangle's corner 0 in that of another's.
std::array<Rational, 3> in_frame_of(const Field& field, u32 from, u32 to,
                                    const std::array<Rational, 3>& form) {
  const auto axis = [&](u32 t, u32 k) {
    return exact(field.position(3 * t + k)) - exact(field.position(3 * t));
  };
  const auto e = axis(from, 1), f = axis(from, 2);
  const Rational area = det(e, f);
  const auto moved = [&](const Plane<Rational>& w) {
    return Point<Rational>{det(w, f) / area, det(e, w) / area};
  };
  const auto product = [&](const Point<Rational>& x, const Point<Rational>& y) {
    return Rational(form[0] * x.a * y.a + form[1] * (x.a * y.b + x.b * y.a) + form[2] * x.b * y.b);
  };
  const Point<Rational> x = moved(axis(to, 1)), y = moved(axis(to, 2));
  return {product(x, x), product(x, y), product(y, y)};
}

}  // namespace

Trap::Trap(const Field& field, const Domain& domain, const ZeroSet& zeros,
           const SkeletonTrap& stated) {
  require(stated.zero < zeros.components.size(), "trap: no zero {}", stated.zero);
  const Component& zero = zeros.components[stated.zero];
  const Form form = {stated.form[0], stated.form[1], stated.form[2]};
  if (zero.stated.place == ZeroPlace::triangle) {
    require(zero.stated.kind == ZeroClass::sink || zero.stated.kind == ZeroClass::source,
            "trap: zero {} is neither source nor sink", stated.zero);
    require(stated.star.empty(), "trap of zero {}: a polygon inside a triangle", stated.zero);
    check_ellipse(field, stated.zero, zero.stated.triangle, form, kNone);
    return;
  }
  require(zero.stated.index != kNoIndex, "trap: zero {} has no index", stated.zero);
  if (zero.stated.place == ZeroPlace::edge) {
    require(stated.star.empty(), "trap of zero {}: a polygon inside a side", stated.zero);
    const u32 t = zero.place / 3, twin = domain.twin[zero.place];
    check_ellipse(field, stated.zero, t, form, zero.place);
    check_ellipse(field, stated.zero, twin / 3, in_frame_of(field, t, twin / 3, form), twin);
  } else {
    require(stated.form == std::array<double, 3>{}, "trap of zero {}: an ellipse at a vertex",
            stated.zero);
    check_star(field, domain, zero, stated);
  }
}

void Trap::check_ellipse(const Field& field, u32 zero, u32 triangle, const Form& form, u32 side) {
  Frame<Rational> f = make_frame<Rational>(field, 3 * triangle, false);
  if (ellipses_.empty()) backward_ = trace_sign(f) > 0;
  if (backward_) f = make_frame<Rational>(field, 3 * triangle, true);
  const Point<Rational> o = flow(f, {0, 0}), a = minus(flow(f, {1, 0}), o),
                        b = minus(flow(f, {0, 1}), o);
  const auto& [p, q, r] = form;
  const Rational area = p * r - q * q;
  require(p > 0 && area > 0, "trap of zero {}: not positive", zero);
  // A^T P + P A, A with the columns a, b.
  const Rational m00 = 2 * (a.a * p + a.b * q), m11 = 2 * (b.a * q + b.b * r),
                 m01 = a.a * q + a.b * r + b.a * p + b.b * q;
  require(m00 < 0 && m00 * m11 - m01 * m01 > 0, "trap of zero {}: flow leaves it", zero);
  // Then A has an inverse.
  const Rational d = cross(a, b);
  const Point<Rational> centre = {cross(b, o) / d, cross(o, a) / d};
  // n^T P^-1 n < lambda(z)^2 for the gradients n of the coordinates that are not 0 at z.
  const std::array<Rational, 3> at = {1 - centre.a - centre.b, centre.a, centre.b},
                                reach = {p + r - 2 * q, r, p};
  for (u32 k = 0; k < 3; ++k)
    require((side != kNone && previous_corner(side) % 3 == k) || reach[k] < area * at[k] * at[k],
            "trap of zero {}: not inside its triangle", zero);
  const auto nearly = [](const Rational& x) { return x.convert_to<double>(); };
  ellipses_.push_back({triangle,
                       centre,
                       form,
                       {nearly(centre.a), nearly(centre.b), nearly(p), nearly(q), nearly(r)}});
}

void Trap::check_part(const Field& field, const Part& part, u32 zero) const {
  const Frame<Rational> f = make_frame<Rational>(field, part.corner, backward_);
  require(trace_sign(f) < 0, "trap of zero {}: triangle {} does not contract", zero,
          part.corner / 3);
  const Point<Rational> step = minus(part.to, part.from);
  require(cross(part.from, part.to) > 0 && cross(step, flow(f, part.from)) > 0 &&
              cross(step, flow(f, part.to)) > 0,
          "trap of zero {}: flow leaves it in triangle {}", zero, part.corner / 3);
}

void Trap::check_star(const Field& field, const Domain& domain, const Component& zero,
                      const SkeletonTrap& stated) {
  const auto fan = domain.corners_of(zero.place);
  require(!stated.star.empty() && stated.star[0].b == 0,
          "trap of zero {}: does not begin on an edge", stated.zero);
  backward_ = trace_sign(make_frame<Rational>(
                  field, stated.star[0].corner < field.corners() ? stated.star[0].corner : fan[0],
                  false)) > 0;
  std::size_t turned = 0;  // corners that the polygon has left behind
  for (std::size_t i = 0; i < stated.star.size(); ++i) {
    const SkeletonPoint &p = stated.star[i], &q = stated.star[(i + 1) % stated.star.size()];
    require(p.corner < field.corners() && domain.fan[p.corner] == zero.place,
            "trap of zero {}: point {} is not at it", stated.zero, i);
    require(p.a > 0 && p.b >= 0 && Rational(p.a) + Rational(p.b) < 1,
            "trap of zero {}: point {} is not in its triangle", stated.zero, i);
    const bool stays = q.corner == p.corner && i + 1 < stated.star.size();
    const u32 following = domain.twin[previous_corner(p.corner)];
    require(stays || (q.corner == following && q.b == 0), "trap of zero {}: point {}: a gap",
            stated.zero, i);
    turned += !stays;
    const Part part{
        p.corner, {p.a, p.b}, stays ? Point<Rational>{q.a, q.b} : Point<Rational>{0, q.a}};
    check_part(field, part, stated.zero);
    auto& range = parts_of_.try_emplace(part.corner / 3, std::array{i, i}).first->second;
    range[1] = i + 1;
    parts_.push_back(part);
  }
  require(turned == fan.size(), "trap of zero {}: not once around", stated.zero);
}

std::size_t Trap::part_of(u32 corner, const Point<Rational>& p) const {
  const auto range = parts_of_.find(corner / 3);
  if (range == parts_of_.end()) return kNone;
  const auto begin = parts_.begin() + static_cast<std::ptrdiff_t>(range->second[0]),
             end = parts_.begin() + static_cast<std::ptrdiff_t>(range->second[1]);
  const Point<Rational> x = reframed(p, corner, begin->corner);
  const auto after =
      std::partition_point(begin, end, [&](const Part& part) { return cross(part.from, x) >= 0; });
  if (after == begin) return kNone;
  const Part& part = *(after - 1);
  const bool inside =
      cross(x, part.to) >= 0 && cross(minus(part.to, part.from), minus(x, part.from)) > 0;
  return inside ? static_cast<std::size_t>(&part - parts_.data()) : kNone;
}

bool Trap::holds(u32 corner, const Point<Rational>& p, const Point<Rational>& q) const {
  for (const Ellipse& e : ellipses_) {
    if (corner / 3 != e.triangle) continue;
    for (const auto& x : {p, q}) {
      const Point<Rational> y = minus(reframed(x, corner, 3 * e.triangle), e.centre);
      if (e.form[0] * y.a * y.a + 2 * e.form[1] * y.a * y.b + e.form[2] * y.b * y.b >= 1)
        return false;
    }
    return true;
  }
  const std::size_t part = part_of(corner, p);
  return part != kNone && part_of(corner, q) == part;
}

bool Trap::seems_to_hold(u32 corner, const Point<double>& p) const {
  for (const Ellipse& e : ellipses_) {
    if (corner / 3 != e.triangle) continue;
    const Point<double> x = reframed(p, corner, 3 * e.triangle);
    const double a = x.a - e.rounded[0], b = x.b - e.rounded[1];
    return e.rounded[2] * a * a + 2 * e.rounded[3] * a * b + e.rounded[4] * b * b < 0.9999;
  }
  const Point<Rational> x{p.a, p.b};
  return holds(corner, x, x);
}

}  // namespace crest::certify::skeleton
