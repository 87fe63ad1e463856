// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Meshes in many ragged parts: single triangles, strips without inner vertices, holes, rims.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "kernel/geometry/triangle_mesh.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

/// Leaves out faces at vertices in which several fans meet, until there are none.
inline void leave_one_fan(std::vector<kernel::Triangle>& faces) {
  for (std::size_t before = faces.size() + 1; faces.size() != before;) {
    before = faces.size();
    std::map<kernel::Index, std::set<kernel::Index>> neighbours;
    std::map<kernel::Index, std::size_t> degree;
    for (const auto& f : faces)
      for (std::size_t k = 0; k < 3; ++k) {
        ++degree[f[k]];
        neighbours[f[k]].insert({f[(k + 1) % 3], f[(k + 2) % 3]});
      }
    // An open fan has one edge more than faces.
    std::erase_if(faces, [&](const kernel::Triangle& f) {
      return std::any_of(f.begin(), f.end(),
                         [&](kernel::Index v) { return neighbours[v].size() > degree[v] + 1; });
    });
  }
}

/// Of an n by n grid of squares, bent and shaken, most faces; numbered at random.
inline kernel::TriangleMesh ragged_mesh(kernel::Index n, Random& random) {
  std::vector<kernel::Vec3> places;
  const auto shaken = [&] { return static_cast<double>(random() % 1024) / 4096; };
  for (kernel::Index i = 0; i <= n; ++i)
    for (kernel::Index j = 0; j <= n; ++j) {
      const double x = i + shaken(), y = j + shaken();
      places.push_back({x, y, 0.1 * x * x - 0.07 * y * y + 0.2 * shaken()});
    }
  std::vector<kernel::Triangle> faces;
  for (kernel::Index i = 0; i < n; ++i)
    for (kernel::Index j = 0; j < n; ++j) {
      const kernel::Index a = i * (n + 1) + j, b = a + n + 1;
      for (const kernel::Triangle& f : {kernel::Triangle{a, b, b + 1}, {a, b + 1, a + 1}})
        if (random() % 6 != 0) faces.push_back(f);
    }
  leave_one_fan(faces);
  std::shuffle(faces.begin(), faces.end(), random);
  // Numbers in the order of the faces.
  std::map<kernel::Index, kernel::Index> number;
  std::vector<kernel::Vec3> points;
  for (kernel::Triangle& f : faces)
    for (kernel::Index& v : f) {
      const auto [at, is_new] = number.try_emplace(v, static_cast<kernel::Index>(points.size()));
      if (is_new) points.push_back(places[v]);
      v = at->second;
    }
  return {std::move(points), std::move(faces)};
}

}  // namespace crest::tests
