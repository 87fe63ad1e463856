// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/triangle_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "kernel/geometry/disjoint_sets.hpp"
#include "kernel/geometry/mesh_checks.hpp"
#include "kernel/predicates/collinear.hpp"

namespace crest::kernel {
namespace {

void require_proper_faces(const std::vector<Vec3>& points, const std::vector<Triangle>& faces) {
  if (faces.empty()) throw InputError("mesh: it has no faces; give a triangle mesh");
  for (Index f = 0; f < faces.size(); ++f) {
    require_three_vertices(f, faces[f], points.size());
    const auto [a, b, c] = faces[f];
    if (collinear(points[a], points[b], points[c]))
      throw InputError(name("face", f) + ": its area is exactly zero; remove degenerate faces");
  }
}

// A half-edge seen from its smaller vertex; direct: it runs from the smaller to the larger one.
struct Half {
  Index other, face;
  std::uint8_t side;
  bool direct;
};

struct HalfBuckets {
  std::vector<Index> begin;  // V + 1
  std::vector<Half> halves;  // 3F, grouped by smaller vertex, sorted by other
};

HalfBuckets bucket_halves(Index vertices, const std::vector<Triangle>& faces) {
  HalfBuckets b;
  b.begin.assign(vertices + 1, 0);
  for (const Triangle& t : faces)
    for (std::size_t k = 0; k < 3; ++k) ++b.begin[std::min(t[k], t[(k + 1) % 3]) + 1];
  std::partial_sum(b.begin.begin(), b.begin.end(), b.begin.begin());
  b.halves.resize(3 * faces.size());
  std::vector<Index> next(b.begin.begin(), b.begin.end() - 1);
  for (Index f = 0; f < faces.size(); ++f)
    for (std::uint8_t k = 0; k < 3; ++k) {
      const Index p = faces[f][k], q = faces[f][(k + 1u) % 3];
      b.halves[next[std::min(p, q)]++] = {std::max(p, q), f, k, p < q};
    }
  // Buckets hold about three halves: insertion sort.
  for (Index v = 0; v < vertices; ++v) {
    const auto first = b.halves.begin() + b.begin[v], last = b.halves.begin() + b.begin[v + 1];
    for (auto i = first; i != last; ++i)
      for (auto j = i; j != first && j->other < (j - 1)->other; --j) std::iter_swap(j, j - 1);
  }
  return b;
}

}  // namespace

TriangleMesh::TriangleMesh(std::vector<Vec3> points, std::vector<Triangle> faces)
    : points_(std::move(points)), faces_(std::move(faces)) {
  for (Index v = 0; v < points_.size(); ++v) require_finite(v, points_[v]);
  require_proper_faces(points_, faces_);
  build_edges();
  build_rings();
  count_components_and_loops();
}

void TriangleMesh::build_edges() {
  const HalfBuckets b = bucket_halves(vertex_count(), faces_);
  face_edges_.resize(faces_.size());
  edges_.reserve(b.halves.size() / 2 + 1);
  for (Index v = 0; v < vertex_count(); ++v) {
    for (Index i = b.begin[v]; i < b.begin[v + 1];) {
      const Index w = b.halves[i].other;
      Edge e{v, w, kNone, kNone};
      Index n = i;
      for (; n < b.begin[v + 1] && b.halves[n].other == w; ++n) {
        const Half& h = b.halves[n];
        Index& slot = h.direct ? e.f0 : e.f1;
        if (n - i >= 2)
          throw InputError(edge_name(v, w) + ": it has more than two faces; make it manifold");
        if (slot != kNone) {
          const Triangle &s = faces_[slot], &t = faces_[h.face];
          if (same_corners(s, t))
            throw InputError(name("face", h.face) + ": it duplicates face " + std::to_string(slot) +
                             "; remove duplicate faces");
          throw InputError(edge_name(v, w) +
                           ": its two faces are oriented inconsistently; orient the mesh");
        }
        slot = h.face;
        face_edges_[h.face][h.side] = edge_count();
      }
      if (e.f0 != kNone && e.f1 != kNone) {
        const Triangle &s = faces_[e.f0], &t = faces_[e.f1];
        if (same_corners(s, t))
          throw InputError(name("face", std::max(e.f0, e.f1)) + ": it duplicates face " +
                           std::to_string(std::min(e.f0, e.f1)) + " reversed; remove one of them");
      }
      edges_.push_back(e);
      i = n;
    }
  }
}

void TriangleMesh::build_rings() {
  const Index n = vertex_count();
  // A start corner per vertex: in the face of lowest index, or where the fan opens.
  std::vector<Index> start(n, kNone), degree(n, 0);
  boundary_vertex_.assign(n, 0);
  for (Index f = 0; f < face_count(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = faces_[f][k];
      ++degree[v];
      if (neighbour(f, static_cast<int>(k)) == kNone) {
        if (boundary_vertex_[v])
          throw InputError(name("vertex", v) + ": several fans of faces meet in it; split it");
        boundary_vertex_[v] = 1;
        start[v] = f;
      } else if (start[v] == kNone) {
        start[v] = f;
      }
    }
  ring_begin_.assign(n + 1, 0);
  for (Index v = 0; v < n; ++v) {
    if (degree[v] == 0)
      throw InputError(name("vertex", v) + ": it belongs to no face; remove isolated vertices");
    ring_begin_[v + 1] = ring_begin_[v] + degree[v] + boundary_vertex_[v];
  }
  ring_.resize(ring_begin_[n]);
  fan_.resize(ring_begin_[n], kNone);
  for (Index v = 0; v < n; ++v) {
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
    if (seen != degree[v])
      throw InputError(name("vertex", v) + ": several fans of faces meet in it; split it");
  }
}

void TriangleMesh::count_components_and_loops() {
  DisjointSets parts(vertex_count()), borders(vertex_count());
  for (const Edge& e : edges_) {
    parts.unite(e.v0, e.v1);
    if (e.f0 == kNone || e.f1 == kNone) borders.unite(e.v0, e.v1);
  }
  components_ = parts.count();
  // A boundary vertex has exactly two boundary edges, so boundary components are loops; every other
  // vertex is a set of its own.
  boundary_loops_ = borders.count();
  for (std::uint8_t b : boundary_vertex_) boundary_loops_ -= b == 0 ? 1 : 0;
}

}  // namespace crest::kernel
