// SPDX-License-Identifier: GPL-3.0-or-later
// Sectors around a zero on a vertex or edge, in rationals.
#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/skeleton/zeros.hpp"

namespace crest::certify::skeleton {
namespace {

using Exact = Plane<Rational>;

/// Between two neighbouring directions around the zero v is linear: det(d, v) is quadratic.
struct Cone {
  u32 exit;        ///< the side across
  Exact from, to;  ///< directions to its tail and head
  Exact v_from, v_to;
};

/// On the circle around the zero: a ray, and the sign of det(d, v) after it.
struct Event {
  Ray ray;
  int after;
};

int as_int(const Rational& x) {
  return static_cast<int>(kernel::sign_of(x));
}

std::vector<Cone> cones_of(const Field& field, const Domain& domain, const Component& component) {
  std::vector<Cone> cones;
  const Exact z = zero_point(field, domain, component);
  const auto add = [&](u32 exit) {
    const u32 head = next_corner(exit);
    cones.push_back({exit, exact(field.position(exit)) - z, exact(field.position(head)) - z,
                     exact(field.vector(exit)), exact(field.vector(head))});
  };
  if (component.stated.place == ZeroPlace::vertex) {
    for (const u32 c : domain.corners_of(component.place)) add(next_corner(c));
  } else {
    for (const u32 side : {component.place, domain.twin[component.place]}) {
      add(next_corner(side));
      add(previous_corner(side));
    }
  }
  return cones;
}

/// Roots of q(s) = det(d(s), v(s)) on (0, 1), d, v linear, and whether they run outwards.
class ConeRoots {
 public:
  explicit ConeRoots(const Cone& cone)
      : q0_(det(cone.from, cone.v_from)),
        q1_(det(cone.from, cone.v_to) + det(cone.to, cone.v_from)),  // twice the middle one
        q2_(det(cone.to, cone.v_to)),
        m0_(det(cone.v_from, cone.to) + det(cone.from, cone.v_from)),
        m1_(det(cone.v_to, cone.to) + det(cone.from, cone.v_to)) {}

  bool vanishes() const { return q0_ == 0 && q1_ == 0 && q2_ == 0; }

  /// Events inside the cone. `sign` is the one of q next to s = 0.
  void append(u32 exit, std::vector<Event>& events, int sign) const {
    const int s0 = as_int(q0_), s2 = as_int(q2_);
    if (s0 * s2 < 0) return events.push_back({{exit, 0, out(0, 1, s0)}, s2});
    const Rational discriminant = q1_ * q1_ - 4 * q0_ * q2_;
    if (s0 * s2 > 0) {
      // Both roots inside, or none.
      if (as_int(q1_) * s0 >= 0 || discriminant < 0) return;
      if (discriminant == 0) return events.push_back({{exit, 0, out(0, 1, s0)}, s0});
      events.push_back({{exit, 0, out(0, 2, s0)}, -s0});
      events.push_back({{exit, 1, out(1, 2, s0)}, s0});
      return;
    }
    // A root at an end: one more inside iff q1 and the other end have opposite signs.
    const int other = s0 + s2;
    if (other != 0 && as_int(q1_) * other < 0)
      events.push_back({{exit, 0, out(0, 1, sign)}, -sign});
  }

  /// Sign of q next to s = 0.
  int first_sign() const { return q0_ != 0 ? as_int(q0_) : q1_ != 0 ? as_int(q1_) : as_int(q2_); }
  /// Of d . v at s = 0, where det(d, v) = 0.
  bool out_at_first() const { return m0_ > 0; }

 private:
  /// v = m d / det at a root, m linear: its sign at root i of n; `before` is the sign of q before
  /// the first one.
  bool out(int i, int n, int before) const {
    if (m0_ >= 0 && m1_ >= 0) return true;
    if (m0_ <= 0 && m1_ <= 0) return false;
    const Rational s = m0_ / (m0_ - m1_), r = 1 - s;  // v is not d there: q(s) is not zero
    const int at = as_int(q0_ * r * r + q1_ * r * s + q2_ * s * s);
    const bool first = m0_ > 0, last = m1_ > 0;
    if (n == 1 && (q0_ != 0 && q2_ != 0) && as_int(q0_) == as_int(q2_))  // a double root
      return double_root_after(s) ? last : first;
    if (n == 1) return at == before ? last : first;
    if (at != before) return i == 0 ? first : last;
    return double_root_after(s) ? last : first;
  }
  /// The parabola's vertex lies after s.
  bool double_root_after(const Rational& s) const {
    const Rational bend = q0_ - q1_ + q2_;  // slope 2 bend s + q1 - 2 q0
    return as_int(2 * bend * s + q1_ - 2 * q0_) * as_int(bend) < 0;
  }

  Rational q0_, q1_, q2_, m0_, m1_;
};

std::vector<Event> events_around(const std::vector<Cone>& cones) {
  std::vector<Event> events;
  for (const Cone& cone : cones) {
    const ConeRoots roots(cone);
    const int first = roots.vanishes() ? 0 : roots.first_sign();
    if (det(cone.from, cone.v_from) == 0)
      events.push_back({{cone.exit, 2, roots.out_at_first()}, first});
    if (!roots.vanishes()) roots.append(cone.exit, events, first);
  }
  return events;
}

}  // namespace

Plane<Rational> zero_point(const Field& field, const Domain& domain, const Component& component) {
  const u32 place = component.place;
  if (component.stated.place == ZeroPlace::vertex)
    return exact(field.position(domain.corners_of(place)[0]));
  if (component.stated.place == ZeroPlace::edge) {
    const Exact p = exact(field.position(place)), q = exact(field.position(next_corner(place)));
    const Exact a = exact(field.vector(place)), b = exact(field.vector(next_corner(place)));
    const Rational t = a.x != b.x ? a.x / (a.x - b.x) : a.y / (a.y - b.y);
    return p + t * (q - p);
  }
  require(component.stated.place == ZeroPlace::triangle, "a zero that is no point");
  const u32 c = 3 * component.stated.triangle;
  Exact sum{0, 0};
  Rational weights = 0;
  for (const u32 k : {c, c + 1, c + 2}) {
    const Rational w =
        det(exact(field.vector(next_corner(k))), exact(field.vector(previous_corner(k))));
    weights += w;
    sum = sum + w * exact(field.position(k));
  }
  return Rational(1 / weights) * sum;
}

void count_sectors(const Field& field, const Domain& domain, Component& component) {
  const std::vector<Event> events = events_around(cones_of(field, domain, component));
  SkeletonZero& zero = component.stated;
  zero.hyperbolic = zero.elliptic = 0;
  std::vector<Ray>& rays = component.rays;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const Event &ray = events[i], &next = events[(i + 1) % events.size()];
    if (ray.after == 0 || ray.ray.out == next.ray.out) continue;
    // Turning towards the ray that goes out.
    const bool hyperbolic = (ray.after > 0) == next.ray.out;
    ++(hyperbolic ? zero.hyperbolic : zero.elliptic);
    if (hyperbolic) rays.insert(rays.end(), {ray.ray, next.ray});
  }
  std::sort(rays.begin(), rays.end());
  rays.erase(std::unique(rays.begin(), rays.end()), rays.end());
}

}  // namespace crest::certify::skeleton
