// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "kernel/geometry/input_error.hpp"
#include "kernel/predicates/collinear.hpp"

namespace crest::kernel {
namespace {

std::string name(const char* what, Index i) {
  return std::string(what) + " " + std::to_string(i);
}

void require_finite(const std::vector<Vec3>& points) {
  for (Index v = 0; v < points.size(); ++v)
    for (double x : points[v])
      if (!std::isfinite(x))
        throw InputError(name("vertex", v) +
                         ": a coordinate is not a finite number; remove the vertex and its faces");
}

void require_proper_faces(const std::vector<Vec3>& points, const std::vector<Triangle>& faces) {
  if (faces.empty()) throw InputError("mesh: it has no faces; give a triangle mesh");
  for (Index f = 0; f < faces.size(); ++f) {
    const auto [a, b, c] = faces[f];
    if (std::max({a, b, c}) >= points.size())
      throw InputError(name("face", f) + ": a vertex number is out of range; repair the file");
    if (a == b || b == c || c == a)
      throw InputError(name("face", f) + ": it repeats a vertex; remove degenerate faces");
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
  require_finite(points_);
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
        const std::string edge = "edge " + std::to_string(v) + "-" + std::to_string(w);
        if (n - i >= 2) throw InputError(edge + ": it has more than two faces; make it manifold");
        if (slot != kNone) {
          const Triangle &s = faces_[slot], &t = faces_[h.face];
          auto third = [&](const Triangle& u) { return u[0] ^ u[1] ^ u[2]; };
          if (third(s) == third(t))
            throw InputError(name("face", h.face) + ": it duplicates face " + std::to_string(slot) +
                             "; remove duplicate faces");
          throw InputError(edge + ": its two faces are oriented inconsistently; orient the mesh");
        }
        slot = h.face;
        face_edges_[h.face][h.side] = edge_count();
      }
      if (e.f0 != kNone && e.f1 != kNone) {
        const Triangle &s = faces_[e.f0], &t = faces_[e.f1];
        if ((s[0] ^ s[1] ^ s[2]) == (t[0] ^ t[1] ^ t[2]))
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
  auto count_classes = [](Index n, auto&& for_each_pair) {
    std::vector<Index> root(n);
    std::iota(root.begin(), root.end(), 0u);
    auto find = [&](Index i) {
      while (root[i] != i) i = root[i] = root[root[i]];
      return i;
    };
    Index merged = 0;
    for_each_pair([&](Index a, Index b) {
      a = find(a);
      b = find(b);
      if (a != b) {
        root[std::max(a, b)] = std::min(a, b);
        ++merged;
      }
    });
    return merged;
  };
  components_ = vertex_count() - count_classes(vertex_count(), [&](auto&& unite) {
                  for (const Edge& e : edges_) unite(e.v0, e.v1);
                });
  // A boundary vertex has exactly two boundary edges, so boundary components are loops.
  Index boundary_vertices = 0;
  for (std::uint8_t b : boundary_vertex_) boundary_vertices += b;
  boundary_loops_ = boundary_vertices - count_classes(vertex_count(), [&](auto&& unite) {
                      for (const Edge& e : edges_)
                        if (e.f0 == kNone || e.f1 == kNone) unite(e.v0, e.v1);
                    });
}

}  // namespace crest::kernel
