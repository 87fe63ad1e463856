// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/surface_builder.hpp"

#include <algorithm>
#include <cmath>

namespace crest::modes {

using kernel::Vec3;

SurfaceBuilder::SurfaceBuilder(Faces& faces, const Level& level, Side side,
                               const std::vector<Vec3>& mesh_points,
                               const std::unordered_set<Index>& open_faces)
    : faces_(faces),
      level_(level),
      side_(side),
      function_(level, side),
      places_(mesh_points),
      open_faces_(open_faces),
      inside_of_(faces.arcs().size(), kNone),
      root_points_(faces.lines().root_count(), kNone) {
  surface_.sign = static_cast<int>(side);
  surface_.mode = surface_.sign * level.value();
}

namespace {

template <std::size_t N>
Symmetric interpolated(const Vertices& vertices, const std::array<Index, N>& corners,
                       const std::array<double, N>& b) {
  Symmetric r{};
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t k = 0; k < 6; ++k) r[k] += b[i] * vertices.tensor(corners[i]).t[k];
  return r;
}

}  // namespace

const Vec3& SurfaceBuilder::place(Index vertex) {
  for (auto v = static_cast<Index>(places_.size()); v <= vertex; ++v) {
    const Cut& c = faces_.vertices().cut(v);
    Vec3 p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = (64 - c.n) / 64.0 * places_[c.a][k] + c.n / 64.0 * places_[c.b][k];
    places_.push_back(p);
  }
  return places_[vertex];
}

Index SurfaceBuilder::add_point(const Vec3& p, const Symmetric& t) {
  surface_.points.push_back(p);
  surface_.tensors.push_back(t);
  return static_cast<Index>(surface_.points.size() - 1);
}

Index SurfaceBuilder::root_point(Index root) {
  Index& point = root_points_[root];
  if (point == kNone) {
    const Root& r = faces_.lines().root(root);
    const auto& line = faces_.lines().line(r.line);
    const Vec3 a = place(line.a), b = place(line.b);
    Vec3 p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = (1 - r.t) * a[k] + r.t * b[k];
    point = add_point(p, interpolated<2>(faces_.vertices(), {line.a, line.b}, {1 - r.t, r.t}));
  }
  return point;
}

Index SurfaceBuilder::arc_point(Index arc, std::size_t k) {
  ArcPoint& a = inside(arc)[k];
  if (a.point == kNone) {
    const auto corners = faces_.face(faces_.arcs()[arc].face).corners;
    Vec3 p{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t c = 0; c < 3; ++c) p[c] += a.at[i] * place(corners[i])[c];
    a.point = add_point(p, interpolated(faces_.vertices(), corners, a.at));
  }
  return a.point;
}

/// The point of the line base + x w, inside the simplex, where the level is crossed.
template <std::size_t N>
std::array<double, N> SurfaceBuilder::lifted(const std::array<Index, N>& corners,
                                             std::array<double, N> base,
                                             const std::array<double, N>& w, bool* crosses) const {
  double low = -HUGE_VAL, high = HUGE_VAL;
  for (std::size_t i = 0; i < N; ++i) {
    if (w[i] == 0) continue;
    const double x = -base[i] / w[i];
    if (w[i] > 0)
      low = std::fmax(low, x);
    else
      high = std::fmin(high, x);
  }
  const auto at = [&](double x) {
    std::array<double, N> b = base;
    for (std::size_t i = 0; i < N; ++i) b[i] = std::fmax(0, b[i] + x * w[i]);
    return b;
  };
  if (crosses) {
    const Symmetric a = interpolated(faces_.vertices(), corners, at(low)),
                    b = interpolated(faces_.vertices(), corners, at(high));
    constexpr double slack = 1e-13;  // of the mode: where the line only touches the cell's edge
    *crosses = function_.height(a) <= slack * std::pow(product(a, a), 1.5) &&
               function_.height(b) >= -slack * std::pow(product(b, b), 1.5);
  }
  for (int i = 0; i < 80 && low < high; ++i) {
    const double x = 0.5 * (low + high);
    if (!(x > low && x < high)) break;
    (function_.height(interpolated(faces_.vertices(), corners, at(x))) < 0 ? low : high) = x;
  }
  return at(0.5 * (low + high));
}

std::array<double, 3> SurfaceBuilder::root_in_face(Index root, Index f) const {
  const Face& face = faces_.face(f);
  const Root& r = faces_.lines().root(root);
  for (std::size_t k = 0; k < 3; ++k) {
    const Edge& edge = faces_.edge(face.edges[k]);
    if (edge.line != r.line) continue;
    const double begin = edge.from, end = edge.to;
    constexpr double room = 1e-13;  // of the edge: a root next to its end is not in its end
    double s = std::clamp((r.t - begin) / (end - begin), room, 1 - room);
    if (edge.first != face.corners[k]) s = 1 - s;
    std::array<double, 3> b{};
    b[k] = 1 - s;
    b[(k + 1) % 3] = s;
    return b;
  }
  return {1 / 3.0, 1 / 3.0, 1 / 3.0};
}

/// Two faces at a line may both join the same two roots of it: their chords would be one edge.
void SurfaceBuilder::bend(Index arc) {
  const auto& [from, to] = faces_.arcs()[arc].roots;
  const auto& lines = faces_.lines();
  if (lines.root(from).line == lines.root(to).line && inside_of_[arc] == kNone) refine(arc, {0});
}

void SurfaceBuilder::add_cell(Index number, const Cell& cell, int orientation,
                              std::vector<Piece> pieces) {
  for (Piece& piece : pieces) {
    for (const Loop& loop : piece)
      for (const LoopArc& a : loop) bend(a.arc);
    jobs_.push_back({number, cell, orientation, std::move(piece), 0, false, {}, {}});
  }
}

SurfaceBuilder::Barycentric SurfaceBuilder::in_cell(const Cell& cell,
                                                    std::unordered_map<Index, Barycentric>& known,
                                                    Index vertex) const {
  for (std::size_t i = 0; i < 4; ++i)
    if (cell.corners[i] == vertex) {
      Barycentric b{};
      b[i] = 1;
      return b;
    }
  if (const auto found = known.find(vertex); found != known.end()) return found->second;
  const Cut& c = faces_.vertices().cut(vertex);
  const Barycentric a = in_cell(cell, known, c.a), b = in_cell(cell, known, c.b);
  Barycentric r;
  for (std::size_t i = 0; i < 4; ++i) r[i] = (64 - c.n) / 64.0 * a[i] + c.n / 64.0 * b[i];
  return known[vertex] = r;
}

/// The loops' points: in the cell's barycentrics, and projected along w.
void SurfaceBuilder::lay_out(const Job& job, Layout& r) {
  r.planar.points.clear();
  r.planar.facets.clear();
  r.planar.loops.clear();
  r.at.clear();
  r.points.clear();
  r.parts.clear();
  std::unordered_map<Index, Barycentric> known;
  const auto add = [&](Index f, const std::array<double, 3>& at, Index point) {
    Barycentric b{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Barycentric c = in_cell(job.cell, known, faces_.face(f).corners[i]);
      for (std::size_t k = 0; k < 4; ++k) b[k] += at[i] * c[k];
    }
    r.at.push_back(b);
    r.points.push_back(point);
    std::uint8_t facets = 0;
    for (std::size_t k = 0; k < 4; ++k)
      if (b[k] == 0) facets = static_cast<std::uint8_t>(facets | 1U << k);
    r.planar.facets.push_back(facets);
    r.planar.loops.back().push_back(r.at.size() - 1);
  };
  for (const Loop& loop : job.piece) {
    r.planar.loops.emplace_back();
    for (const LoopArc& a : loop) {
      const Arc& arc = faces_.arcs()[a.arc];
      const Index root = arc.roots[a.forward ? 0 : 1];
      add(arc.face, root_in_face(root, arc.face), root_point(root));
      const auto points = inside(a.arc);
      const std::size_t n = points.size();
      for (std::size_t k = 0; k <= n; ++k) r.parts.emplace_back(a.arc, a.forward ? k : n - k);
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = a.forward ? i : n - 1 - i;
        add(arc.face, points[k].at, arc_point(a.arc, k));
      }
    }
  }
  const auto& w = job.cell.witness.w;
  std::size_t drop = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (std::abs(w[i]) > std::abs(w[drop])) drop = i;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (i != drop) r.order[n++] = i;
  r.order[3] = drop;
  for (const Barycentric& b : r.at) {
    const double k = b[drop] / w[drop];
    r.planar.points.push_back(
        {b[r.order[0]] - k * w[r.order[0]], b[r.order[1]] - k * w[r.order[1]]});
  }
}

/// A point of the line along w that the planar point stands for.
SurfaceBuilder::Barycentric SurfaceBuilder::unfolded(const Layout& layout,
                                                     const std::array<double, 2>& p) {
  Barycentric b{};
  b[layout.order[0]] = p[0];
  b[layout.order[1]] = p[1];
  b[layout.order[2]] = 1 - p[0] - p[1];
  return b;
}

/// A point of the surface on a segment from b: to the nearest corner, or point between two of the
/// loops' points, on the other side. That keeps the mode where a projection has failed.
SurfaceBuilder::Barycentric SurfaceBuilder::pulled(const Job& job, const Layout& layout,
                                                   const Barycentric& b) const {
  const auto height = [&](const Barycentric& x) {
    return function_.height(interpolated(faces_.vertices(), job.cell.corners, x));
  };
  const auto mixed = [](const Barycentric& x, const Barycentric& y, double s) {
    Barycentric r;
    for (std::size_t k = 0; k < 4; ++k) r[k] = (1 - s) * x[k] + s * y[k];
    return r;
  };
  const bool below = height(b) < 0;
  Barycentric to = b;
  double least = HUGE_VAL;
  const auto offer = [&](const Barycentric& x) {
    double d = 0;
    for (std::size_t k = 0; k < 4; ++k) d += (x[k] - b[k]) * (x[k] - b[k]);
    if (d >= least || (height(x) < 0) == below) return;
    least = d;
    to = x;
  };
  for (std::size_t k = 0; k < 4; ++k) {
    Barycentric corner{};
    corner[k] = 1;
    offer(corner);
  }
  const std::size_t n = layout.at.size(), step = n / 32 + 1;
  for (std::size_t i = 0; i < n; i += step)
    for (std::size_t k = 0; k < i; k += step) offer(mixed(layout.at[i], layout.at[k], 0.5));
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double s = 0.5 * (low + high);
    ((height(mixed(b, to, s)) < 0) == below ? low : high) = s;
  }
  return mixed(b, to, low);
}

/// Appends the triangles, new points lifted along w.
void SurfaceBuilder::emit(const Job& job, Layout& layout, const PlanarPiece& planar,
                          const std::vector<std::array<std::size_t, 3>>& triangles, bool lift) {
  Barycentric w;
  for (std::size_t i = 0; i < 4; ++i) w[i] = job.cell.witness.w[i];
  const auto [x, y, other, drop] = layout.order;
  for (std::size_t i = layout.at.size(); i < planar.points.size(); ++i) {
    Barycentric b{};
    bool crosses = false;
    if (lift) {
      b = lifted(job.cell.corners, unfolded(layout, planar.points[i]), w, &crosses);
    } else {
      for (const Barycentric& a : layout.at)
        for (std::size_t k = 0; k < 4; ++k) b[k] += a[k] / static_cast<double>(layout.at.size());
    }
    if (!crosses) b = pulled(job, layout, b);
    inner_[job.number].push_back(b);
    Vec3 p{};
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t c = 0; c < 3; ++c) p[c] += b[k] * place(job.cell.corners[k])[c];
    layout.points.push_back(add_point(p, interpolated(faces_.vertices(), job.cell.corners, b)));
  }
  // The sign of (e_x - e_other, e_y - e_other, w) in the barycentrics 1, 2, 3: whether
  // anticlockwise in the plane is so seen from above.
  std::array<Barycentric, 3> rows{};
  rows[0][x] = rows[1][y] = 1;
  rows[0][other] = rows[1][other] = -1;
  rows[2] = w;
  const auto& m = rows;
  const double det = m[0][1] * (m[1][2] * m[2][3] - m[1][3] * m[2][2]) -
                     m[0][2] * (m[1][1] * m[2][3] - m[1][3] * m[2][1]) +
                     m[0][3] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]);
  const bool turn = (det < 0) != (job.orientation < 0);
  for (const auto& t : triangles) {
    const Index a = layout.points[t[0]], b = layout.points[t[turn ? 2 : 1]],
                c = layout.points[t[turn ? 1 : 2]];
    surface_.triangles.push_back({a, b, c});
    surface_.tets.push_back(job.cell.tet);
  }
}

void SurfaceBuilder::mesh(const Job& job) {
  bool open = false;
  for (const Loop& loop : job.piece)
    for (const LoopArc& a : loop) open = count_segments(a.arc) || open;
  mesh_piece(job);
  touches_.resize(surface_.triangles.size(), open ? 1 : 0);
}

void SurfaceBuilder::mesh_piece(const Job& job) {
  Layout& layout = layout_;
  lay_out(job, layout);
  if (job.done) return emit(job, layout, job.planar, job.triangles, true);
  // As its loops say, but not proven to project injectively.
  ++surface_.unproven_pieces;
  PlanarPiece planar = layout.planar;
  if (const auto triangles = triangulate(planar))
    return emit(job, layout, planar, *triangles, true);
  planar = laid_out(layout.planar);
  if (const auto triangles = triangulate(planar)) emit(job, layout, planar, *triangles, false);
}

/// Counts the arc's segments if they are on the boundary; whether it is at an open cell.
bool SurfaceBuilder::count_segments(Index arc) {
  const Index f = faces_.arcs()[arc].face;
  const bool open = open_faces_.contains(f);
  if (faces_.face(faces_.face(f).whole).boundary && !open)
    boundary_segments_ += 1 + inside(arc).size();
  return open;
}

/// Whether the segment from a zero corner to a root lies in an open cell's face.
bool SurfaceBuilder::ends_open(Index zero, Index root) const {
  return open_spokes_.contains({zero, faces_.lines().root(root).line});
}

Index SurfaceBuilder::zero_point(Index vertex) {
  const auto [at, fresh] = zero_points_.try_emplace(vertex, kNone);
  if (fresh) {
    at->second = add_point(place(vertex), {});
    surface_.singular_points.push_back(place(vertex));
  }
  return at->second;
}

void SurfaceBuilder::add_cone(Index tet, Index apex, Index f) {
  faces_.for_each_arc(f, side_, [&](Index a) {
    cones_.push_back({tet, apex, a});
    bend(a);
  });
}

void SurfaceBuilder::add_fan(Index tet, Index zero_a, Index zero_b, Index e) {
  const RootRange range = faces_.roots(e);
  const RootNumbers list = faces_.lines().roots(faces_.edge(e).line);
  for (std::size_t i = 0; i < range.count; ++i) {
    const Index root = list[range.first + i];
    if (faces_.lines().root(root).side != side_) continue;
    if (ends_open(zero_a, root) || ends_open(zero_b, root))
      open_fans_.push_back(surface_.triangles.size());
    surface_.triangles.push_back({zero_point(zero_a), zero_point(zero_b), root_point(root)});
    surface_.tets.push_back(tet);
  }
}

void SurfaceBuilder::mesh(const ConeJob& job) {
  const Arc& arc = faces_.arcs()[job.arc];
  const bool open = count_segments(job.arc) || ends_open(job.apex, arc.roots[0]) ||
                    ends_open(job.apex, arc.roots[1]);
  std::vector<Index> line{root_point(arc.roots[0])};
  for (std::size_t k = 0; k < inside(job.arc).size(); ++k) line.push_back(arc_point(job.arc, k));
  line.push_back(root_point(arc.roots[1]));
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    surface_.triangles.push_back({zero_point(job.apex), line[k], line[k + 1]});
    surface_.tets.push_back(job.tet);
  }
  touches_.resize(surface_.triangles.size(), open ? 1 : 0);
}

std::unordered_map<Index, std::vector<std::array<double, 3>>> SurfaceBuilder::polylines() const {
  std::unordered_map<Index, std::vector<std::array<double, 3>>> r;
  for (Index arc = 0; arc < inside_of_.size(); ++arc)
    if (inside_of_[arc] != kNone)
      for (const ArcPoint& p : inside_[inside_of_[arc]]) r[arc].push_back(p.at);
  return r;
}

ModeSurface SurfaceBuilder::build(double deviation) {
  if (deviation > 0) {
    std::set<Index> arcs;
    for (const Job& job : jobs_)
      for (const Loop& loop : job.piece)
        for (const LoopArc& a : loop) arcs.insert(a.arc);
    for (const ConeJob& job : cones_) arcs.insert(job.arc);
    for (const Index a : arcs) straighten(a, deviation);
  }
  refine_all();
  if (deviation > 0)
    for (Job& job : jobs_) refine_inside(job, deviation);
  touches_.assign(surface_.triangles.size(), 0);
  for (const std::size_t fan : open_fans_) touches_[fan] = 1;
  for (const Job& job : jobs_) mesh(job);
  for (const ConeJob& job : cones_) mesh(job);
  return std::move(surface_);
}

template std::array<double, 3> SurfaceBuilder::lifted<3>(const std::array<Index, 3>&,
                                                         std::array<double, 3>,
                                                         const std::array<double, 3>&, bool*) const;
template std::array<double, 4> SurfaceBuilder::lifted<4>(const std::array<Index, 4>&,
                                                         std::array<double, 4>,
                                                         const std::array<double, 4>&, bool*) const;

}  // namespace crest::modes
