// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/contours.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include <numbers>

#include "algorithms/line_art/contour_scan.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::line_art {
namespace {

using kernel::cross, kernel::dot;
using kernel::Decision, kernel::Sign, kernel::Stage;
using kernel::operator-, kernel::operator*;

using Range = tbb::blocked_range<Index>;

FaceSides face_sides(const Scene& scene, const kernel::Sight& sight, kernel::SightCounts& counts) {
  const auto faces = static_cast<Index>(scene.faces.size());
  FaceSides sides{std::vector<std::int8_t>(faces), std::vector<std::uint8_t>(faces)};
  tbb::enumerable_thread_specific<kernel::SightCounts> parts;
  kernel::parallel_for(Range(0, faces, 2048), [&](const Range& range) {
    kernel::SightCounts& part = parts.local();
    for (Index f = range.begin(); f != range.end(); ++f) {
      const auto [p, q, r] = scene.faces[f];
      const Decision d = sight.side(p, q, r, part);
      sides.sign[f] = static_cast<std::int8_t>(d.sign);
      sides.flat[f] = d.stage == Stage::symbolic ? 1 : 0;
    }
  });
  for (const kernel::SightCounts& part : parts) counts += part;
  return sides;
}

/// [e, low, high, opposite] from the face's own sign, by the parity of its corners' order.
int sign_at(const Scene& scene, const FaceSides& sides, Index low, const EdgeSide& side) {
  const kernel::Triangle& f = scene.faces[side.face];
  const std::size_t k = f[0] == side.opposite ? 0 : f[1] == side.opposite ? 1 : 2;
  return f[(k + 1) % 3] == low ? sides.sign[side.face] : -sides.sign[side.face];
}

/// Is the angle between the normals of an edge's two faces, turned alike, above the given one: a
/// matter of taste, in double.
bool sharp(const Scene& scene, Index low, Index high, Index left, Index right, double degrees) {
  const Vec3 &v = scene.points[low], &w = scene.points[high];
  const Vec3 m = cross(w - v, scene.points[left] - v), n = cross(scene.points[right] - v, w - v);
  const double cosine = std::cos(degrees * std::numbers::pi / 180);
  return dot(m, n) < cosine * std::sqrt(dot(m, m)) * std::sqrt(dot(n, n));
}

std::vector<ContourEdge> drawn_edges(const Scene& scene, const FaceSides& sides,
                                     const ContourOptions& options) {
  const SceneEdges all = edges_of(scene);
  std::vector<ContourEdge> drawn;
  for (const SceneEdges::Edge& e : all.edges) {
    Index left = 0, right = 0;
    int flat = 0;  // L - R of the faces that are not seen edge-on
    for (Index i = e.begin; i < e.end; ++i) {
      const int sign = sign_at(scene, sides, e.low, all.sides[i]);
      ++(sign > 0 ? left : right);
      if (sides.flat[all.sides[i].face] == 0) flat += sign;
    }
    const bool occluding = left != right, rim = !occluding && flat != 0;
    const Index count = e.end - e.begin;
    const bool crease = options.crease && !occluding && !rim &&
                        (count > 2 || sharp(scene, e.low, e.high, all.sides[e.begin].opposite,
                                            all.sides[e.begin + 1].opposite, *options.crease));
    if (occluding || rim || crease)
      drawn.push_back({e.low, e.high, left, right, occluding, rim, count == 1, crease});
  }
  return drawn;
}

/// The parts of one range of edges, to be joined in their order.
struct Part {
  std::vector<Piece> pieces;
  std::vector<SightEvent> events;
};

constexpr Index kPart = 64;  // edges

void count(Contours& contours) {
  ContourCounts& c = contours.counts;
  for (const ContourEdge& e : contours.edges) {
    c.edges += e.occluding;
    c.creases += e.crease;
    c.edge_on += e.rim;
    for (Index i = e.first_piece; i < e.first_piece + e.pieces; ++i) {
      const Piece& p = contours.pieces[i];
      c.contact += p.in_front > 0 && p.drawn();
      if (!e.occluding) continue;
      ++c.pieces;
      ++(p.in_front == 0 ? c.visible : c.hidden);
    }
    if (!e.occluding) continue;
    for (Index i = e.first_event; i < e.first_event + e.events; ++i) {
      c.crossings += contours.events[i].kind == SightEvent::Kind::crossing;
      c.piercings += contours.events[i].kind == SightEvent::Kind::piercing;
    }
  }
}

/// Vertices whose first two occluding edges begin behind different numbers of the faces around it.
std::size_t count_cusps(const Contours& contours, const std::vector<Index>& at_a,
                        const std::vector<Index>& at_b, std::size_t vertices) {
  std::vector<Index> degree(vertices, 0), first(vertices, 0);
  std::size_t cusps = 0;
  for (std::size_t i = 0; i < contours.edges.size(); ++i) {
    const ContourEdge& e = contours.edges[i];
    if (!e.occluding) continue;
    for (const auto& [v, n] : {std::pair{e.a, at_a[i]}, {e.b, at_b[i]}}) {
      if (degree[v] == 0) first[v] = n;
      cusps += degree[v] == 1 && first[v] != n;
      ++degree[v];
    }
  }
  return cusps;
}

}  // namespace

Contours find_contours(const Scene& scene, const View& view, const ContourOptions& options) {
  Contours result;
  FaceSides sides = face_sides(scene, kernel::Sight(view.eye, scene.points), result.decisions);
  std::vector<ContourEdge> drawn = drawn_edges(scene, sides, options);
  const ScanScene shared(scene, view, std::move(drawn), std::move(sides));
  result.edges = shared.edges;
  const auto edges = static_cast<Index>(result.edges.size());

  std::vector<Index> ends;
  for (const ContourEdge& e : result.edges) ends.insert(ends.end(), {e.a, e.b});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<Index> far(scene.points.size(), 0), at_a(edges), at_b(edges);
  tbb::enumerable_thread_specific<EdgeScan> scans([&] { return EdgeScan(shared); });
  kernel::parallel_for(Range(0, static_cast<Index>(ends.size()), kPart), [&](const Range& range) {
    EdgeScan& scan = scans.local();
    for (Index i = range.begin(); i != range.end(); ++i) far[ends[i]] = scan.faces_before(ends[i]);
  });

  std::vector<Part> parts((edges + kPart - 1) / kPart);
  kernel::parallel_for(Range(0, static_cast<Index>(parts.size())), [&](const Range& range) {
    EdgeScan& scan = scans.local();
    for (Index p = range.begin(); p != range.end(); ++p)
      for (Index i = p * kPart; i < std::min(edges, (p + 1) * kPart); ++i) {
        ContourEdge& e = result.edges[i];
        scan.scan(i, far);
        e.start = scan.start;
        e.end_on = shared.sight.end_on(e.a, e.b);
        e.pieces = static_cast<Index>(scan.pieces.size());
        e.events = static_cast<Index>(scan.events.size());
        at_a[i] = scan.start - far[e.a];
        at_b[i] = scan.finish - far[e.b];
        parts[p].pieces.insert(parts[p].pieces.end(), scan.pieces.begin(), scan.pieces.end());
        parts[p].events.insert(parts[p].events.end(), scan.events.begin(), scan.events.end());
      }
  });
  for (const Part& part : parts) {
    result.pieces.insert(result.pieces.end(), part.pieces.begin(), part.pieces.end());
    result.events.insert(result.events.end(), part.events.begin(), part.events.end());
  }
  Index piece = 0, event = 0;
  for (ContourEdge& e : result.edges) {
    e.first_piece = piece;
    e.first_event = event;
    piece += e.pieces;
    event += e.events;
  }
  for (const EdgeScan& scan : scans) result.decisions += scan.counts;
  count(result);
  result.counts.cusps = count_cusps(result, at_a, at_b, scene.points.size());
  return result;
}

}  // namespace crest::line_art
