// SPDX-License-Identifier: GPL-3.0-or-later
// Zeros, indices (Simulation of Simplicity), switch points, loops: rationals throughout.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "kernel/arithmetic/rational.hpp"
#include "tests/certify_skeleton/reference_skeleton.hpp"

namespace crest::tests {
namespace {

using namespace certify;
using Q = kernel::Rational;
using u32 = std::uint32_t;
struct Vec {
  Q x, y;
};
Vec operator-(const Vec& a, const Vec& b) {
  return {a.x - b.x, a.y - b.y};
}
Q cross(const Vec& a, const Vec& b) {
  return a.x * b.y - a.y * b.x;
}
Q inner(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y;
}
int sgn(const Q& x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}
u32 nx(u32 c) {
  return c % 3 == 2 ? c - 2 : c + 1;
}
u32 pv(u32 c) {
  return c % 3 == 0 ? c + 2 : c - 1;
}

/// Sign of det(v_i, v_j) under Simulation of Simplicity; i, j: vertex numbers.
int sos(u32 i, const Vec& a, u32 j, const Vec& b) {
  if (i > j) return -sos(j, b, i, a);
  for (const Q& term : {cross(a, b), Q(-b.x), b.y, a.x})
    if (term != 0) return sgn(term);
  return 1;
}

struct Mesh {
  const PlaneField& f;
  std::vector<int> live;
  std::vector<u32> twin;
  std::vector<bool> beside_dead;
  std::vector<u32> fan;  ///< the least corner of the fan

  u32 v(u32 c) const { return f.triangles[c / 3][c % 3]; }
  Vec p(u32 c) const { return {f.positions[v(c)][0], f.positions[v(c)][1]}; }
  Vec w(u32 c) const { return {f.vectors[v(c)][0], f.vectors[v(c)][1]}; }
  bool nil(u32 c) const { return w(c).x == 0 && w(c).y == 0; }
  u32 corners() const { return static_cast<u32>(3 * f.triangles.size()); }
  bool edge_zero(u32 c) const {
    return !nil(c) && !nil(nx(c)) && cross(w(c), w(nx(c))) == 0 && inner(w(c), w(nx(c))) < 0;
  }
};

Mesh make_mesh(const PlaneField& f) {
  Mesh m{f, {}, {}, {}, {}};
  const u32 n = m.corners();
  std::map<std::pair<u32, u32>, u32> sides;
  for (u32 c = 0; c < n; ++c) sides[{m.v(c), m.v(nx(c))}] = c;
  m.live.assign(f.triangles.size(), 0);
  for (u32 c = 0; c < n; ++c)
    if (!m.nil(c)) m.live[c / 3] = 1;
  m.twin.assign(n, kNotStated);
  m.beside_dead.assign(n, false);
  for (u32 c = 0; c < n; ++c) {
    const auto other = sides.find({m.v(nx(c)), m.v(c)});
    if (other == sides.end()) continue;
    if (m.live[other->second / 3] == 0) m.beside_dead[c] = true;
    if (!(m.nil(c) && m.nil(nx(c)))) m.twin[c] = other->second;
  }
  m.fan.resize(n);
  std::iota(m.fan.begin(), m.fan.end(), 0U);
  for (bool changed = true; changed;) {  // the least name spreads
    changed = false;
    for (u32 c = 0; c < n; ++c) {
      if (m.twin[c] == kNotStated) continue;
      for (const auto& [a, b] : {std::pair{c, nx(m.twin[c])}, std::pair{nx(c), m.twin[c]}}) {
        const u32 least = std::min(m.fan[a], m.fan[b]);
        changed = changed || m.fan[a] != least || m.fan[b] != least;
        m.fan[a] = m.fan[b] = least;
      }
    }
  }
  return m;
}

struct PointSet {
  std::set<std::tuple<int, u32>> places;  ///< 0 triangle, 1 edge, 2 fan
  std::set<u32> triangles;
  bool boundary = false, region = false;
};

/// Zeros of one closed triangle.
PointSet zeros_of(const Mesh& m, u32 t) {
  PointSet s;
  for (u32 c = 3 * t; c < 3 * t + 3; ++c) {
    if (m.nil(c)) {
      s.places.insert({2, m.fan[c]});
      for (u32 d = 0; d < m.corners(); ++d)
        if (m.live[d / 3] != 0 && m.fan[d] == m.fan[c])
          s.boundary = s.boundary || m.twin[d] == kNotStated || m.twin[pv(d)] == kNotStated;
      if (m.nil(nx(c)) && m.beside_dead[c]) s.region = true;
    }
    if (m.edge_zero(c)) {
      s.places.insert({1, std::min(c, m.twin[c])});
      s.boundary = s.boundary || m.twin[c] == kNotStated;
    }
  }
  const Vec a = m.w(3 * t), b = m.w(3 * t + 1), c = m.w(3 * t + 2);
  const int s0 = sgn(cross(a, b)), s1 = sgn(cross(b, c)), s2 = sgn(cross(c, a));
  if (s0 != 0 && s0 == s1 && s1 == s2) s.places.insert({0, t});
  if (!s.places.empty()) s.triangles.insert(t);
  return s;
}

std::vector<PointSet> components(const Mesh& m) {
  std::vector<PointSet> all;
  for (u32 t = 0; t < m.f.triangles.size(); ++t) {
    if (m.live[t] == 0) continue;
    PointSet s = zeros_of(m, t);
    if (s.places.empty()) continue;
    std::vector<PointSet> apart;
    for (PointSet& o : all) {
      const bool meets = std::any_of(s.places.begin(), s.places.end(),
                                     [&](const auto& p) { return o.places.count(p) != 0; });
      if (!meets) {
        apart.push_back(std::move(o));
        continue;
      }
      s.places.merge(o.places);
      s.triangles.merge(o.triangles);
      s.boundary = s.boundary || o.boundary;
      s.region = s.region || o.region;
    }
    apart.push_back(std::move(s));
    all = std::move(apart);
  }
  std::sort(all.begin(), all.end(), [](const PointSet& a, const PointSet& b) {
    return *a.triangles.begin() < *b.triangles.begin();
  });
  return all;
}

void classify(const Mesh& m, u32 t, SkeletonZero& z) {
  const Vec e = m.p(3 * t + 1) - m.p(3 * t), f = m.p(3 * t + 2) - m.p(3 * t),
            a = m.w(3 * t + 1) - m.w(3 * t), b = m.w(3 * t + 2) - m.w(3 * t);
  const Q area = cross(e, f), trace = (cross(a, f) + cross(e, b)) / area, det = cross(a, b) / area;
  z.kind = det < 0     ? ZeroClass::saddle
           : trace > 0 ? ZeroClass::source
           : trace < 0 ? ZeroClass::sink
                       : ZeroClass::centre;
  z.focus = det > 0 && trace != 0 && trace * trace < 4 * det;
}

/// Sectors by sampling the circle in rational directions between all sign changes would need the
/// rays; here 512 directions a cone decide, which is enough for small integers.
/// Returns how many rays bound hyperbolic sectors: outwards, inwards.
std::array<int, 2> sectors(const Mesh& m, const PointSet& s, SkeletonZero& z) {
  struct Ray {
    bool out;
    int after;
    bool bounds = false;
  };
  std::vector<Ray> rays;
  const auto [kind, name] = *s.places.begin();
  std::vector<std::array<u32, 2>> cones;  // tail and head corners of the sides across
  Vec at;
  if (kind == 2) {
    u32 c = name;
    at = m.p(c);
    do {
      cones.push_back({nx(c), pv(c)});
      c = m.twin[pv(c)];
    } while (c != name);
  } else {
    const Vec a = m.w(name), b = m.w(nx(name)), p = m.p(name), q = m.p(nx(name));
    const Q t = a.x != b.x ? Q(a.x / (a.x - b.x)) : Q(a.y / (a.y - b.y));
    at = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
    for (const u32 c : {name, m.twin[name]}) {
      cones.push_back({nx(c), pv(c)});
      cones.push_back({pv(c), c});
    }
  }
  constexpr int kSteps = 512;
  std::vector<std::array<int, 2>> samples;  // sign of det(d, v), of d . v
  for (const auto& [from, to] : cones) {
    const Vec d0 = m.p(from) - at, d1 = m.p(to) - at, v0 = m.w(from), v1 = m.w(to);
    std::vector<Q> steps;
    for (int k = 0; k < kSteps; ++k) steps.push_back(Q(k) / kSteps);
    // No sign changes at a double root: it is a sample.
    const Q q0 = cross(d0, v0), q1 = cross(d0, v1) + cross(d1, v0), q2 = cross(d1, v1),
            bend = q0 - q1 + q2;
    if (bend != 0 && q1 * q1 == 4 * q0 * q2) steps.push_back((2 * q0 - q1) / (2 * bend));
    std::sort(steps.begin(), steps.end());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    for (const Q& r : steps) {
      if (r < 0 || r >= 1) continue;
      const Vec d{d0.x + r * (d1.x - d0.x), d0.y + r * (d1.y - d0.y)},
          v{v0.x + r * (v1.x - v0.x), v0.y + r * (v1.y - v0.y)};
      samples.push_back({sgn(cross(d, v)), sgn(inner(d, v))});
    }
  }
  // A ray where the sign changes, and where it is zero; in or out by the neighbours' d . v.
  const std::size_t n = samples.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto& here = samples[i];
    const auto& next = samples[(i + 1) % n];
    if (here[0] == 0) rays.push_back({here[1] > 0, next[0]});
    if (here[0] * next[0] < 0) rays.push_back({here[1] > 0, next[0]});
  }
  z.hyperbolic = z.elliptic = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    Ray &ray = rays[i], &next = rays[(i + 1) % rays.size()];
    if (ray.after == 0 || ray.out == next.out) continue;
    if ((ray.after > 0) == next.out) {
      ++z.hyperbolic;
      ray.bounds = next.bounds = true;
    } else {
      ++z.elliptic;
    }
  }
  std::array<int, 2> count{};
  for (const Ray& ray : rays) count[ray.out ? 0 : 1] += ray.bounds;
  return count;
}

SkeletonZero zero_record(const Mesh& m, const PointSet& s, std::array<int, 2>& rays) {
  SkeletonZero z;
  z.triangle = *s.triangles.begin();
  const int kind = std::get<0>(*s.places.begin());
  z.place = s.region              ? ZeroPlace::region
            : s.places.size() > 1 ? ZeroPlace::line
            : kind == 0           ? ZeroPlace::triangle
            : kind == 1           ? ZeroPlace::edge
                                  : ZeroPlace::vertex;
  z.kind = ZeroClass::higher_order;
  if (z.place == ZeroPlace::triangle) classify(m, z.triangle, z);
  if (s.boundary || z.place == ZeroPlace::line || z.place == ZeroPlace::region) return z;
  z.index = 0;
  for (const u32 t : s.triangles) {
    int signs[3];
    for (u32 k = 0; k < 3; ++k) {
      const u32 c = 3 * t + k;
      signs[k] = sos(m.v(c), m.w(c), m.v(nx(c)), m.w(nx(c)));
    }
    if (signs[0] == signs[1] && signs[1] == signs[2]) z.index += signs[0];
  }
  if (z.place != ZeroPlace::triangle) rays = sectors(m, s, z);
  if (z.kind == ZeroClass::saddle) rays = {2, 2};
  return z;
}

double angle_between(const Vec& a, const Vec& b) {
  return std::atan2(cross(a, b).convert_to<double>(), inner(a, b).convert_to<double>());
}

/// The flattened signs of a loop as in the definition, then runs.
void loop_record(const Mesh& m, const std::vector<u32>& sides, SkeletonCertificate& c) {
  SkeletonLoop loop;
  loop.side = sides[0];
  double winding = 0, turning = 0;
  std::vector<int> normal;
  std::vector<bool> zero_at;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const u32 s = sides[i], next = sides[(i + 1) % sides.size()];
    const Vec e = m.p(nx(s)) - m.p(s), f = m.p(nx(next)) - m.p(next);
    loop.zero |= m.nil(s) || m.edge_zero(s);
    for (const u32 k : {s, nx(s)}) {
      normal.push_back(sgn(cross(e, m.w(k))));
      zero_at.push_back(m.nil(k));
    }
    winding += angle_between(m.w(s), m.w(nx(s)));
    turning += angle_between(e, f);
  }
  const std::size_t n = normal.size();
  std::vector<int> regions;
  for (std::size_t i = 0; i < n; ++i) {
    if (normal[i] == 0) continue;
    std::size_t j = i + 1;
    bool zero = false;
    for (; normal[j % n] == 0 && j < i + n; ++j)
      zero = zero || zero_at[j % n] || m.edge_zero(sides[j % n / 2]);
    const u32 side = sides[i / 2];
    if (j == i + 1 && i % 2 == 0 && m.edge_zero(side)) zero = true;
    const int after = normal[j % n];
    if (zero || after == normal[i]) continue;
    SkeletonSwitch found{side, 0, 0};
    const auto tangent = [&](std::size_t k) {
      const u32 s = sides[k % n / 2];
      return sgn(inner(m.p(nx(s)) - m.p(s), m.w(k % 2 == 0 ? s : nx(s))));
    };
    if (j > i + 1) {
      found.place = 2;
      found.inside = tangent(i + 1) == after;
    } else if (i % 2 == 0) {
      const Vec e = m.p(nx(side)) - m.p(side), a = m.w(side), b = m.w(nx(side));
      const Q r = cross(e, a) / (cross(e, a) - cross(e, b));
      found.inside = sgn(inner(e, a) + r * (inner(e, b) - inner(e, a))) == after;
    } else {
      const u32 next = sides[(i / 2 + 1) % sides.size()];
      found.place = 1;
      found.inside = cross(m.p(nx(side)) - m.p(side), m.p(nx(next)) - m.p(next)) < 0;
    }
    c.switches.push_back(found);
    if (loop.zero == 0) ++(found.inside != 0 ? loop.interior : loop.exterior);
    regions.push_back(after);
  }
  if (loop.zero == 0) {
    if (regions.empty())
      regions.push_back(*std::find_if(normal.begin(), normal.end(), [](int s) { return s != 0; }));
    for (const int s : regions) ++(s > 0 ? loop.inflow : loop.outflow);
    loop.winding = static_cast<int>(std::lround(winding / (2 * M_PI)));
    loop.turning = static_cast<int>(std::lround(turning / (2 * M_PI)));
  }
  c.loops.push_back(loop);
}

void add_open(SkeletonCertificate& c, SkeletonOrigin origin, std::size_t from,
              std::uint8_t backward, int count) {
  SkeletonSeparatrix line;
  line.origin = origin;
  line.from = static_cast<u32>(from);
  line.backward = backward;
  line.reason = OpenReason::budget;
  for (int i = 0; i < count; ++i) c.separatrices.push_back(line);
}

}  // namespace

SkeletonCertificate reference_points(const PlaneField& field) {
  const Mesh m = make_mesh(field);
  SkeletonCertificate c;
  c.positions = field.positions;
  c.triangles = field.triangles;
  c.vectors = field.vectors;
  for (const PointSet& s : components(m)) {
    std::array<int, 2> rays{};
    c.zeros.push_back(zero_record(m, s, rays));
    for (const std::uint8_t backward : {std::uint8_t{0}, std::uint8_t{1}})
      add_open(c, SkeletonOrigin::zero, c.zeros.size() - 1, backward, rays[backward]);
    if (c.zeros.back().index != kNoIndex) c.index_sum += c.zeros.back().index;
  }
  std::set<u32> seen;
  for (u32 s = 0; s < m.corners(); ++s) {
    if (m.live[s / 3] == 0 || m.twin[s] != kNotStated || seen.count(s) != 0) continue;
    std::vector<u32> sides;
    for (u32 k = s; seen.insert(k).second;) {
      sides.push_back(k);
      for (k = nx(k); m.twin[k] != kNotStated;) k = nx(m.twin[k]);
    }
    loop_record(m, sides, c);
  }
  for (std::size_t i = 0; i < c.switches.size(); ++i)
    for (const std::uint8_t backward : {std::uint8_t{0}, std::uint8_t{1}})
      add_open(c, SkeletonOrigin::switch_point, i, backward, c.switches[i].inside);
  c.ends[4] = static_cast<u32>(c.separatrices.size());
  return c;
}

}  // namespace crest::tests
