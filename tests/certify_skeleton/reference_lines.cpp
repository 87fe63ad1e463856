// SPDX-License-Identifier: GPL-3.0-or-later
// Fields, and stream lines in plain double: where the checker's barriers go is not known here.
#include <algorithm>
#include <cmath>
#include <map>
#include <regex>

#include "certify/skeleton/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_skeleton/reference_skeleton.hpp"

namespace crest::tests {
namespace {

using namespace certify;
using u32 = std::uint32_t;
using Vec = std::array<double, 2>;

u32 nx(u32 c) {
  return c % 3 == 2 ? c - 2 : c + 1;
}
u32 pv(u32 c) {
  return c % 3 == 0 ? c + 2 : c - 1;
}
double cross(const Vec& a, const Vec& b) {
  return a[0] * b[1] - a[1] * b[0];
}
Vec operator-(const Vec& a, const Vec& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
Vec operator+(const Vec& a, const Vec& b) {
  return {a[0] + b[0], a[1] + b[1]};
}
Vec operator*(double s, const Vec& a) {
  return {s * a[0], s * a[1]};
}

constexpr SkeletonBarrier kBarrier{12, 32, 53, 0};

/// v = o + a n + b p in a triangle, x = tail of corner + ..., everything in the frame of a corner.
struct Local {
  Vec o, a, b;  ///< v in frame coordinates, times the area

  Vec at(const Vec& x) const { return o + x[0] * a + x[1] * b; }
};

/// The field by corners, glued; regions of the boundary.
class View {
 public:
  View(const PlaneField& f, SkeletonCertificate& c) : f_(f), c_(c) {
    std::map<std::array<u32, 2>, u32> sides;
    const auto n = static_cast<u32>(3 * f.triangles.size());
    for (u32 k = 0; k < n; ++k) sides[{v(k), v(nx(k))}] = k;
    twin_.assign(n, kNotStated);
    for (u32 k = 0; k < n; ++k) {
      const auto other = sides.find({v(nx(k)), v(k)});
      if (other != sides.end() && !(nil(k) && nil(nx(k)))) twin_[k] = other->second;
    }
    find_regions();
  }

 protected:
  u32 v(u32 k) const { return f_.triangles[k / 3][k % 3]; }
  const Vec& p(u32 k) const { return f_.positions[v(k)]; }
  const Vec& w(u32 k) const { return f_.vectors[v(k)]; }
  bool nil(u32 k) const { return w(k) == Vec{0, 0}; }
  Local local(u32 corner, bool backward) const {
    const Vec e = p(nx(corner)) - p(corner), g = p(pv(corner)) - p(corner);
    const double area = cross(e, g) * (backward ? -1 : 1);
    const auto in_frame = [&](const Vec& u) { return Vec{cross(u, g) / area, cross(e, u) / area}; };
    const Vec o = in_frame(w(corner));
    return {o, in_frame(w(nx(corner))) - o, in_frame(w(pv(corner))) - o};
  }
  static double signed_distance(double from_tail) {
    return from_tail <= 0.5 ? from_tail : -(1 - from_tail);
  }
  static double from_tail(double t) { return t > 0 ? t : 1 + t; }

  static Turn turn_of(u32 entered, u32 exit) {
    return exit == entered ? Turn::back : exit == nx(entered) ? Turn::right : Turn::left;
  }
  static double head_weight(u32 corner, const Vec& x, u32 side) {
    const double l[3] = {1 - x[0] - x[1], x[0], x[1]};
    const u32 head = nx(side);
    return head == corner ? l[0] : head == nx(corner) ? l[1] : l[2];
  }

  /// Regions at the ends of boundary sides, by the events in the order of the loops.
  void find_regions() {
    regions_.assign(twin_.size(), {0, 0});
    u32 base = 0;
    std::size_t at = 0;
    for (const SkeletonLoop& loop : c_.loops) {
      std::vector<u32> sides;
      for (u32 k = loop.side; sides.empty() || k != loop.side;) {
        sides.push_back(k);
        for (k = nx(k); twin_[k] != kNotStated;) k = nx(twin_[k]);
      }
      if (loop.zero != 0) return;  // of later loops nothing is known here
      const u32 count = loop.interior + loop.exterior, all = std::max(count, 1U);
      u32 events = 0;
      for (const u32 s : sides) {
        regions_[s][0] = base + (events + all - 1) % all;
        for (; at < c_.switches.size() && events < count && c_.switches[at].side == s; ++at) {
          ++events;
          if (c_.switches[at].place == 0) regions_[s][1] = base + events - 1;
        }
        regions_[s][1] = base + (events + all - 1) % all;
        // A corner belongs to the side before: its region begins with the next side.
        const bool corner =
            at > 0 && events > 0 && c_.switches[at - 1].side == s && c_.switches[at - 1].place != 0;
        if (corner) regions_[s][1] = base + (events + all - 2) % all;
      }
      base += all;
    }
  }

  const PlaneField& f_;
  SkeletonCertificate& c_;
  std::vector<u32> twin_;
  std::vector<std::array<u32, 2>> regions_;
};

/// Steps through triangles; ellipses around sinks and sources.
class Stepper : public View {
 public:
  Stepper(const PlaneField& f, SkeletonCertificate& c) : View(f, c) {
    zero_of_.assign(f.triangles.size(), kNotStated);
    for (u32 i = 0; i < c.zeros.size(); ++i)
      if (c.zeros[i].place == ZeroPlace::triangle) zero_of_[c.zeros[i].triangle] = i;
    find_traps();
  }

 protected:
  void find_traps() {
    for (u32 i = 0; i < c_.zeros.size(); ++i) {
      const SkeletonZero& z = c_.zeros[i];
      const bool source = z.kind == ZeroClass::source;
      if (!source && z.kind != ZeroClass::sink) continue;
      const Local l = local(3 * z.triangle, source);
      // A^T P + P A = -1: three equations, by Cramer's rule.
      const double a = l.a[0], b = l.b[0], c = l.a[1], d = l.b[1];  // A = (a b; c d)
      const double m[3][3] = {{2 * a, 2 * c, 0}, {b, a + d, c}, {0, 2 * b, 2 * d}};
      const double r[3] = {-1, 0, -1};
      const auto det3 = [](const double n[3][3]) {
        return n[0][0] * (n[1][1] * n[2][2] - n[1][2] * n[2][1]) -
               n[0][1] * (n[1][0] * n[2][2] - n[1][2] * n[2][0]) +
               n[0][2] * (n[1][0] * n[2][1] - n[1][1] * n[2][0]);
      };
      double form[3];
      for (int k = 0; k < 3; ++k) {
        double changed[3][3];
        for (int row = 0; row < 3; ++row)
          for (int col = 0; col < 3; ++col) changed[row][col] = col == k ? r[row] : m[row][col];
        form[k] = det3(changed) / det3(m);
      }
      const Vec z0 = centre(l);
      const double area = form[0] * form[2] - form[1] * form[1], l0 = 1 - z0[0] - z0[1];
      const double level =
          0.99 * std::min({area * l0 * l0 / (form[0] + form[2] - 2 * form[1]),
                           area * z0[0] * z0[0] / form[2], area * z0[1] * z0[1] / form[0]});
      c_.traps.push_back({i, {form[0] / level, form[1] / level, form[2] / level}, {}});
      traps_[i] = {z0, c_.traps.back().form};
    }
  }
  static Vec centre(const Local& l) {
    const double d = cross(l.a, l.b);
    return {cross(l.b, l.o) / d, cross(l.o, l.a) / d};
  }

  /// Moves x along v until it leaves the triangle; the coordinate that vanishes, or -1.
  int leave(u32 corner, bool backward, Vec& x) const {
    const Local l = local(corner, backward);
    const double norm =
        std::max(std::fabs(l.a[0]) + std::fabs(l.b[0]), std::fabs(l.a[1]) + std::fabs(l.b[1]));
    bool first = true;
    for (int step = 0; step < 2000; ++step, first = false) {
      const Vec v0 = l.at(x);
      const double h = 1 / (4 * norm + 8 * std::max(std::fabs(v0[0]), std::fabs(v0[1])));
      std::vector<Vec> series = {x};
      Vec c = h * v0;
      for (int k = 1; k <= 16; ++k) {
        series.push_back(c);
        c = (h / (k + 1)) * (c[0] * l.a + c[1] * l.b);
      }
      const auto point = [&](double s) {
        Vec sum{0, 0};
        for (std::size_t k = series.size(); k-- > 0;) sum = s * sum + series[k];
        return sum;
      };
      const auto least = [&](double s, int& which) {
        const Vec y = point(s);
        const double m[3] = {1 - y[0] - y[1], y[0], y[1]};
        which = m[0] < m[1] ? (m[0] < m[2] ? 0 : 2) : (m[1] < m[2] ? 1 : 2);
        return m[which];
      };
      int which = 0;
      double low = first ? 1e-7 : 0;
      constexpr int kSamples = 16;
      for (int k = 1; k <= kSamples; ++k) {
        double high = static_cast<double>(k) / kSamples;
        if (least(high, which) >= 0) {
          low = high;
          continue;
        }
        for (int i = 0; i < 60; ++i) {
          const double mid = (low + high) / 2;
          (least(mid, which) >= 0 ? low : high) = mid;
        }
        least(high, which);
        x = point(high);
        return which;
      }
      x = point(1);
      if (trapped(corner, x, backward)) return -2;
    }
    return -1;
  }
  bool trapped(u32 corner, const Vec& x, bool backward) const {
    const u32 zero = zero_of_[corner / 3];
    if (zero == kNotStated) return false;
    const auto trap = traps_.find(zero);
    if (trap == traps_.end() || (c_.zeros[zero].kind == ZeroClass::source) != backward)
      return false;
    const double m[3] = {1 - x[0] - x[1], x[0], x[1]};
    const u32 k = corner % 3;  // weights of corners 1 and 2 of the triangle
    const Vec y = Vec{m[(4 - k) % 3], m[(5 - k) % 3]} - trap->second.first;
    const auto& form = trap->second.second;
    return form[0] * y[0] * y[0] + 2 * form[1] * y[0] * y[1] + form[2] * y[1] * y[1] < 0.5;
  }

  std::vector<u32> zero_of_;
  std::map<u32, std::pair<Vec, std::array<double, 3>>> traps_;
};

/// Follows lines from triangle to triangle to their ends.
class Follower : public Stepper {
 public:
  using Stepper::Stepper;

 protected:
  /// Inside the triangle of a corner at x in its frame.
  void follow_from(SkeletonSeparatrix& line, u32 corner, const Vec& x) {
    Vec at = x;
    const int exit = leave(corner, line.backward != 0, at);
    if (exit < 0) {
      line.legs.clear();
      line.reason = OpenReason::budget;
      return;
    }
    const u32 opposite = exit == 0 ? corner : exit == 1 ? nx(corner) : pv(corner);
    const u32 side = nx(opposite);
    line.legs[0].turns.push_back(turn_of(corner, side));
    follow(line, side, head_weight(corner, at, side));
  }
  /// On from a point of a side that was left (weight of its head), triangle by triangle.
  void follow(SkeletonSeparatrix& line, u32 left, double head) {
    auto& turns = line.legs[0].turns;
    const bool backward = line.backward != 0;
    std::map<u32, std::vector<std::pair<std::size_t, double>>> visits;
    u32 side = left;
    for (int count = 0; count < 5000; ++count) {
      if (twin_[side] == kNotStated) {
        line.end = SkeletonEnd::boundary;
        const double n0 = cross(p(nx(side)) - p(side), w(side));
        line.to = regions_[side][(n0 < 0) == !backward ? 0 : 1];
        return;
      }
      const u32 entered = twin_[side];
      const double at = 1 - head;
      auto& seen = visits[entered];
      seen.emplace_back(turns.size(), at);
      if (seen.size() > 40) return orbit(line, entered, seen, backward);
      // The frame of the nearer end.
      const u32 corner = at <= 0.5 ? entered : nx(entered);
      Vec x = at <= 0.5 ? Vec{at, 0} : Vec{0, head};
      const int exit = leave(corner, backward, x);
      if (exit == -2) {
        line.end = SkeletonEnd::zero;
        line.to = zero_of_[entered / 3];
        return;
      }
      if (exit < 0) break;
      const u32 opposite = exit == 0 ? corner : exit == 1 ? nx(corner) : pv(corner);
      side = nx(opposite);
      turns.push_back(turn_of(entered, side));
      head = head_weight(corner, x, side);
      if (head < 1e-9 || head > 1 - 1e-9) break;
    }
    line.reason = OpenReason::budget;
  }

  void orbit(SkeletonSeparatrix& line, u32 side,
             const std::vector<std::pair<std::size_t, double>>& seen, bool backward) {
    auto& turns = line.legs[0].turns;
    const double fixed = seen.back().second;
    const double eta = 1e-3 * std::min(fixed, 1 - fixed);
    u32 number = 0;
    for (; number < c_.orbits.size(); ++number)
      if (c_.orbits[number].side == side &&
          std::fabs(from_tail(c_.orbits[number].left) - fixed) < 2 * eta)
        break;
    std::size_t first = 0;
    while (std::fabs(seen[first].second - fixed) > eta / 2) ++first;
    if (number == c_.orbits.size()) {
      SkeletonOrbit orbit;
      orbit.side = side;
      orbit.backward = backward;
      orbit.left = signed_distance(fixed - eta);
      orbit.right = signed_distance(fixed + eta);
      orbit.barrier = kBarrier;
      orbit.turns.assign(turns.begin() + static_cast<std::ptrdiff_t>(seen[seen.size() - 2].first),
                         turns.begin() + static_cast<std::ptrdiff_t>(seen.back().first));
      c_.orbits.push_back(orbit);
    }
    turns.resize(seen[first].first);
    line.end = SkeletonEnd::orbit;
    line.to = number;
  }
};

class Tracer : public Follower {
 public:
  using Follower::Follower;

  void all_lines() {
    // Of zeros on vertices and edges nothing is known.
    std::erase_if(c_.separatrices, [&](const SkeletonSeparatrix& line) {
      return line.origin != SkeletonOrigin::zero ||
             c_.zeros[line.from].kind != ZeroClass::higher_order;
    });
    for (u32 i = 0; i < c_.zeros.size(); ++i)
      if (c_.zeros[i].kind == ZeroClass::saddle) saddle(i);
    for (u32 i = 0; i < c_.switches.size(); ++i)
      if (c_.switches[i].inside != 0)
        for (const bool backward : {false, true}) switch_line(i, backward);
  }

 private:
  void saddle(u32 i) {
    const u32 t = c_.zeros[i].triangle, corner = 3 * t;
    const Local l = local(corner, false);
    const double trace = l.a[0] + l.b[1], det = cross(l.a, l.b),
                 root = std::sqrt(trace * trace / 4 - det);
    for (const bool backward : {false, true}) {
      const double value = trace / 2 + (backward ? -root : root);
      // (A - value) d = 0; the larger of two forms.
      const Vec d1{l.b[0], value - l.a[0]}, d2{value - l.b[1], l.a[1]};
      const Vec d = std::hypot(d1[0], d1[1]) > std::hypot(d2[0], d2[1]) ? d1 : d2;
      for (const double sense : {1.0, -1.0}) ray(i, corner, centre(l), sense * d, backward);
    }
  }
  /// From x in direction d, in the frame of a corner: a leg through the side that it meets.
  void ray(u32 zero, u32 corner, const Vec& x, const Vec& d, bool backward) {
    const double l[3] = {1 - x[0] - x[1], x[0], x[1]}, r[3] = {-d[0] - d[1], d[0], d[1]};
    int exit = -1;
    double time = 0;
    for (int k = 0; k < 3; ++k)
      if (r[k] < 0 && (exit < 0 || -l[k] / r[k] < time)) time = -l[k] / r[k], exit = k;
    const u32 opposite = exit == 0 ? corner : exit == 1 ? nx(corner) : pv(corner);
    const u32 side = nx(opposite);
    double s[3];
    for (int k = 0; k < 3; ++k) s[k] = l[k] + time * r[k];
    const double head = s[(exit + 2) % 3];  // weight of the side's head
    SkeletonLeg leg;
    leg.corner = side;
    const double margin = 1e-12 * std::min(head, 1 - head);
    leg.first = {signed_distance(head + margin)};
    leg.second = {signed_distance(head - margin)};
    leg.barrier = kBarrier;
    SkeletonSeparatrix line;
    line.from = zero;
    line.backward = backward;
    line.legs = {leg};
    follow(line, side, head);
    c_.separatrices.push_back(line);
  }

  void switch_line(u32 i, bool backward) {
    const SkeletonSwitch& point = c_.switches[i];
    SkeletonSeparatrix line;
    line.origin = SkeletonOrigin::switch_point;
    line.from = i;
    line.backward = backward;
    SkeletonLeg leg;
    leg.barrier = kBarrier;
    if (point.place == 0) {
      leg.kind = LegKind::along;
      leg.corner = point.side;
      const Local l = local(point.side, backward);
      const double p0 = l.o[1] / (l.o[1] - (l.o[1] + l.a[1]));  // normal part is zero
      const Vec at{p0, 0};
      const double speed = l.at(at)[0];
      const double step = (speed > 0 ? 1 : -1) * 1e-4 * std::min(p0, 1 - p0);
      const double height = 4 * std::fabs(l.a[1] * step / speed) * std::fabs(step);
      leg.first = {signed_distance(p0 + step)};
      leg.second = {p0 + step, height};
      line.legs = {leg};
      follow_from(line, point.side, {p0 + step, height / 4});
    } else {
      // The triangle of the fan into which v points.
      for (u32 c = nx(point.side);;) {
        const Local l = local(c, backward);
        if (l.o[0] > 0 && l.o[1] > 0) {
          leg.kind = LegKind::point;
          leg.corner = c;
          line.legs = {leg};
          follow_from(line, c, {0, 0});
          break;
        }
        c = twin_[pv(c)];
        if (c == kNotStated) {
          line.reason = OpenReason::vertex_hit;
          break;
        }
      }
    }
    c_.separatrices.push_back(line);
  }
};

void count_ends(SkeletonCertificate& c) {
  c.ends = {};
  for (const auto& line : c.separatrices) ++c.ends[static_cast<std::size_t>(line.end)];
}

}  // namespace

SkeletonCertificate reference_skeleton(const PlaneField& field) {
  SkeletonCertificate c = reference_points(field);
  Tracer(field, c).all_lines();
  count_ends(c);
  for (std::size_t i = 0; i <= c.separatrices.size(); ++i) {
    const Verdict verdict = verify(encode(c));
    std::smatch match;
    if (verdict.accepted ||
        !std::regex_search(verdict.reason, match, std::regex("^separatrix ([0-9]+)")))
      break;
    auto& line = c.separatrices[std::stoul(match[1])];
    if (line.legs.empty()) break;
    line.legs.clear();
    line.end = SkeletonEnd::undecided;
    line.to = 0;
    line.reason = OpenReason::budget;
    count_ends(c);
  }
  return c;
}

PlaneField grid_field(u32 nx, u32 ny, double spacing,
                      const std::function<std::array<double, 2>(double, double)>& v,
                      const std::function<bool(u32, u32)>& left_out) {
  PlaneField f;
  for (u32 j = 0; j <= ny; ++j)
    for (u32 i = 0; i <= nx; ++i) {
      const double x = i * spacing, y = j * spacing;
      f.positions.push_back({x, y});
      f.vectors.push_back(v(x, y));
    }
  for (u32 j = 0; j < ny; ++j)
    for (u32 i = 0; i < nx; ++i) {
      if (left_out && left_out(i, j)) continue;
      const u32 a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = a + nx + 1;
      f.triangles.push_back({a, b, c});
      f.triangles.push_back({a, c, d});
    }
  return f;
}

PlaneField lattice_field(std::uint64_t seed, u32 m, u32 n, bool hole) {
  std::uint64_t x = seed;
  const auto next = [&] {
    x = 6364136223846793005ULL * x + 1442695040888963407ULL;
    return static_cast<double>(x >> 11U) / 0x1p53;
  };
  for (int i = 0; i < 4; ++i) next();
  std::vector<std::array<double, 2>> lattice;
  for (u32 i = 0; i < (m + 1) * (m + 1); ++i) {
    const double u = 2 * next() - 1, w = 2 * next() - 1;
    lattice.push_back({u, w});
  }
  const auto blend = [](double s, u32 m1, u32& a) {
    a = std::min(m1 - 1, static_cast<u32>(std::floor(s)));
    const double f = s - a;
    return f * f * (3 - 2 * f);
  };
  PlaneField field = grid_field(
      n, n, 1,
      [&](double i, double j) {
        u32 a = 0, b = 0;
        const double wx = blend(i / n * m, m, a), wy = blend(j / n * m, m, b);
        std::array<double, 2> v{};
        for (std::size_t k = 0; k < 2; ++k) {
          const auto at = [&](u32 p, u32 q) { return lattice[q * (m + 1) + p][k]; };
          const double low = at(a, b) * (1 - wx) + at(a + 1, b) * wx,
                       high = at(a, b + 1) * (1 - wx) + at(a + 1, b + 1) * wx;
          v[k] = low * (1 - wy) + high * wy;
        }
        return v;
      },
      [&](u32 i, u32 j) {
        return hole && 3 * n <= 8 * i && 8 * i < 5 * n && 3 * n <= 8 * j && 8 * j < 5 * n;
      });
  for (auto& p : field.positions) p = {p[0] / n, p[1] / n};
  return field;
}

PlaneField ring_field(const std::vector<std::array<double, 2>>& size_and_strength) {
  const Vec ring[8] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  PlaneField f;
  for (const auto& [size, strength] : size_and_strength)
    for (const Vec& p : ring) {
      const Vec x = size * p;
      f.positions.push_back(x);
      f.vectors.push_back({strength * x[0] - 0.5 * x[1], strength * x[1] + 0.5 * x[0]});
    }
  for (u32 r = 0; r + 1 < size_and_strength.size(); ++r)
    for (u32 i = 0; i < 8; ++i) {
      const u32 p = 8 * r + i, next = 8 * r + (i + 1) % 8;
      f.triangles.push_back({p, p + 8, next + 8});
      f.triangles.push_back({p, next + 8, next});
    }
  return f;
}

}  // namespace crest::tests
