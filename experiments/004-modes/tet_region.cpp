// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/004-modes/tet_region.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "algorithms/modes/planar_pieces.hpp"

namespace crest::experiments {

using kernel::dot;
using kernel::operator+, kernel::operator-, kernel::operator*;

namespace {

constexpr double kFine = 0.04;  // radians between points of an arc

/// In space, of a point in Tbar's frame.
Vec3 in_space(const modes::LinearTensors& f, const Vec3& p) {
  return p[0] * f.frame()[0] + p[1] * f.frame()[1] + p[2] * f.frame()[2];
}

modes::Tensor between(const modes::Tensor& a, const modes::Tensor& b, double t) {
  modes::Tensor c;
  for (std::size_t k = 0; k < 6; ++k) c[k] = (1 - t) * a[k] + t * b[k];
  return c;
}

/// Edges of one triangle only.
std::vector<std::array<kernel::Index, 2>> rim_of(const modes::ModeSurface& s) {
  std::map<std::array<kernel::Index, 2>, int> count;
  for (const auto& t : s.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      ++count[{a, b}];
    }
  std::vector<std::array<kernel::Index, 2>> rim;
  for (const auto& [edge, n] : count)
    if (n == 1) rim.push_back(edge);
  return rim;
}

struct Sample {
  Vec3 v, place;
  int sign;
  bool inside;
};

/// Both points of v are one there; a slightly smaller mode makes them real whatever rounds.
Sample sample(const TetField& tet, const Vec3& v) {
  const auto points = modes::mode_points(tet.field, v, tet.mu * (1 - 1e-11));
  if (!points) return {v, {}, 0, false};
  std::array<double, 4> w;
  bool inside = true;
  for (std::size_t k = 0; k < 4; ++k) {
    w[k] = 0.5 * ((*points)[0].weights[k] + (*points)[1].weights[k]);
    inside = inside && w[k] >= 0;
  }
  return {v, tet.at(w), (*points)[0].sign, inside};
}

/// Of the complex domain's boundary, around the irregular point with x > 0 and z of that sign.
std::vector<Sample> part_of_boundary(const TetField& tet, double z) {
  constexpr int kMany = 4000;
  const modes::LinearTensors& f = tet.field;
  double low = 2, high = -2;
  for (int i = -kMany; i <= kMany; ++i)
    if (const double alpha = i / double(kMany); modes::boundary_point(f, alpha, tet.mu)) {
      low = std::min(low, alpha);
      high = std::max(high, alpha);
    }
  std::vector<Sample> part;
  // Once around: y > 0 on the way to `high`, y < 0 on the way back.
  for (int i = 0; i < kMany; ++i) {
    const double turn = 2 * std::numbers::pi * (i + 0.5) / kMany;
    const double alpha = 0.5 * (low + high) - 0.5 * (high - low) * std::cos(turn);
    const auto p = modes::boundary_point(f, alpha, tet.mu);
    if (!p) continue;
    part.push_back(sample(
        tet, in_space(f, {(*p)[0], turn < std::numbers::pi ? (*p)[1] : -(*p)[1], z * (*p)[2]})));
  }
  return part;
}

class RegionMaker {
 public:
  RegionMaker(const TetField& tet, SphereRegion& region) : tet_(tet), region_(region) {}

  void add(const modes::ModeSurface& s) {
    std::map<kernel::Index, std::size_t> number;
    const auto point = [&](kernel::Index i) {
      const auto [at, made] = number.emplace(i, region_.points.size());
      if (made)
        region_.points.push_back({tet_.on_sphere(s.tensors[i], s.sign), s.points[i], s.sign});
      return at->second;
    };
    for (const auto& [a, b] : rim_of(s)) {
      const std::size_t p = point(a), q = point(b);
      if (dot(region_.points[p].v, region_.points[q].v) > 0)
        region_.face_curves.push_back({p, q});
      else
        cross(s, {a, b}, {p, q});
    }
  }

  /// The parts of the complex domain's boundary around the irregular points with x > 0; the others
  /// are their antipodes.
  bool add_arcs() {
    for (const double z : {1.0, -1.0})
      if (!add_arcs(part_of_boundary(tet_, z))) return false;
    return std::count(used_.begin(), used_.end(), true) ==
           static_cast<std::ptrdiff_t>(used_.size());
  }

 private:
  /// A curve that comes to the complex domain goes on at the antipode.
  void cross(const modes::ModeSurface& s, const std::array<kernel::Index, 2>& ends,
             const SphereRegion::Edge& sides) {
    const Vec3 start = region_.points[sides[0]].v;
    double low = 0, high = 1;
    for (int k = 0; k < 50; ++k) {
      const double t = 0.5 * (low + high);
      const auto v = tet_.on_sphere(between(s.tensors[ends[0]], s.tensors[ends[1]], t), s.sign);
      (dot(v, start) > 0 ? low : high) = t;
    }
    const Vec3 v = tet_.on_sphere(between(s.tensors[ends[0]], s.tensors[ends[1]], low), s.sign);
    const Vec3 place = (1 - low) * s.points[ends[0]] + low * s.points[ends[1]];
    crossings_.push_back(pair(v, place, s.sign));
    used_.push_back(false);
    ++region_.crossings;
    region_.face_curves.push_back({sides[0], crossings_.back()});
    region_.face_curves.push_back({crossings_.back() + 1, sides[1]});
  }
  /// The first of two antipodes.
  std::size_t pair(const Vec3& v, const Vec3& place, int sign) {
    const std::size_t first = region_.points.size();
    region_.points.push_back({v, place, sign, first + 1});
    region_.points.push_back({-1.0 * v, place, sign, first});
    return first;
  }

  bool add_arcs(const std::vector<Sample>& part) {
    const std::size_t n = part.size();
    std::size_t begin = 0;
    while (begin < n && part[begin].inside) ++begin;
    if (begin == n) {
      if (n > 0) close(part);
      return true;
    }
    for (std::size_t i = 1; i <= n; ++i) {
      if (!part[(begin + i) % n].inside) continue;
      std::vector<Sample> run;
      for (; part[(begin + i) % n].inside; ++i) run.push_back(part[(begin + i) % n]);
      if (!add_arc(run)) return false;
    }
    return true;
  }
  void close(const std::vector<Sample>& part) {
    std::size_t first = SphereRegion::kNone, last = first;
    for (const Sample& s : part) {
      if (last != SphereRegion::kNone && kernel::norm(s.v - region_.points[last].v) < kFine)
        continue;
      const std::size_t p = pair(s.v, s.place, s.sign);
      if (last == SphereRegion::kNone)
        first = p;
      else
        join(last, p);
      last = p;
    }
    join(last, first);
  }
  bool add_arc(const std::vector<Sample>& run) {
    const auto from = take_crossing(run.front().v), to = take_crossing(run.back().v);
    if (!from || !to) return false;
    std::size_t last = *from;
    for (const Sample& s : run) {
      if (kernel::norm(s.v - region_.points[last].v) < kFine ||
          kernel::norm(s.v - region_.points[*to].v) < 0.5 * kFine)
        continue;
      const std::size_t p = pair(s.v, s.place, s.sign);
      join(last, p);
      last = p;
    }
    join(last, *to);
    return true;
  }
  /// And their antipodes.
  void join(std::size_t a, std::size_t b) {
    region_.arcs.push_back({a, b});
    region_.arcs.push_back({region_.points[a].twin, region_.points[b].twin});
  }
  /// The nearest end of a curve; nothing if it is far or some arc's already.
  std::optional<std::size_t> take_crossing(const Vec3& v) {
    double least = kFine;
    std::size_t best = SphereRegion::kNone, place = 0;
    for (std::size_t i = 0; i < crossings_.size(); ++i)
      for (const std::size_t p : {crossings_[i], crossings_[i] + 1})
        if (const double d = kernel::norm(v - region_.points[p].v); d < least) {
          least = d;
          best = p;
          place = i;
        }
    if (best == SphereRegion::kNone || used_[place]) return std::nullopt;
    used_[place] = true;
    return best;
  }

  const TetField& tet_;
  SphereRegion& region_;
  std::vector<std::size_t> crossings_;  // the first of each pair
  std::vector<bool> used_;
};

/// Seen from a point of the sphere that is not in the region, far from its boundary.
class Stereographic {
 public:
  Stereographic(const TetField& tet, const SphereRegion& region) {
    constexpr int kMany = 2000;
    double farthest = -1;
    for (int i = 0; i < kMany; ++i) {
      const double z = 1 - (2 * i + 1.0) / kMany, r = std::sqrt(1 - z * z),
                   turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
      const Vec3 v{r * std::cos(turn), r * std::sin(turn), z};
      if (tet.point_inside(v)) continue;
      double nearest = 4;
      for (const auto& p : region.points) nearest = std::min(nearest, kernel::norm(v - p.v));
      if (nearest > farthest) {
        farthest = nearest;
        pole_ = v;
      }
    }
    right_ = modes::across(pole_);
    up_ = kernel::cross(pole_, right_);
  }
  std::array<double, 2> operator()(const Vec3& v) const {
    const double s = 1 / (1 - dot(v, pole_));
    return {s * dot(v, right_), s * dot(v, up_)};
  }

 private:
  Vec3 pole_{}, right_, up_;
};

/// The points of the grid that lie in the region, not next to its boundary.
void add_grid(const TetField& tet, const SphereRegion& region, int steps, Tessellation& result) {
  const auto grid = modes::irregular_points(tet.field);
  for (int i = 0; i < steps; ++i)
    for (int j = 1; j < steps; ++j) {
      const Vec3 v = in_space(tet.field, modes::quad_grid(grid, 2 * std::numbers::pi * i / steps,
                                                          std::numbers::pi * j / steps));
      const auto p = tet.point_inside(v);
      if (!p) continue;
      double nearest = 4;
      for (const auto& q : region.points) nearest = std::min(nearest, kernel::norm(v - q.v));
      if (nearest < 2.0 / steps) continue;
      result.points.push_back({v, tet.at(p->weights), p->sign});
      ++result.grid_points;
    }
}

using Plane = std::vector<std::array<double, 2>>;
using Loop = std::vector<std::size_t>;

bool encloses(const Plane& plane, const Loop& loop, std::size_t point) {
  const auto& p = plane[point];
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto &a = plane[loop[i]], &b = plane[loop[(i + 1) % loop.size()]];
    if ((a[1] <= p[1]) != (b[1] <= p[1]) &&
        p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      inside = !inside;
  }
  return inside;
}

/// In how many loops the point lies, its own not counted.
std::size_t depth_of(const Plane& plane, const std::vector<Loop>& loops, std::size_t point) {
  std::size_t depth = 0;
  for (const Loop& loop : loops)
    depth +=
        std::find(loop.begin(), loop.end(), point) == loop.end() && encloses(plane, loop, point);
  return depth;
}

/// Triangles of what lies in a loop, the holes in it left out. Points from `first_inner` on are in
/// no loop.
bool add_domain(const Plane& plane, const std::vector<Loop>& loops, const Loop& outer,
                std::size_t first_inner, Tessellation& result) {
  const std::size_t depth = depth_of(plane, loops, outer[0]);
  std::vector<std::size_t> used;
  modes::PlanarPiece piece;
  const auto add = [&](const Loop& loop) {
    auto& own = piece.loops.emplace_back();
    for (const std::size_t p : loop) {
      own.push_back(used.size());
      used.push_back(p);
    }
  };
  add(outer);
  for (const Loop& hole : loops)
    if (encloses(plane, outer, hole[0]) && depth_of(plane, loops, hole[0]) == depth + 1) add(hole);
  for (std::size_t p = first_inner; p < plane.size(); ++p)
    if (encloses(plane, outer, p) && depth_of(plane, loops, p) == depth + 1) used.push_back(p);
  for (const std::size_t p : used) piece.points.push_back(plane[p]);
  piece.facets.assign(used.size(), 0);
  const auto triangles = modes::triangulate(piece);
  if (!triangles) return false;
  for (const auto& [a, b, c] : *triangles) result.triangles.push_back({used[a], used[b], used[c]});
  return true;
}

}  // namespace

Vec3 TetField::at(const std::array<double, 4>& w) const {
  return w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2] + w[3] * corners[3];
}

std::optional<modes::ModePoint> TetField::point(const Vec3& v) const {
  const auto points = modes::mode_points(field, v, mu);
  if (!points) return std::nullopt;
  return (*points)[0];
}

std::optional<modes::ModePoint> TetField::point_inside(const Vec3& v) const {
  const auto p = point(v);
  if (!p || *std::min_element(p->weights.begin(), p->weights.end()) < 0) return std::nullopt;
  return p;
}

Vec3 TetField::on_sphere(const modes::Tensor& tensor, int sign) const {
  const auto axes = modes::eigensystem(modes::sum({}, sign, modes::deviator(tensor)));
  const Vec3& v = axes.vectors[1];
  auto points = modes::mode_points(field, v, mu);
  // Between points of a polyline the mode is not quite the level.
  for (double less = 1e-12; !points && less < 1; less *= 10)
    points = modes::mode_points(field, v, mu * (1 - less));
  const auto agreement = [&](std::size_t k) {
    return std::fabs(dot(axes.vectors[0], (*points)[k].dominant));
  };
  return points && agreement(1) > agreement(0) ? -1.0 * v : v;
}

std::vector<std::vector<std::size_t>> SphereRegion::loops() const {
  std::vector<std::vector<std::size_t>> next(points.size());
  for (const auto* edges : {&face_curves, &arcs})
    for (const auto& [a, b] : *edges) {
      next[a].push_back(b);
      next[b].push_back(a);
    }
  std::vector<std::vector<std::size_t>> found;
  std::vector<bool> seen(points.size(), false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (next[i].size() != 2) return {};
    if (seen[i]) continue;
    found.emplace_back();
    for (std::size_t at = i, previous = next[i][0]; !seen[at];) {
      seen[at] = true;
      found.back().push_back(at);
      const std::size_t on = next[at][0] == previous ? next[at][1] : next[at][0];
      previous = at;
      at = on;
    }
  }
  return found;
}

std::optional<SphereRegion> sphere_region(const TetField& tet,
                                          const std::vector<modes::ModeSurface>& surfaces) {
  SphereRegion region;
  RegionMaker maker(tet, region);
  for (const auto& s : surfaces) maker.add(s);
  if (!maker.add_arcs()) return std::nullopt;
  return region;
}

std::optional<Tessellation> tessellate(const TetField& tet, const SphereRegion& region, int steps) {
  Tessellation result;
  result.points = region.points;
  add_grid(tet, region, steps, result);
  const Stereographic project(tet, region);
  Plane plane;
  for (const auto& p : result.points) plane.push_back(project(p.v));
  const auto loops = region.loops();
  for (const auto& outer : loops) {
    if (depth_of(plane, loops, outer[0]) % 2 != 0) continue;
    if (!add_domain(plane, loops, outer, region.points.size(), result)) return std::nullopt;
  }
  return result;
}

long euler_characteristic(const Tessellation& t) {
  const auto glued = [&](std::size_t p) { return std::min(p, t.points[p].twin); };
  std::set<std::size_t> vertices;
  std::set<std::array<std::size_t, 2>> edges;
  for (const auto& f : t.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax({glued(f[k]), glued(f[(k + 1) % 3])});
      vertices.insert(a);
      edges.insert({a, b});
      vertices.insert(b);
    }
  return static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) +
         static_cast<long>(t.triangles.size());
}

}  // namespace crest::experiments
