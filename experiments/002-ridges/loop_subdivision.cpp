// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/002-ridges/loop_subdivision.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <stdexcept>

namespace crest::experiments {

kernel::TriangleMesh loop_subdivision(const kernel::TriangleMesh& mesh) {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  Mesh finer;
  for (const auto& p : mesh.points()) finer.add_vertex(Point(p[0], p[1], p[2]));
  for (const auto& f : mesh.faces())
    if (finer.add_face(Mesh::Vertex_index(f[0]), Mesh::Vertex_index(f[1]),
                       Mesh::Vertex_index(f[2])) == Mesh::null_face())
      throw std::runtime_error("CGAL::Surface_mesh refuses a face");
  CGAL::Subdivision_method_3::Loop_subdivision(finer, CGAL::parameters::number_of_iterations(1));
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  for (const auto v : finer.vertices()) {
    const Point& p = finer.point(v);
    points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : finer.faces()) {
    kernel::Triangle t{};
    std::size_t k = 0;
    for (const auto v : finer.vertices_around_face(finer.halfedge(f))) t[k++] = kernel::Index(v);
    faces.push_back(t);
  }
  return {std::move(points), std::move(faces)};
}

}  // namespace crest::experiments
