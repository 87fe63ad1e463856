// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Meshes with known topology, and Betti numbers the slow way.
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "algorithms/feature_lines/topology.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

using feature_lines::Betti;
using feature_lines::Marks;
using kernel::Index;
using kernel::Triangle;
using kernel::TriangleMesh;
using kernel::Vec3;
/// Vertex 0 in the middle of a fan; its neighbours 1 .. n around a cycle, or along a path.
inline TriangleMesh fan(Index n, bool closed) {
  std::vector<Vec3> points = {{0, 0, 0}};
  std::vector<Triangle> faces;
  for (Index k = 0; k < n; ++k) {
    const double t = 6.283185307179586 * k / (closed ? n : 2.0 * n);
    points.push_back({std::cos(t), std::sin(t), 0});
    if (k + 1 < n) faces.push_back({0, k + 1, k + 2});
  }
  if (closed) faces.push_back({0, n, 1});
  return TriangleMesh(points, faces);
}

/// (m + 1)(n + 1) vertices, vertex x + (m + 1) y at (x, y, 0); squares with a hole are left out.
inline TriangleMesh grid(Index m, Index n, std::set<std::pair<Index, Index>> holes = {}) {
  std::vector<Vec3> points;
  std::vector<Triangle> faces;
  for (Index y = 0; y <= n; ++y)
    for (Index x = 0; x <= m; ++x) points.push_back({double(x), double(y), 0});
  for (Index y = 0; y < n; ++y) {
    for (Index x = 0; x < m; ++x) {
      if (holes.count({x, y})) continue;
      const Index a = x + (m + 1) * y, b = a + 1, c = a + m + 2, d = a + m + 1;
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
  }
  return TriangleMesh(points, faces);
}

/// m n vertices, vertex i + m j; m goes round the axis, n round the tube.
inline TriangleMesh torus(Index m, Index n) {
  std::vector<Vec3> points;
  std::vector<Triangle> faces;
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < m; ++i) {
      const double u = 6.283185307179586 * i / m, v = 6.283185307179586 * j / n;
      const double r = 3 + std::cos(v);
      points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
      const Index a = i + m * j, b = (i + 1) % m + m * j;
      const Index c = (i + 1) % m + m * ((j + 1) % n), d = i + m * ((j + 1) % n);
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
  }
  return TriangleMesh(points, faces);
}

/// The surface of a plate of unit cubes with `genus` holes, each cube split into `s` a side.
/// genus 0: a box.
inline TriangleMesh plate(int genus, int s) {
  const auto full = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= (2 * genus + 1) * s || y >= 3 * s || z >= s) return false;
    return !(x / s % 2 == 1 && y / s == 1);
  };
  std::map<std::array<int, 3>, Index> number;
  std::vector<Vec3> points;
  std::vector<Triangle> faces;
  const auto vertex = [&](std::array<int, 3> p) {
    const auto [at, fresh] = number.emplace(p, static_cast<Index>(points.size()));
    if (fresh) points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return at->second;
  };
  for (int x = 0; x < (2 * genus + 1) * s; ++x) {
    for (int y = 0; y < 3 * s; ++y) {
      for (int z = 0; z < s; ++z) {
        if (!full(x, y, z)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (const int side : {0, 1}) {
            std::array<int, 3> next = {x, y, z};
            next[axis] += side ? 1 : -1;
            if (full(next[0], next[1], next[2])) continue;
            std::array<std::array<int, 3>, 4> q;
            q.fill({x, y, z});
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (auto& p : q) p[axis] += side;
            ++q[1][u], ++q[2][u], ++q[2][v], ++q[3][v];
            if (!side) std::swap(q[1], q[3]);
            const Index a = vertex(q[0]), b = vertex(q[1]), c = vertex(q[2]), d = vertex(q[3]);
            faces.push_back({a, b, c});
            faces.push_back({a, c, d});
          }
        }
      }
    }
  }
  return TriangleMesh(points, faces);
}

/// Blobs, bands and salt: `density` of the vertices, then so many rings around them.
inline Marks random_marks(const TriangleMesh& mesh, Random& random, double density, Index rings) {
  Marks marks(mesh.vertex_count(), 0);
  for (auto& m : marks) m = static_cast<double>(random() % 1000000) < 1e6 * density ? 1 : 0;
  return feature_lines::dilate(mesh, marks,
                               {feature_lines::Neighbourhood::rings, static_cast<double>(rings)});
}

/// Rank over Z/2 of columns given as sets of rows.
inline Index rank_mod_2(std::vector<std::set<Index>> columns) {
  std::map<Index, std::set<Index>> pivots;  // by largest row
  for (auto& column : columns) {
    while (!column.empty()) {
      const auto pivot = pivots.find(*column.rbegin());
      if (pivot == pivots.end()) {
        pivots.emplace(*column.rbegin(), column);
        break;
      }
      for (const Index row : pivot->second)
        if (!column.insert(row).second) column.erase(row);
    }
  }
  return static_cast<Index>(pivots.size());
}

/// Simplices of the subcomplex of vertices with this mark, listed from the faces alone; Betti
/// numbers from the ranks of its boundary maps.
inline Betti betti_by_ranks(const TriangleMesh& mesh, const Marks& marks, std::uint8_t mark) {
  std::set<Index> vertices;
  std::map<std::pair<Index, Index>, Index> edges;
  std::vector<std::set<Index>> edge_columns, face_columns;
  const auto edge = [&](Index a, Index b) {
    const auto [at, fresh] = edges.emplace(std::minmax(a, b), static_cast<Index>(edges.size()));
    if (fresh) edge_columns.push_back({a, b});
    return at->second;
  };
  for (const Triangle& f : mesh.faces()) {
    Index in = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (marks[f[k]] != mark) continue;
      ++in;
      vertices.insert(f[k]);
      if (marks[f[(k + 1) % 3]] == mark) edge(f[k], f[(k + 1) % 3]);
    }
    if (in == 3) face_columns.push_back({edge(f[0], f[1]), edge(f[1], f[2]), edge(f[2], f[0])});
  }
  const auto v = static_cast<Index>(vertices.size()), e = static_cast<Index>(edges.size()),
             f = static_cast<Index>(face_columns.size());
  const Index r1 = rank_mod_2(edge_columns), r2 = rank_mod_2(face_columns);
  return {static_cast<int>(v) - static_cast<int>(e) + static_cast<int>(f), v - r1, e - r1 - r2,
          f - r2};
}

struct NamedMesh {
  const char* name;
  TriangleMesh mesh;
};

/// Closed, bounded, with holes, genus 0 to 3; at most 400 vertices.
inline std::vector<NamedMesh> sample_meshes() {
  std::vector<NamedMesh> all;
  all.push_back({"tetrahedron", TriangleMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                             {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}})});
  all.push_back({"fan of 7", fan(7, true)});
  all.push_back({"grid", grid(12, 9)});
  all.push_back({"annulus", grid(9, 9, {{4, 4}})});
  all.push_back({"grid with three holes", grid(14, 9, {{2, 2}, {7, 4}, {11, 6}})});
  all.push_back({"strip", grid(20, 1)});
  all.push_back({"torus", torus(16, 9)});
  all.push_back({"thin torus", torus(12, 3)});
  all.push_back({"box", plate(0, 4)});
  all.push_back({"genus 2", plate(2, 2)});
  all.push_back({"genus 3", plate(3, 2)});
  return all;
}

}  // namespace crest::tests
