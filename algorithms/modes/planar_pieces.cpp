// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/planar_pieces.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <exception>
#include <numbers>

namespace crest::modes {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_tag>;
using Triangles = std::vector<std::array<std::size_t, 3>>;

/// Face info: how many constraints lie between the face and infinity.
void find_nesting(Triangulation& t) {
  for (auto f = t.all_faces_begin(); f != t.all_faces_end(); ++f) f->info() = -1;
  std::deque<std::pair<Triangulation::Face_handle, int>> queue{{t.infinite_face(), 0}};
  while (!queue.empty()) {
    const auto [face, level] = queue.front();
    queue.pop_front();
    if (face->info() >= 0) continue;
    face->info() = level;
    for (int i = 0; i < 3; ++i) {
      const bool wall = face->is_constrained(i);
      if (face->neighbor(i)->info() >= 0) continue;
      if (wall)
        queue.emplace_back(face->neighbor(i), level + 1);
      else
        queue.emplace_front(face->neighbor(i), level);
    }
  }
}

bool insert_loops(Triangulation& t, const PlanarPiece& piece) {
  std::vector<Triangulation::Vertex_handle> handles(piece.points.size());
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    handles[i] = t.insert({piece.points[i][0], piece.points[i][1]});
    handles[i]->info() = i;
  }
  if (t.number_of_vertices() != piece.points.size()) return false;
  std::size_t walls = 0;
  for (const auto& loop : piece.loops)
    for (std::size_t i = 0; i < loop.size(); ++i, ++walls)
      t.insert_constraint(handles[loop[i]], handles[loop[(i + 1) % loop.size()]]);
  // A constraint through a vertex has become two.
  std::size_t found = 0;
  for (const auto& e : t.finite_edges()) found += t.is_constrained(e) ? 1 : 0;
  return found == walls;
}

/// One point on a diagonal with both ends on one facet, the first by its ends: CGAL's order of
/// edges is one of addresses. False if there is none.
bool mend_diagonal(Triangulation& t, PlanarPiece& piece) {
  using Ends = std::pair<std::size_t, std::size_t>;
  std::optional<Ends> first;
  for (const auto& e : t.finite_edges()) {
    if (t.is_constrained(e) || e.first->info() != 1) continue;
    const Ends ends = std::minmax<std::size_t>(
        {e.first->vertex(t.ccw(e.second))->info(), e.first->vertex(t.cw(e.second))->info()});
    if ((piece.facets[ends.first] & piece.facets[ends.second]) != 0 && (!first || ends < *first))
      first = ends;
  }
  if (!first) return false;
  const auto &a = piece.points[first->first], &b = piece.points[first->second];
  const std::array<double, 2> p = {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
  const std::size_t before = t.number_of_vertices();
  const auto v = t.insert({p[0], p[1]});
  if (t.number_of_vertices() == before) return false;
  v->info() = piece.points.size();
  piece.points.push_back(p);
  piece.facets.push_back(0);
  return true;
}

/// From the centroid, if it sees the whole loop. All triangles turn alike and the loop goes round
/// once: it crosses the ray to the right once upwards.
std::optional<Triangles> star(PlanarPiece& piece) {
  const auto& loop = piece.loops[0];
  const std::size_t n = loop.size();
  const auto at = [&](std::size_t i) { return piece.points[loop[i % n]]; };
  const auto origin = at(0);
  double area = 0, x = 0, y = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto p = at(i), q = at(i + 1);
    const double a =
        (p[0] - origin[0]) * (q[1] - origin[1]) - (p[1] - origin[1]) * (q[0] - origin[0]);
    area += a;
    x += a * (p[0] + q[0] - 2 * origin[0]);
    y += a * (p[1] + q[1] - 2 * origin[1]);
  }
  if (area == 0) return std::nullopt;
  const std::array<double, 2> centre = {origin[0] + x / (3 * area), origin[1] + y / (3 * area)};
  const auto point = [](const std::array<double, 2>& p) { return Kernel::Point_2(p[0], p[1]); };
  const auto turn = area > 0 ? CGAL::LEFT_TURN : CGAL::RIGHT_TURN;
  const std::size_t c = piece.points.size();
  Triangles triangles;
  std::size_t upwards = 0, downwards = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto p = at(i), q = at(i + 1);
    if (CGAL::orientation(point(centre), point(p), point(q)) != turn) return std::nullopt;
    upwards += p[1] <= centre[1] && q[1] > centre[1] ? 1 : 0;
    downwards += q[1] <= centre[1] && p[1] > centre[1] ? 1 : 0;
    if (area > 0)
      triangles.push_back({c, loop[i], loop[(i + 1) % n]});
    else
      triangles.push_back({c, loop[(i + 1) % n], loop[i]});
  }
  if (upwards != 1 || downwards != 1) return std::nullopt;
  piece.points.push_back(centre);
  piece.facets.push_back(0);
  return triangles;
}

/// A diagonal that has not both ends on one facet and is inside: the sums of angles at its ends
/// stay below a full turn, so two positive triangles make a simple polygon.
std::optional<Triangles> quadrangle(const PlanarPiece& piece) {
  const auto& loop = piece.loops[0];
  const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
    const auto point = [&](std::size_t i) {
      return Kernel::Point_2(piece.points[loop[i]][0], piece.points[loop[i]][1]);
    };
    return CGAL::orientation(point(a), point(b), point(c));
  };
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t a = k, b = k + 1, c = k + 2, d = (k + 3) % 4;
    if ((piece.facets[loop[a]] & piece.facets[loop[c]]) != 0) continue;
    const auto first = turn(a, b, c);
    if (first == CGAL::COLLINEAR || first != turn(a, c, d)) continue;
    if (first == CGAL::LEFT_TURN)
      return Triangles{{loop[a], loop[b], loop[c]}, {loop[a], loop[c], loop[d]}};
    return Triangles{{loop[a], loop[c], loop[b]}, {loop[a], loop[d], loop[c]}};
  }
  return std::nullopt;
}

Triangles domain(const Triangulation& t) {
  Triangles r;
  for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
    if (f->info() == 1)
      r.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return r;
}

std::size_t boundary_size(const PlanarPiece& piece) {
  std::size_t n = 0;
  for (const auto& loop : piece.loops) n += loop.size();
  return n;
}

/// By a constrained Delaunay triangulation. Throws what CGAL does for constraints that cross.
std::optional<Triangles> constrained(PlanarPiece& piece) {
  const std::size_t given = boundary_size(piece);
  Triangulation t;
  if (!insert_loops(t, piece)) return std::nullopt;
  find_nesting(t);
  for (std::size_t k = 0; k < 4 * given && mend_diagonal(t, piece); ++k) find_nesting(t);
  Triangles r = domain(t);
  // Euler: so many triangles has a connected domain with these boundaries.
  const std::size_t inner = piece.points.size() - given;
  if (r.size() + 4 != given + 2 * piece.loops.size() + 2 * inner) return std::nullopt;
  return r;
}

}  // namespace

std::optional<Triangles> triangulate(PlanarPiece& piece) {
  const std::size_t given = piece.points.size();
  const bool plain = given == boundary_size(piece);
  if (plain && given == 3) {
    const auto& p = piece.points[0];
    const auto& q = piece.points[1];
    const auto& r = piece.points[2];
    const auto turn = CGAL::orientation(Kernel::Point_2(p[0], p[1]), Kernel::Point_2(q[0], q[1]),
                                        Kernel::Point_2(r[0], r[1]));
    if (turn == CGAL::COLLINEAR) return std::nullopt;
    if (turn == CGAL::LEFT_TURN) return Triangles{{0, 1, 2}};
    return Triangles{{0, 2, 1}};
  }
  if (plain && given == 4 && piece.loops.size() == 1)
    if (const auto r = quadrangle(piece)) return r;
  if (plain && piece.loops.size() == 1)
    if (const auto r = star(piece)) return r;
  try {
    return constrained(piece);
  } catch (const std::exception&) {  // constraints that cross
    return std::nullopt;
  }
}

PlanarPiece laid_out(const PlanarPiece& piece) {
  PlanarPiece r = piece;
  r.points.assign(piece.points.size(), {0, 0});
  const auto circle = [&](const std::vector<std::size_t>& loop, double x, double y, double radius) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const double a =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(loop.size());
      r.points[loop[i]] = {x + radius * std::cos(a), y + radius * std::sin(a)};
    }
  };
  circle(r.loops[0], 0, 0, 10);
  const auto holes = static_cast<double>(r.loops.size() - 1);
  for (std::size_t k = 1; k < r.loops.size(); ++k) {
    const double a = 2 * std::numbers::pi * static_cast<double>(k) / holes;
    circle(r.loops[k], 4 * std::cos(a), 4 * std::sin(a), holes > 1 ? 4 / holes : 2);
  }
  return r;
}

}  // namespace crest::modes
