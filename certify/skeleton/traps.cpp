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

}  // namespace

Trap::Trap(const Field& field, const Domain& domain, const ZeroSet& zeros,
           const SkeletonTrap& stated) {
  require(stated.zero < zeros.components.size(), "trap: no zero {}", stated.zero);
  const Component& zero = zeros.components[stated.zero];
  if (zero.stated.place == ZeroPlace::triangle) {
    require(zero.stated.kind == ZeroClass::sink || zero.stated.kind == ZeroClass::source,
            "trap: zero {} is neither source nor sink", stated.zero);
    require(stated.star.empty(), "trap of zero {}: a polygon inside a triangle", stated.zero);
    check_ellipse(field, stated, zero.stated.triangle);
  } else {
    require(zero.stated.place == ZeroPlace::vertex && zero.stated.index != kNoIndex,
            "trap: zero {} is on no inner vertex", stated.zero);
    require(stated.form == std::array<double, 3>{}, "trap of zero {}: an ellipse at a vertex",
            stated.zero);
    check_star(field, domain, zero, stated);
  }
}

void Trap::check_ellipse(const Field& field, const SkeletonTrap& stated, u32 triangle) {
  triangle_ = triangle;
  Frame<Rational> f = make_frame<Rational>(field, 3 * triangle, false);
  backward_ = trace_sign(f) > 0;
  if (backward_) f = make_frame<Rational>(field, 3 * triangle, true);
  const Point<Rational> o = flow(f, {0, 0}), a = minus(flow(f, {1, 0}), o),
                        b = minus(flow(f, {0, 1}), o);
  const Rational d = cross(a, b);
  centre_ = {cross(b, o) / d, cross(o, a) / d};
  const Rational p = stated.form[0], q = stated.form[1], r = stated.form[2];
  form_ = {p, q, r};
  const Rational area = p * r - q * q;
  require(p > 0 && area > 0, "trap of zero {}: not positive", stated.zero);
  // A^T P + P A, A with the columns a, b.
  const Rational m00 = 2 * (a.a * p + a.b * q), m11 = 2 * (b.a * q + b.b * r),
                 m01 = a.a * q + a.b * r + b.a * p + b.b * q;
  require(m00 < 0 && m00 * m11 - m01 * m01 > 0, "trap of zero {}: flow leaves it", stated.zero);
  // n^T P^-1 n < lambda(z)^2 for the gradients n of the three coordinates.
  const Rational l1 = centre_.a, l2 = centre_.b, l0 = 1 - l1 - l2;
  require(p + r - 2 * q < area * l0 * l0 && r < area * l1 * l1 && p < area * l2 * l2,
          "trap of zero {}: not inside its triangle", stated.zero);
  rounded_ = {centre_.a.convert_to<double>(), centre_.b.convert_to<double>(), stated.form[0],
              stated.form[1], stated.form[2]};
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
  if (triangle_ != kNone) {
    if (corner / 3 != triangle_) return false;
    for (const auto& x : {p, q}) {
      const Point<Rational> y = minus(reframed(x, corner, 3 * triangle_), centre_);
      if (form_[0] * y.a * y.a + 2 * form_[1] * y.a * y.b + form_[2] * y.b * y.b >= 1) return false;
    }
    return true;
  }
  const std::size_t part = part_of(corner, p);
  return part != kNone && part_of(corner, q) == part;
}

bool Trap::seems_to_hold(u32 corner, const Point<double>& p) const {
  if (triangle_ == kNone) {
    const Point<Rational> x{p.a, p.b};
    return holds(corner, x, x);
  }
  if (corner / 3 != triangle_) return false;
  const Point<double> x = reframed(p, corner, 3 * triangle_);
  const double a = x.a - rounded_[0], b = x.b - rounded_[1];
  return rounded_[2] * a * a + 2 * rounded_[3] * a * b + rounded_[4] * b * b < 0.9999;
}

}  // namespace crest::certify::skeleton
