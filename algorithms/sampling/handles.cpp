// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/handles.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <map>
#include <stdexcept>

namespace crest::sampling {
namespace {

using CgalPoint = CGAL::Simple_cartesian<double>::Point_3;
using CgalMesh = CGAL::Surface_mesh<CgalPoint>;
using Corner = std::array<int, 3>;

/// Cubes of the bar, each side cut into `parts`.
struct Bar {
  int genus, parts;
  bool filled(const Corner& cube) const {
    const int x = cube[0], y = cube[1], z = cube[2];
    const int size[] = {(2 * genus + 1) * parts, 3 * parts, parts};
    if (x < 0 || y < 0 || z < 0 || x >= size[0] || y >= size[1] || z >= size[2]) return false;
    return y / parts != 1 || x / parts % 2 == 0;
  }
};

/// The squares between a cube of the bar and one that is not, outward.
CgalMesh boundary(const Bar& bar) {
  CgalMesh mesh;
  std::map<Corner, CgalMesh::Vertex_index> vertices;
  const auto vertex = [&](const Corner& c) {
    const auto [at, added] = vertices.try_emplace(c);
    const double parts = bar.parts;
    if (added)
      at->second = mesh.add_vertex(
          {c[0] / parts - (2 * bar.genus + 1) / 2.0, c[1] / parts - 1.5, c[2] / parts - 0.5});
    return at->second;
  };
  const auto add_side = [&](Corner cube, std::size_t axis, int direction) {
    Corner next = cube;
    next[axis] += direction;
    if (!bar.filled(cube) || bar.filled(next)) return;
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    Corner corner = cube;
    corner[axis] += direction > 0;
    std::array<Corner, 4> square = {corner, corner, corner, corner};
    ++square[1][u];
    ++square[2][u];
    ++square[2][v];
    ++square[3][v];
    if (direction < 0) std::swap(square[1], square[3]);
    mesh.add_face(vertex(square[0]), vertex(square[1]), vertex(square[2]), vertex(square[3]));
  };
  for (int x = 0; x < (2 * bar.genus + 1) * bar.parts; ++x)
    for (int y = 0; y < 3 * bar.parts; ++y)
      for (int z = 0; z < bar.parts; ++z)
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (const int direction : {-1, 1}) add_side({x, y, z}, axis, direction);
  return mesh;
}

}  // namespace

SurfaceSample sample_handles(int genus, int vertices, bool rotate) {
  if (genus < 0 || genus > 100)
    throw std::invalid_argument("handles: the genus is a whole number from 0 to 100");
  // There are (18 genus + 14) n^2 squares, nearly as many as vertices: n = parts 2^steps.
  const double n = std::sqrt(vertices / (18.0 * genus + 14));
  const int steps = n > 8 ? static_cast<int>(std::log2(n / 4)) : 1;
  const Bar bar{genus, std::max(1, static_cast<int>(std::lround(n / std::exp2(steps))))};
  CgalMesh mesh = boundary(bar);
  CGAL::Subdivision_method_3::CatmullClark_subdivision(
      mesh, CGAL::parameters::number_of_iterations(static_cast<unsigned>(steps)));

  SurfaceSample sample;
  sample.known.euler_characteristic = 2 - 2 * genus;
  const Surface::Rotation pose = generic_rotation(0);
  for (const auto v : mesh.vertices()) {
    const CgalPoint& p = mesh.point(v);
    Point q = {static_cast<Real>(p.x()), static_cast<Real>(p.y()), static_cast<Real>(p.z())};
    if (rotate) q = pose * q;
    sample.points.push_back(
        {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2])});
  }
  for (const auto f : mesh.faces()) {
    std::array<kernel::Index, 4> c{};
    std::size_t k = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) c[k++] = v;
    sample.faces.push_back({c[0], c[1], c[2]});
    sample.faces.push_back({c[0], c[2], c[3]});
  }
  return sample;
}

}  // namespace crest::sampling
