// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/quadratic_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "kernel/geometry/mesh_checks.hpp"

namespace crest::kernel {
namespace {

void require_proper_vertices(const std::vector<Vec3>& points, const std::vector<double>& values) {
  if (points.size() >= kNone) throw InputError("mesh: it has too many vertices for 32-bit numbers");
  if (values.size() != points.size())
    throw InputError("field: it has " + std::to_string(values.size()) + " values for " +
                     std::to_string(points.size()) + " vertices; give one value a vertex");
  for (Index v = 0; v < points.size(); ++v) {
    require_finite(v, points[v]);
    if (!std::isfinite(values[v]))
      throw InputError(name("vertex", v) +
                       ": its value is not a finite number; repair the field or remove the vertex");
  }
}

void require_proper_faces(Index vertices, const std::vector<Triangle>& faces) {
  if (faces.empty()) throw InputError("mesh: it has no faces; give a triangle mesh");
  if (faces.size() >= kNone / 3) throw InputError("mesh: it has too many faces for 32-bit numbers");
  for (Index f = 0; f < faces.size(); ++f) require_three_vertices(f, faces[f], vertices);
}

void require_proper_midsides(Index faces, const std::vector<std::array<double, 3>>& midside) {
  if (midside.empty()) return;
  if (midside.size() != faces)
    throw InputError("field: it has midside values for " + std::to_string(midside.size()) + " of " +
                     std::to_string(faces) + " faces; give three values a face");
  for (Index f = 0; f < faces; ++f)
    for (double x : midside[f])
      if (!std::isfinite(x))
        throw InputError(name("face", f) +
                         ": a midside value is not a finite number; repair the field");
}

// A side seen from its smaller corner; at = 3 face + side.
struct Half {
  Index other, at;
};

struct HalfBuckets {
  std::vector<Index> begin;  // V + 1
  std::vector<Half> halves;  // 3F, grouped by smaller vertex, sorted by (other, face)
};

HalfBuckets bucket_halves(Index vertices, const std::vector<Triangle>& faces) {
  HalfBuckets b;
  b.begin.assign(vertices + std::size_t{1}, 0);
  for (const Triangle& t : faces)
    for (std::size_t k = 0; k < 3; ++k) ++b.begin[std::min(t[k], t[(k + 1) % 3])];
  // begin[v] becomes the end of bucket v; filling backwards turns it into the start.
  std::partial_sum(b.begin.begin(), b.begin.end(), b.begin.begin());
  b.halves.resize(3 * faces.size());
  for (Index at = static_cast<Index>(3 * faces.size()); at-- > 0;) {
    const Triangle& t = faces[at / 3];
    const Index p = t[at % 3], q = t[(at + 1) % 3];
    b.halves[--b.begin[std::min(p, q)]] = {std::max(p, q), at};
  }
  for (Index v = 0; v < vertices; ++v) {
    Half* const first = b.halves.data() + b.begin[v];
    Half* const last = b.halves.data() + b.begin[v + std::size_t{1}];
    if (last - first > 32) {  // a hub
      std::sort(first, last, [](const Half& a, const Half& c) {
        return a.other != c.other ? a.other < c.other : a.at < c.at;
      });
      continue;
    }
    for (Half* i = first; i < last; ++i) {
      const Half h = *i;
      Half* j = i;
      for (; j != first && h.other < (j - 1)->other; --j) *j = *(j - 1);
      *j = h;
    }
  }
  return b;
}

void require_different(const std::vector<Triangle>& faces, Index f, Index g) {
  if (same_corners(faces[f], faces[g]))
    throw InputError(name("face", std::max(f, g)) + ": it duplicates face " +
                     std::to_string(std::min(f, g)) + "; remove one of them");
}

struct Incidence {
  std::vector<Edge> edges;
  std::vector<std::array<Index, 3>> face_edges;
};

Incidence build_edges(Index vertices, const std::vector<Triangle>& faces) {
  const HalfBuckets b = bucket_halves(vertices, faces);
  Incidence result;
  result.face_edges.resize(faces.size());
  Index count = 0;
  for (Index v = 0; v < vertices; ++v)
    for (Index i = b.begin[v]; i < b.begin[v + std::size_t{1}]; ++i)
      count += i == b.begin[v] || b.halves[i].other != b.halves[i - 1].other;
  result.edges.reserve(count);
  for (Index v = 0; v < vertices; ++v) {
    const Index end = b.begin[v + std::size_t{1}];
    for (Index i = b.begin[v]; i < end;) {
      const Index w = b.halves[i].other, number = static_cast<Index>(result.edges.size());
      Index n = i;
      for (; n < end && b.halves[n].other == w; ++n)
        result.face_edges[b.halves[n].at / 3][b.halves[n].at % 3] = number;
      Edge e{v, w, b.halves[i].at / 3, kNone};
      if (n - i >= 2) {
        e.f1 = b.halves[i + 1].at / 3;
        require_different(faces, e.f0, e.f1);
      }
      if (n - i > 2)
        throw InputError(edge_name(v, w) +
                         ": it has more than two faces; make the surface a manifold");
      result.edges.push_back(e);
      i = n;
    }
  }
  return result;
}

// Every vertex has at most two boundary edges a link component, so the link is one cycle or path
// iff one walk from face to face around the vertex sees all of its faces.
void require_manifold_vertices(Index vertices, const std::vector<Triangle>& faces,
                               const Incidence& mesh) {
  std::vector<Index> start(vertices, kNone), degree(vertices, 0);
  for (Index f = 0; f < faces.size(); ++f)
    for (Index v : faces[f]) {
      start[v] = f;
      ++degree[v];
    }
  // The walk crosses, in each face, the side at v that it did not enter by.
  auto walk = [&](Index v, Index first, Index entered) {
    Index seen = 0, f = first, by = entered;
    do {
      ++seen;
      const Triangle& t = faces[f];
      const std::size_t k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      const Index a = mesh.face_edges[f][k], b = mesh.face_edges[f][(k + 2) % 3];
      by = by == a ? b : a;
      const Edge& e = mesh.edges[by];
      f = e.f0 == f ? e.f1 : e.f0;
    } while (f != kNone && f != first && seen <= degree[v]);
    return std::pair{seen, f == kNone};
  };
  for (Index v = 0; v < vertices; ++v) {
    if (degree[v] == 0)
      throw InputError(name("vertex", v) + ": it belongs to no face; remove isolated vertices");
    const Index f = start[v];
    const Triangle& t = faces[f];
    const std::size_t k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    const auto [seen, open] = walk(v, f, mesh.face_edges[f][k]);
    // On a path the walk leaves part of it behind: go the other way too.
    const Index all = open ? seen + walk(v, f, mesh.face_edges[f][(k + 2) % 3]).first - 1 : seen;
    if (all != degree[v])
      throw InputError(name("vertex", v) + ": several fans of faces meet in it; split it");
  }
}

std::vector<double> join_midsides(const std::vector<Edge>& edges,
                                  const std::vector<std::array<Index, 3>>& face_edges,
                                  const std::vector<std::array<double, 3>>& midside) {
  std::vector<double> values(midside.empty() ? 0 : edges.size());
  for (Index f = 0; f < midside.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge& e = edges[face_edges[f][k]];
      double& value = values[face_edges[f][k]];
      if (e.f0 == f)
        value = midside[f][k];  // f0 < f1: set before it is compared
      else if (value != midside[f][k])
        throw InputError(edge_name(e.v0, e.v1) + ": faces " + std::to_string(e.f0) + " and " +
                         std::to_string(f) +
                         " have different midside values on it; make the field continuous");
    }
  return values;
}

}  // namespace

QuadraticMesh::QuadraticMesh(std::vector<Vec3> points, std::vector<Triangle> faces,
                             std::vector<double> values,
                             const std::vector<std::array<double, 3>>& midside)
    : points_(std::move(points)), faces_(std::move(faces)), values_(std::move(values)) {
  require_proper_vertices(points_, values_);
  require_proper_faces(vertex_count(), faces_);
  require_proper_midsides(face_count(), midside);
  Incidence incidence = build_edges(vertex_count(), faces_);
  require_manifold_vertices(vertex_count(), faces_, incidence);
  edges_ = std::move(incidence.edges);
  face_edges_ = std::move(incidence.face_edges);
  edge_values_ = join_midsides(edges_, face_edges_, midside);
}

}  // namespace crest::kernel
