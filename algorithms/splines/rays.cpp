// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/rays.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/splines/exact_rays.hpp"
#include "kernel/arithmetic/approximate.hpp"
#include "kernel/geometry/parallel.hpp"
#include "kernel/predicates/segment_zero.hpp"

namespace crest::splines {

using kernel::kUnitRoundoff;
using kernel::operator*;
using kernel::operator+;
using kernel::operator-;

const char* problem_of(const Ray& ray) {
  double length = 0, distance = 0;
  bool finite = true;
  for (std::size_t k = 0; k < 3; ++k) {
    length = std::fmax(length, std::fabs(ray.direction[k]));
    distance = std::fmax(distance, std::fabs(ray.origin[k]));
    finite = finite && std::isfinite(ray.direction[k]) && std::isfinite(ray.origin[k]);
  }
  if (finite && length == 0) return "its direction is 0; give dx,dy,dz other than 0,0,0";
  if (finite && distance < 1e250 && length > 1e-250 * std::fmax(1, distance)) return nullptr;
  return "is out of the range of doubles; give ox,oy,oz and dx,dy,dz of ordinary size";
}

namespace {

/// A ray in the lattice over doubles, or more bits, with what bounds their errors: a point at t is
/// off by at most 16 roundings of magnitude + t slope, along each axis.
template <class T>
struct LatticeRay {
  std::array<T, 3> origin, direction;
  double magnitude = 0, slope = 0;

  LatticeRay(const LatticeFrame& frame, const Ray& ray, double size) {
    for (std::size_t k = 0; k < 3; ++k) {
      T o(frame.shift()), d(0);
      double mo = size, md = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        T entry(frame.inverse()[k][j]);
        if constexpr (!std::is_same_v<T, double>) entry += T(frame.inverse_low()[k][j]);
        const T from_origin = T(ray.origin[j]) - T(frame.origin()[j]);
        o += entry * from_origin;
        d += entry * T(ray.direction[j]);
        mo += std::fabs(static_cast<double>(entry * from_origin));
        md += std::fabs(static_cast<double>(entry * T(ray.direction[j])));
      }
      origin[k] = o;
      direction[k] = d;
      magnitude = std::max(magnitude, mo);
      slope = std::max(slope, md);
    }
  }
  std::array<T, 3> at(T t, const Cube& cube) const {
    std::array<T, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = (origin[k] - T(2 * cube[k] + 1)) + t * direction[k];
    return p;
  }
};

/// Half the distance from 1 to the next long double.
constexpr double kFine = std::numeric_limits<long double>::epsilon() / 2;

double below(long double x) {
  const auto y = static_cast<double>(x);
  return static_cast<long double>(y) > x ? next_down(y) : y;
}
double above(long double x) {
  const auto y = static_cast<double>(x);
  return static_cast<long double>(y) < x ? next_up(y) : y;
}

}  // namespace

RayCounts& RayCounts::operator+=(const RayCounts& o) {
  cast += o.cast;
  hits += o.hits;
  tangent += o.tangent;
  climbed += o.climbed;
  cubes += o.cubes;
  tetrahedra += o.tetrahedra;
  return *this;
}

/// One ray on its way.
struct RayCaster::Walk {
  const RayCaster& caster;
  const Ray& ray;
  RayCounts& counts;
  LatticeRay<double> line;
  Vec3 inverse;                       ///< of the direction; 0 where that is 0
  std::array<double, 6> plane_slope;  ///< of x + y, x - y, x + z, x - z, y + z, y - z
  double from = 0, to = HUGE_VAL;
  double eta = 0, delta = 0;
  bool exactly = false;  ///< doubles do not carry this ray
  bool climbed = false;
  std::optional<ExactRay> exact_line;
  std::optional<std::array<Rational, 2>> exact_part;
  Hit hit;

  Walk(const RayCaster& c, const Ray& r, RayCounts& n)
      : caster(c), ray(r), counts(n), line(c.spline_.frame(), r, largest_side(c)) {
    enter();
  }

  static double largest_side(const RayCaster& c) {
    const Cube& n = c.spline_.cubes();
    return 2 * std::max({n[0], n[1], n[2]});
  }

  /// Clips to the domain and a bit more, and sets the bounds of errors.
  void enter() {
    constexpr double u = kUnitRoundoff;
    const double wider = 0x1p12 * u * line.magnitude;
    for (std::size_t k = 0; k < 3; ++k) {
      const double o = line.origin[k], d = line.direction[k];
      const double side = 2 * caster.spline_.cubes()[k];
      inverse[k] = d == 0 ? 0 : 1 / d;
      exactly |= !std::isfinite(inverse[k]) || !std::isfinite(o);
      if (d == 0) {
        if (o < -wider || o > side + wider) to = -1;
        continue;
      }
      const double s = (-wider - o) * inverse[k], e = (side + wider - o) * inverse[k];
      from = std::max(from, std::min(s, e));
      to = std::min(to, std::max(s, e));
    }
    const auto& d = line.direction;
    plane_slope = {d[0] + d[1], d[0] - d[1], d[0] + d[2], d[0] - d[2], d[1] + d[2], d[1] - d[2]};
    for (double& x : plane_slope) x = x == 0 ? HUGE_VAL : -1 / x;
    eta = 64 * u * (line.magnitude + to * line.slope);
    const ActiveCubes& active = caster.active_;
    delta = 64 * active.range() * eta + 64 * u * active.largest();
    if (!caster.spline_.exact()) delta += 0x1p-40 * caster.spline_.largest_sample();
    // Where the ray misses the wider box nothing needs a bound; beyond these products of two
    // coefficients overflow or lose digits.
    const bool misses = to < from && !exactly && std::isfinite(line.slope);
    if (!misses)
      exactly |= !(to < HUGE_VAL && eta <= wider && delta > 0 && delta <= active.margin() &&
                   active.largest() > 0x1p-400 && active.largest() < 0x1p400);
  }

  /// Rationals decide [a, b].
  bool climb(const Rational& a, const Rational& b) {
    if (!exact_line) {
      exact_line = caster.exact_->lift(ray);
      exact_part = caster.exact_->clip(*exact_line);
    }
    climbed = true;
    if (!exact_part) return false;
    const Rational& start = std::max(a, (*exact_part)[0]);
    const Rational& end = std::min(b, (*exact_part)[1]);
    // A point is an end of the neighbour's part, too, unless it is all of the ray in the domain.
    if (end < start || (end == start && (*exact_part)[0] != (*exact_part)[1])) return false;
    const auto found = caster.exact_->first_zero(*exact_line, start, end, counts);
    if (!found) return false;
    hit = *found;
    return true;
  }

  /// The whole ray by rationals, in parts of about a cube.
  bool climb_all() {
    exact_line = caster.exact_->lift(ray);
    exact_part = caster.exact_->clip(*exact_line);
    climbed = true;
    if (!exact_part) return false;
    const auto [start, end] = *exact_part;
    const int parts = static_cast<int>(largest_side(caster));
    Rational a = start;
    for (int i = 1; i <= parts; ++i) {
      const Rational b = start + (end - start) * Rational(i) / Rational(parts);
      if (climb(a, b)) return true;
      a = b;
    }
    return false;
  }

  bool visit(int level, const Cube& node, double a, double b);
  bool visit_cube(const Cube& cube, double a, double b);
  struct Segment {
    double a, b, b0, b1, b2;
  };
  struct FineNet;
  double bracket(const FineNet& fine, const Cube& cube, std::size_t t, double side, double at);
  bool settle(const Cube& cube, std::size_t t, const CubeCoefficients<double>& coefficients,
              const Segment& s);
};

/// The children of a node in their order along the ray; true: a hit.
bool RayCaster::Walk::visit(int level, const Cube& node, double a, double b) {
  const std::uint64_t word = caster.active_.word(level, node[0], node[1], node[2]);
  const double side = static_cast<double>(2 << (2 * level));
  std::array<int, 3> at, last;
  std::array<double, 3> next;
  const auto& [o, d, magnitude, slope] = line;
  // When it leaves child i along axis k. Parent and child compute the time of a plane by the same
  // operations, so that their intervals fit.
  const auto leaves = [&](std::size_t k) {
    const int plane = 4 * node[k] + at[k] + (d[k] > 0 ? 1 : 0);
    return d[k] == 0 ? HUGE_VAL : (side * plane - o[k]) * inverse[k];
  };
  for (std::size_t k = 0; k < 3; ++k) {
    last[k] = ((caster.spline_.cubes()[k] - 1) >> (2 * level)) - 4 * node[k];
    const double place = (o[k] + a * d[k]) / side - 4 * node[k];
    at[k] = static_cast<int>(std::clamp(place, 0.0, static_cast<double>(std::min(3, last[k]))));
    next[k] = leaves(k);
  }
  for (double t = a;;) {
    std::size_t k = next[1] < next[0] ? 1 : 0;
    if (next[2] < next[k]) k = 2;
    const double end = std::max(t, std::min(next[k], b));
    if (word >> ActiveCubes::bit(at[0], at[1], at[2]) & 1) {
      Cube child;
      for (std::size_t j = 0; j < 3; ++j) child[j] = 4 * node[j] + at[j];
      if (level == 0 ? visit_cube(child, t, end) : visit(level - 1, child, t, end)) return true;
    }
    if (next[k] >= b) return false;
    t = end;
    at[k] += d[k] > 0 ? 1 : -1;
    if (at[k] > last[k] || 4 * node[k] + at[k] < 0) {
      // Out of the domain, up to rounding: what is left is as near to the last cubes.
      at[k] = std::clamp(at[k], 0, last[k]);
      next[k] = HUGE_VAL;
    } else if (at[k] < 0 || at[k] > 3) {
      return false;
    } else {
      next[k] = leaves(k);
    }
  }
}

bool RayCaster::Walk::visit_cube(const Cube& cube, double a, double b) {
  ++counts.cubes;
  const auto coefficients = cube_coefficients(caster.spline_.stencil<double>(cube));
  std::array<double, 3> u;
  for (std::size_t k = 0; k < 3; ++k) u[k] = line.origin[k] - (2 * cube[k] + 1);
  const std::array<double, 6> planes = {u[0] + u[1], u[0] - u[1], u[0] + u[2],
                                        u[0] - u[2], u[1] + u[2], u[1] - u[2]};
  std::array<double, 8> cuts;
  std::size_t count = 0;
  cuts[count++] = a;
  for (std::size_t i = 0; i < 6; ++i) {
    const double t = planes[i] * plane_slope[i];
    if (!(t > a && t < b)) continue;
    std::size_t k = count++;
    for (; cuts[k - 1] > t; --k) cuts[k] = cuts[k - 1];
    cuts[k] = t;
  }
  cuts[count] = b;
  for (std::size_t i = 0; i < count; ++i) {
    const double s = cuts[i], e = cuts[i + 1];
    const auto middle = line.at(0.5 * (s + e), cube);
    const std::size_t t = locate(middle[0], middle[1], middle[2]);
    auto net = tetrahedron_net(coefficients, t);
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (double& x : net.c) {
      x -= caster.level_;
      low = x < low ? x : low;
      high = x > high ? x : high;
    }
    if (low > delta || high < -delta) continue;
    ++counts.tetrahedra;
    const auto start = barycentric(t, line.at(s, cube)), end = barycentric(t, line.at(e, cube));
    const auto from_start = kernel::blossom_step(net, start);
    const Segment segment{s, e, kernel::value_at(from_start, start),
                          kernel::value_at(from_start, end), kernel::value_at(net, end)};
    const auto zero = kernel::triage_segment_zero(segment.b0, segment.b1, segment.b2, delta);
    if (zero && !*zero) continue;
    if (zero && settle(cube, t, coefficients, segment)) return true;
    return climb(Rational(a), Rational(b));
  }
  return false;
}

/// The segment's tetrahedron in long doubles, less c: what its coefficients may be off by.
struct RayCaster::Walk::FineNet {
  QuadraticNet<long double> net;
  double largest = 0, error = 0;

  FineNet(const RayCaster& caster, const Cube& cube, std::size_t t,
          const CubeCoefficients<double>& coefficients) {
    double samples = 0;
    if (caster.spline_.exact()) {
      for (std::size_t i = 0; i < 10; ++i) net.c[i] = coefficients[kSlots[t][i]];
    } else {
      const auto f = caster.spline_.stencil<long double>(cube);
      for (const long double x : f) samples = std::max(samples, std::fabs(static_cast<double>(x)));
      net = tetrahedron_net(cube_coefficients(f), t);
    }
    for (long double& c : net.c) {
      c -= static_cast<long double>(caster.level_);
      largest = std::max(largest, std::fabs(static_cast<double>(c)));
    }
    error = 32 * kFine * largest + 64 * kFine * samples;
  }
};

/// Where a fall through zero near `at` is, in hit.t_lo and hit.t_hi; 0 where long doubles do not
/// tell, else the speed of the fall.
double RayCaster::Walk::bracket(const FineNet& fine, const Cube& cube, std::size_t t, double side,
                                double at) {
  const LatticeRay<long double> ray_there(caster.spline_.frame(), ray, largest_side(caster));
  double speed = 0;
  for (const long double x : ray_there.direction) speed += std::fabs(static_cast<double>(x));
  // Newton's step from `at`, then one more if the first is not yet as small as the errors.
  for (int step = 0; step < 2; ++step) {
    const auto r = kernel::value_and_gradient_at(fine.net, barycentric(t, ray_there.at(at, cube)));
    const auto g = gradient(t, r.gradient);
    long double slope = 0;
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      slope += g[k] * ray_there.direction[k];
      length += std::fabs(static_cast<double>(g[k]));
    }
    const double fall = -side * static_cast<double>(slope);
    if (!(fall > 0)) return 0;
    const double off =
        16 * kFine * (ray_there.magnitude + at * ray_there.slope) * length + fine.error;
    const long double move = r.value / slope, better = static_cast<long double>(at) - move;
    double error = 1.25 * off / fall;
    const double reach = std::max(std::fabs(static_cast<double>(move)), error);
    // The quadratic term: a barycentric coordinate changes by at most `speed`.
    if (!(512 * speed * speed * fine.largest * reach * reach <= off)) {
      at = static_cast<double>(better);
      continue;
    }
    error += 4 * kFine * std::fabs(at);
    hit.t = static_cast<double>(better);
    hit.t_lo = below(better - static_cast<long double>(error));
    hit.t_hi = above(better + static_cast<long double>(error));
    double widest = hit.t_lo;
    for (int i = 0; i < 4; ++i) widest = next_up(widest);
    return hit.t_hi <= widest ? fall : 0;
  }
  return 0;
}

/// Brackets the first zero of a segment that has one; false: more bits are needed.
bool RayCaster::Walk::settle(const Cube& cube, std::size_t t,
                             const CubeCoefficients<double>& coefficients, const Segment& s) {
  const double side = s.b0 < 0 ? -1 : 1;
  const double h = side * (s.b0 - s.b1), q = side * (s.b0 - 2 * s.b1 + s.b2);
  const double root = std::sqrt(std::max(0.0, h * h - q * side * s.b0));
  const double share = h > 0 ? side * s.b0 / (h + root) : (h - root) / q;
  const FineNet fine(caster, cube, t, coefficients);
  const double fall = bracket(fine, cube, t, side, s.a + share * (s.b - s.a));
  if (!(fall > 0)) return false;
  // Up to `before` there is no zero, from there to `after` the tetrahedron is certain.
  const double near = 16 * delta / fall, before = hit.t_lo - near, after = hit.t_hi + near;
  const auto until = [&](double x) {
    const double y = (x - s.a) / (s.b - s.a), z = 1 - y;
    const double c1 = z * s.b0 + y * s.b1;
    return std::array<double, 2>{c1, z * c1 + y * (z * s.b1 + y * s.b2)};
  };
  const auto [c1, c2] = until(before);
  const auto none = kernel::triage_segment_zero(s.b0, c1, c2, 2 * delta);
  if (!(before > s.a) || !none || *none || !(side * until(after)[1] < -2 * delta)) return false;
  for (const double x : {before, after})
    for (const double l : barycentric(t, line.at(x, cube)))
      if (!(l > 4 * eta)) return false;
  hit.hit = true;
  hit.cube = cube;
  hit.tetrahedron = static_cast<std::uint8_t>(t);
  return true;
}

RayCaster::RayCaster(const QuadraticSpline& spline, double c)
    : spline_(spline),
      level_(c),
      active_(spline, c),
      exact_(std::make_unique<const ExactRays>(spline, c)) {}

RayCaster::~RayCaster() = default;

Hit RayCaster::cast(const Ray& ray, RayCounts& counts) const {
  ++counts.cast;
  Walk walk(*this, ray, counts);
  const bool found = walk.exactly ? walk.climb_all()
                     : walk.from <= walk.to
                         ? walk.visit(active_.levels() - 1, Cube{}, walk.from, walk.to)
                         : false;
  counts.climbed += walk.climbed;
  Hit& hit = walk.hit;
  hit.climbed = walk.climbed;
  if (!found) return {.climbed = walk.climbed};
  ++counts.hits;
  counts.tangent += hit.tangent;
  hit.place = ray.origin + hit.t * ray.direction;
  const auto net =
      tetrahedron_net(cube_coefficients(spline_.stencil<double>(hit.cube)), hit.tetrahedron);
  const auto at = barycentric(hit.tetrahedron, walk.line.at(hit.t, hit.cube));
  const auto r = kernel::value_and_gradient_at(net, at);
  hit.gradient = spline_.frame().gradient_to_world(gradient(hit.tetrahedron, r.gradient));
  return hit;
}

RayCounts RayCaster::cast(std::span<const Ray> rays, std::span<Hit> hits) const {
  return kernel::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, rays.size(), 256), RayCounts{},
      [&](const auto& range, RayCounts counts) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) hits[i] = cast(rays[i], counts);
        return counts;
      },
      [](RayCounts a, const RayCounts& b) { return a += b; });
}

}  // namespace crest::splines
