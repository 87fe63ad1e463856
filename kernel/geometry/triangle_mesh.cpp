// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/triangle_mesh.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "kernel/geometry/disjoint_sets.hpp"
#include "kernel/geometry/mesh_checks.hpp"
#include "kernel/geometry/parallel.hpp"
#include "kernel/predicates/collinear.hpp"

namespace crest::kernel {
namespace {

/// check(i) for all i below count. Throws: what the lowest i throws that throws.
template <class Check>
void for_all(Index count, const Check& check) {
  const Index failed = kernel::parallel_reduce(
      tbb::blocked_range<Index>(0, count, 8192), kNone,
      [&](const auto& part, Index first) {
        Index i = part.begin();
        try {
          for (; i != part.end(); ++i) check(i);
        } catch (const InputError&) {
          return std::min(first, i);
        }
        return first;
      },
      [](Index a, Index b) { return std::min(a, b); });
  if (failed != kNone) check(failed);
}

void require_proper_faces(const std::vector<Vec3>& points, const std::vector<Triangle>& faces) {
  if (faces.empty()) throw InputError("mesh: it has no faces; give a triangle mesh");
  if (faces.size() >= kNone / 3)  // numbers of half-edges have 32 bits
    throw InputError("mesh: it has more than 1.4 billion faces; give a part of it");
  for_all(static_cast<Index>(faces.size()), [&](Index f) {
    require_three_vertices(f, faces[f], points.size());
    const auto [a, b, c] = faces[f];
    if (collinear(points[a], points[b], points[c]))
      throw InputError(name("face", f) + ": its area is exactly zero; remove degenerate faces");
  });
}

/// A half-edge seen from its smaller vertex: side half % 3 of face half / 3.
struct Half {
  Index other, half;
  Index face() const { return half / 3; }
};

struct HalfBuckets {
  std::vector<Index> begin;  ///< V + 1
  std::vector<Half> halves;  ///< 3F, grouped by smaller vertex, sorted by other
  std::vector<Index> edges;  ///< V + 1: how many edges the buckets before have

  std::span<const Half> of(Index v) const {
    return {halves.data() + begin[v], halves.data() + begin[v + 1]};
  }
};

/// Buckets hold about three halves: insertion sort. Returns how many different edges there are.
Index sort_bucket(std::span<Half> bucket) {
  Index different = 0;
  for (std::size_t i = 0; i < bucket.size(); ++i)
    for (std::size_t j = i; j > 0 && bucket[j].other < bucket[j - 1].other; --j)
      std::swap(bucket[j], bucket[j - 1]);
  for (std::size_t i = 0; i < bucket.size(); ++i)
    different += i == 0 || bucket[i].other != bucket[i - 1].other;
  return different;
}

HalfBuckets bucket_halves(Index vertices, const std::vector<Triangle>& faces) {
  HalfBuckets b;
  b.begin.assign(vertices + 1, 0);
  for (const Triangle& t : faces)
    for (std::size_t k = 0; k < 3; ++k) ++b.begin[std::min(t[k], t[(k + 1) % 3]) + 1];
  std::partial_sum(b.begin.begin(), b.begin.end(), b.begin.begin());
  b.halves.resize(3 * faces.size());
  b.edges.assign(b.begin.begin(), b.begin.end() - 1);  // the next places
  for (Index f = 0; f < faces.size(); ++f)
    for (Index k = 0; k < 3; ++k) {
      const Index p = faces[f][k], q = faces[f][(k + 1) % 3];
      b.halves[b.edges[std::min(p, q)]++] = {std::max(p, q), 3 * f + k};
    }
  b.edges.assign(vertices + 1, 0);
  for_all(vertices, [&](Index v) {
    b.edges[v + 1] = sort_bucket({b.halves.data() + b.begin[v], b.halves.data() + b.begin[v + 1]});
  });
  std::partial_sum(b.edges.begin(), b.edges.end(), b.edges.begin());
  return b;
}

/// Of halves between the same two vertices. Throws InputError.
Edge edge_of(std::span<const Half> halves, Index v, const std::vector<Triangle>& faces) {
  const Index w = halves[0].other;
  Edge e{v, w, kNone, kNone};
  for (std::size_t n = 0; n < halves.size(); ++n) {
    const Index f = halves[n].face();
    const bool direct = faces[f][halves[n].half % 3] == v;
    Index& slot = direct ? e.f0 : e.f1;
    if (n >= 2)
      throw InputError(edge_name(v, w) + ": it has more than two faces; make it manifold");
    if (slot != kNone) {
      if (same_corners(faces[slot], faces[f]))
        throw InputError(name("face", f) + ": it duplicates face " + std::to_string(slot) +
                         "; remove duplicate faces");
      throw InputError(edge_name(v, w) +
                       ": its two faces are oriented inconsistently; orient the mesh");
    }
    slot = f;
  }
  if (e.f0 != kNone && e.f1 != kNone && same_corners(faces[e.f0], faces[e.f1]))
    throw InputError(name("face", std::max(e.f0, e.f1)) + ": it duplicates face " +
                     std::to_string(std::min(e.f0, e.f1)) + " reversed; remove one of them");
  return e;
}

[[noreturn]] void refuse_fan(Index v) {
  throw InputError(name("vertex", v) + ": several fans of faces meet in it; split it");
}

/// Names the vertex in which, by the order of faces, a second open fan is met first.
void refuse_fans(const TriangleMesh& mesh) {
  std::vector<bool> met(mesh.vertex_count());
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (int k = 0; k < 3; ++k) {
      if (mesh.neighbour(f, k) != kNone) continue;
      const Index v = mesh.faces()[f][static_cast<std::size_t>(k)];
      if (met[v]) refuse_fan(v);
      met[v] = true;
    }
}

}  // namespace

TriangleMesh::TriangleMesh(std::vector<Vec3> points, std::vector<Triangle> faces)
    : points_(std::move(points)), faces_(std::move(faces)) {
  for (Index v = 0; v < points_.size(); ++v) require_finite(v, points_[v]);
  require_proper_faces(points_, faces_);
  build_edges();
  parallel_invoke([this] { build_rings(); }, [this] { count_components_and_loops(); });
}

void TriangleMesh::build_edges() {
  const HalfBuckets b = bucket_halves(vertex_count(), faces_);
  face_edges_.resize(faces_.size());
  edges_.resize(b.edges.back());
  for_all(vertex_count(), [&](Index v) {
    Index number = b.edges[v];
    for (std::span<const Half> left = b.of(v); !left.empty(); ++number) {
      std::size_t n = 1;
      while (n < left.size() && left[n].other == left[0].other) ++n;
      edges_[number] = edge_of(left.first(n), v, faces_);
      for (const Half& h : left.first(n)) face_edges_[h.face()][h.half % 3] = number;
      left = left.subspan(n);
    }
  });
}

void TriangleMesh::build_rings() {
  const Index n = vertex_count();
  // A start corner per vertex: in the face of lowest index, or where the fan opens.
  std::vector<Index> start(n, kNone), degree(n, 0);
  for (Index f = 0; f < face_count(); ++f)
    for (const Index v : faces_[f])
      if (++degree[v] == 1) start[v] = f;
  boundary_vertex_.assign(n, 0);
  bool several = false;
  for (const Edge& e : edges_) {
    if (e.f0 != kNone && e.f1 != kNone) continue;
    const Index v = e.f1 == kNone ? e.v0 : e.v1;
    several = several || boundary_vertex_[v] != 0;
    boundary_vertex_[v] = 1;
    start[v] = e.f1 == kNone ? e.f0 : e.f1;
  }
  if (several) refuse_fans(*this);
  ring_begin_.assign(n + 1, 0);
  for (Index v = 0; v < n; ++v) {
    if (degree[v] == 0)
      throw InputError(name("vertex", v) + ": it belongs to no face; remove isolated vertices");
    ring_begin_[v + 1] = ring_begin_[v] + degree[v] + boundary_vertex_[v];
  }
  ring_.resize(ring_begin_[n]);
  fan_.resize(ring_begin_[n], kNone);
  for_all(n, [&](Index v) {
    Index f = start[v], at = ring_begin_[v], seen = 0;
    do {
      const Triangle& t = faces_[f];
      const std::size_t k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      fan_[at] = f;
      ring_[at++] = t[(k + 1) % 3];
      ++seen;
      const Index next = neighbour(f, static_cast<int>((k + 2) % 3));
      if (next == kNone) ring_[at++] = t[(k + 2) % 3];
      f = next;
    } while (f != kNone && f != start[v] && seen < degree[v]);
    if (seen != degree[v]) refuse_fan(v);
  });
}

void TriangleMesh::count_components_and_loops() {
  DisjointSets parts(vertex_count()), borders(vertex_count());
  Index boundary_edges = 0;
  for (const Edge& e : edges_) {
    parts.unite(e.v0, e.v1);
    if (e.f0 != kNone && e.f1 != kNone) continue;
    borders.unite(e.v0, e.v1);
    ++boundary_edges;
  }
  components_ = parts.count();
  // A boundary vertex has exactly two boundary edges, so boundary components are loops with as many
  // vertices as edges; every other vertex is a set of its own.
  boundary_loops_ = borders.count() - (vertex_count() - boundary_edges);
}

}  // namespace crest::kernel
