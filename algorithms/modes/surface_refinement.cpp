// SPDX-License-Identifier: GPL-3.0-or-later
// SurfaceBuilder: polylines and pieces are made finer, until projections are simple and nothing is
// further from the surface than it may be.
#include <algorithm>
#include <cmath>

#include "algorithms/modes/surface_builder.hpp"

namespace crest::modes {

using kernel::Vec3;

/// A point on the arc over the middle of part k of its polyline.
SurfaceBuilder::ArcPoint SurfaceBuilder::middle(Index a, std::size_t k) {
  const Arc& arc = faces_.arcs()[a];
  const Face& face = faces_.face(arc.face);
  const auto from = root_in_face(arc.roots[0], arc.face), to = root_in_face(arc.roots[1], arc.face);
  const auto points = inside(a);
  const double last = k == 0 ? 0 : points[k - 1].place,
               next = k < points.size() ? points[k].place : 1;
  const double place = 0.5 * (last + next);
  std::array<double, 3> base, w;
  for (std::size_t i = 0; i < 3; ++i) {
    base[i] = (1 - place) * from[i] + place * to[i];
    w[i] = face.witness.w[i];
  }
  return {place, lifted(face.corners, base, w)};
}

/// Halves these parts of a polyline, given in ascending order.
void SurfaceBuilder::refine(Index a, const std::set<std::size_t>& parts) {
  std::vector<ArcPoint> points;
  const auto old = inside(a);
  for (std::size_t k = 0; k <= old.size(); ++k) {
    if (parts.contains(k)) points.push_back(middle(a, k));
    if (k < old.size()) points.push_back(old[k]);
  }
  if (inside_of_[a] == kNone) {
    inside_of_[a] = static_cast<Index>(inside_.size());
    inside_.emplace_back();
  }
  inside_[inside_of_[a]] = std::move(points);
}

/// The new points over which the surface is not met: chords may leave its projection.
std::vector<std::size_t> SurfaceBuilder::missed(const Job& job, const Layout& layout,
                                                const PlanarPiece& planar) const {
  std::vector<std::size_t> r;
  Barycentric w;
  for (std::size_t i = 0; i < 4; ++i) w[i] = job.cell.witness.w[i];
  for (std::size_t i = layout.at.size(); i < planar.points.size(); ++i) {
    bool crosses = false;
    lifted(job.cell.corners, unfolded(layout, planar.points[i]), w, &crosses);
    if (!crosses) r.push_back(i);
  }
  return r;
}

/// The parts of polylines that cross in the projection.
void SurfaceBuilder::add_crossing(const Layout& layout, Parts& parts) {
  const auto& loops = layout.planar.loops;
  struct Segment {
    std::array<double, 2> from, to;
    std::size_t first, second;
    double low, high;  ///< in x
  };
  std::vector<Segment> segments;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t a = loop[i], b = loop[(i + 1) % loop.size()];
      const auto &p = layout.planar.points[a], &q = layout.planar.points[b];
      segments.push_back({p, q, a, b, std::fmin(p[0], q[0]), std::fmax(p[0], q[0])});
    }
  const auto turn = [](const auto& p, const auto& q, const auto& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  std::sort(segments.begin(), segments.end(),
            [](const Segment& a, const Segment& b) { return a.low < b.low; });
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t k = i + 1; k < segments.size() && segments[k].low <= segments[i].high; ++k) {
      const Segment &s = segments[i], &t = segments[k];
      if (s.first == t.second || s.second == t.first) continue;
      if (turn(s.from, s.to, t.from) * turn(s.from, s.to, t.to) > 0 ||
          turn(t.from, t.to, s.from) * turn(t.from, t.to, s.to) > 0)
        continue;
      add_part(layout, s.first, s.second, parts);
      add_part(layout, t.first, t.second, parts);
    }
}

/// The parts nearest to points over which the surface is not met.
void SurfaceBuilder::add_nearest(const Layout& layout, const PlanarPiece& planar,
                                 const std::vector<std::size_t>& missed, Parts& parts) {
  for (const std::size_t m : missed) {
    const auto& x = planar.points[m];
    double least = HUGE_VAL;
    std::array<std::size_t, 2> nearest{};
    for (const auto& loop : layout.planar.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::size_t a = loop[i], b = loop[(i + 1) % loop.size()];
        const auto &p = planar.points[a], &q = planar.points[b];
        const double dx = q[0] - p[0], dy = q[1] - p[1], length = dx * dx + dy * dy;
        const double along = (x[0] - p[0]) * dx + (x[1] - p[1]) * dy;
        const double s = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
        const double d = std::hypot(p[0] + s * dx - x[0], p[1] + s * dy - x[1]);
        if (d >= least) continue;
        least = d;
        nearest = {a, b};
      }
    add_part(layout, nearest[0], nearest[1], parts);
  }
}

void SurfaceBuilder::add_all(const Layout& layout, Parts& parts) {
  for (const auto& loop : layout.planar.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      add_part(layout, loop[i], loop[(i + 1) % loop.size()], parts);
}

/// Of a short part the ends are one place but for an infinitesimal: its halves cross no less.
void SurfaceBuilder::add_part(const Layout& layout, std::size_t point, std::size_t next,
                              Parts& parts) {
  constexpr double shortest = 1e-11;
  const auto &p = layout.planar.points[point], &q = layout.planar.points[next];
  if (std::fabs(p[0] - q[0]) + std::fabs(p[1] - q[1]) < shortest) return;
  parts[layout.parts[point].first].insert(layout.parts[point].second);
}

/// Polylines are shared: all are fine enough before any piece is meshed.
void SurfaceBuilder::refine_all() {
  constexpr int kHalvings = 6;  // of whole loops, for one piece
  constexpr int rounds = 30;
  constexpr std::size_t most_points = 2000;
  for (int round = 0; round < rounds; ++round) {
    Parts parts;
    for (Job& job : jobs_) {
      if (job.done) continue;
      Layout& layout = layout_;
      lay_out(job, layout);
      job.planar = layout.planar;
      auto triangles = triangulate(job.planar);
      const auto over = triangles ? missed(job, layout, job.planar) : std::vector<std::size_t>{};
      job.done = triangles && over.empty();
      if (job.done)
        job.triangles = std::move(*triangles);
      else if (layout.at.size() >= most_points)
        continue;
      else if (!triangles)
        add_crossing(layout, parts);
      else if (job.halvings++ < kHalvings)
        add_all(layout, parts);
      else
        add_nearest(layout, job.planar, over, parts);
    }
    if (parts.empty() || round + 1 == rounds) return;
    for (const auto& [arc, which] : parts) refine(arc, which);
    for (Job& job : jobs_)
      for (const Loop& loop : job.piece)
        for (const LoopArc& a : loop) job.done = job.done && !parts.contains(a.arc);
  }
}

namespace {

double distance_to_segment(const Vec3& x, const Vec3& a, const Vec3& b) {
  using kernel::operator-;
  using kernel::operator*;
  const Vec3 along = b - a;
  const double length = kernel::dot(along, along);
  const double s = length > 0 ? std::clamp(kernel::dot(x - a, along) / length, 0.0, 1.0) : 0;
  return kernel::norm(x - a - s * along);
}

double distance_to_plane(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) {
  using kernel::operator-;
  const Vec3 n = kernel::cross(b - a, c - a);
  const double length = kernel::norm(n);
  return length > 0 ? std::fabs(kernel::dot(x - a, n)) / length : 0;
}

}  // namespace

Vec3 SurfaceBuilder::in_space(const Cell& cell, const Barycentric& b) {
  Vec3 p{};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t c = 0; c < 3; ++c) p[c] += b[k] * place(cell.corners[k])[c];
  return p;
}

/// Halves the parts of an arc's polyline whose middles are far from the arc.
void SurfaceBuilder::straighten(Index a, double deviation) {
  constexpr std::size_t most = 1024;  // points of one arc
  const Arc& arc = faces_.arcs()[a];
  const auto in_face = [&](const std::array<double, 3>& at) {
    Vec3 p{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        p[c] += at[i] * place(faces_.face(arc.face).corners[i])[c];
    return p;
  };
  std::set<std::size_t> far{0};
  for (std::size_t k = 1; k <= inside(a).size(); ++k) far.insert(k);
  while (!far.empty() && inside(a).size() < most) {
    std::vector<Vec3> points{in_face(root_in_face(arc.roots[0], arc.face))};
    for (const ArcPoint& p : inside(a)) points.push_back(in_face(p.at));
    points.push_back(in_face(root_in_face(arc.roots[1], arc.face)));
    std::erase_if(far, [&](std::size_t k) {
      return distance_to_segment(in_face(middle(a, k).at), points[k], points[k + 1]) <= deviation;
    });
    if (far.empty()) return;
    refine(a, far);
    // Both halves of each are asked next.
    std::set<std::size_t> halves;
    std::size_t shift = 0;
    for (const std::size_t k : far) {
      halves.insert(k + shift);
      halves.insert(k + ++shift);
    }
    far = std::move(halves);
  }
}

/// Adds the middles of triangles and of edges inside the piece that are far from the surface.
bool SurfaceBuilder::add_far_points(const Job& job, const Layout& layout, double deviation,
                                    PlanarPiece& planar) {
  using kernel::operator+;
  using kernel::operator*;
  Barycentric w;
  for (std::size_t i = 0; i < 4; ++i) w[i] = job.cell.witness.w[i];
  const auto on_surface = [&](const std::array<double, 2>& p) {
    return in_space(job.cell, lifted(job.cell.corners, unfolded(layout, p), w));
  };
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < planar.points.size(); ++i)
    places.push_back(i < layout.at.size() ? in_space(job.cell, layout.at[i])
                                          : on_surface(planar.points[i]));
  std::set<std::array<std::size_t, 2>> rim;
  for (const auto& loop : planar.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto [a, b] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
      rim.insert({a, b});
    }
  std::set<std::array<std::size_t, 2>> asked;
  std::vector<std::array<double, 2>> more;
  for (const auto& t : job.triangles) {
    bool far = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      if (rim.contains({a, b})) continue;
      const auto &p = planar.points[a], &q = planar.points[b];
      const std::array<double, 2> m = {0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])};
      if (distance_to_segment(on_surface(m), places[a], places[b]) <= deviation) continue;
      far = true;
      if (asked.insert({a, b}).second) more.push_back(m);
    }
    if (far) continue;
    const auto &p = planar.points[t[0]], &q = planar.points[t[1]], &r = planar.points[t[2]];
    const std::array<double, 2> m = {(p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3};
    if (distance_to_plane(on_surface(m), places[t[0]], places[t[1]], places[t[2]]) > deviation)
      more.push_back(m);
  }
  for (const auto& m : more) {
    planar.points.push_back(m);
    planar.facets.push_back(0);
  }
  return !more.empty();
}

void SurfaceBuilder::refine_inside(Job& job, double deviation) {
  constexpr std::size_t most = 4096;  // points of one piece
  if (!job.done) return;
  Layout layout;
  lay_out(job, layout);
  while (job.planar.points.size() < most) {
    PlanarPiece finer = job.planar;
    if (!add_far_points(job, layout, deviation, finer)) return;
    auto triangles = triangulate(finer);
    if (!triangles || !missed(job, layout, finer).empty()) return;
    job.planar = std::move(finer);
    job.triangles = std::move(*triangles);
  }
}

}  // namespace crest::modes
