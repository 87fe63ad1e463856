// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Generated meshes for the tests of coding and strips.
#include <algorithm>
#include <set>
#include <vector>

#include "algorithms/coding/coding.hpp"
#include "algorithms/sampling/random_triangulations.hpp"
#include "kernel/arithmetic/vec3.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

struct PlainMesh {
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  kernel::Index vertices() const { return static_cast<kernel::Index>(points.size()); }
};

/// A torus of m times n squares, each cut in two.
inline PlainMesh torus_grid(kernel::Index m, kernel::Index n) {
  PlainMesh mesh;
  for (kernel::Index i = 0; i < m; ++i)
    for (kernel::Index j = 0; j < n; ++j) {
      mesh.points.push_back({double(i), double(j), double((i * 7 + j * 13) % 5)});
      const kernel::Index a = i * n + j, b = (i + 1) % m * n + j;
      const kernel::Index c = (i + 1) % m * n + (j + 1) % n, d = i * n + (j + 1) % n;
      mesh.faces.push_back({a, b, c});
      mesh.faces.push_back({a, c, d});
    }
  return mesh;
}

/// A stacked sphere with points somewhere.
inline PlainMesh stacked_sphere(kernel::Index v, Random& random) {
  PlainMesh mesh;
  mesh.faces = sampling::stacked_sphere(v, random);
  for (kernel::Index w = 0; w < v; ++w)
    mesh.points.push_back(
        {double(random() % 1000), double(random() % 1000), double(random() % 1000)});
  return mesh;
}

/// New vertices in the middle of faces, `count` times.
inline PlainMesh with_stacked_faces(PlainMesh mesh, int count, Random& random) {
  for (int i = 0; i < count; ++i) {
    const std::size_t f = random() % mesh.faces.size();
    const auto [a, b, c] = mesh.faces[f];
    const kernel::Index x = mesh.vertices();
    mesh.points.push_back({double(i), double(random() % 100), 0});
    mesh.faces[f] = {a, b, x};
    mesh.faces.push_back({b, c, x});
    mesh.faces.push_back({c, a, x});
  }
  return mesh;
}

inline void flip_edges(PlainMesh& mesh, std::size_t flips, Random& random) {
  sampling::flip_edges(mesh.faces, mesh.vertices(), flips, random);
}

/// Leaves out the faces around some vertices that are not close to one another, and these vertices.
inline PlainMesh punch_holes(const PlainMesh& mesh, std::size_t holes, Random& random) {
  using Index = kernel::Index;
  std::vector<bool> near(mesh.points.size(), false), gone(mesh.points.size(), false);
  for (std::size_t tries = 0; holes > 0 && tries < 200; ++tries) {
    const auto v = static_cast<Index>(random() % mesh.points.size());
    std::set<Index> ring{v};
    for (int round = 0; round < 2; ++round) {
      const std::set<Index> before = ring;
      for (const kernel::Triangle& f : mesh.faces)
        if (before.count(f[0]) + before.count(f[1]) + before.count(f[2]) > 0)
          ring.insert(f.begin(), f.end());
    }
    if (std::any_of(ring.begin(), ring.end(), [&](Index w) { return near[w]; })) continue;
    for (const Index w : ring) near[w] = true;
    gone[v] = true;
    --holes;
  }
  PlainMesh result;
  std::vector<Index> number(mesh.points.size(), kernel::kNone);
  for (Index v = 0; v < mesh.points.size(); ++v) {
    if (gone[v]) continue;
    number[v] = result.vertices();
    result.points.push_back(mesh.points[v]);
  }
  for (const kernel::Triangle& f : mesh.faces)
    if (!gone[f[0]] && !gone[f[1]] && !gone[f[2]])
      result.faces.push_back({number[f[0]], number[f[1]], number[f[2]]});
  return result;
}

/// A surface of this genus: tori joined at triangles that are left out.
inline PlainMesh joined_tori(kernel::Index genus, kernel::Index m, kernel::Index n) {
  using Index = kernel::Index;
  PlainMesh mesh = torus_grid(m, n);
  for (Index g = 1; g < genus; ++g) {
    const PlainMesh other = torus_grid(m, n);
    const kernel::Triangle end = mesh.faces.back();
    mesh.faces.pop_back();
    // The other's first face, turned around, is where it is joined.
    const kernel::Triangle first = other.faces.front();
    std::vector<Index> number(other.points.size());
    for (Index v = 0; v < other.points.size(); ++v) {
      if (v == first[0])
        number[v] = end[0];
      else if (v == first[1])
        number[v] = end[2];
      else if (v == first[2])
        number[v] = end[1];
      else {
        number[v] = mesh.vertices();
        mesh.points.push_back(other.points[v]);
      }
    }
    for (std::size_t f = 1; f < other.faces.size(); ++f)
      mesh.faces.push_back(
          {number[other.faces[f][0]], number[other.faces[f][1]], number[other.faces[f][2]]});
  }
  return mesh;
}

}  // namespace crest::tests
