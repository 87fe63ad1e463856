// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/002-ridges/remeshed.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <stdexcept>
#include <utility>

#include "algorithms/sampling/mesh_surface.hpp"

namespace crest::experiments {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh to_cgal(const kernel::TriangleMesh& mesh) {
  Mesh result;
  for (const auto& p : mesh.points()) result.add_vertex({p[0], p[1], p[2]});
  for (const auto& f : mesh.faces())
    if (result.add_face(Mesh::Vertex_index(f[0]), Mesh::Vertex_index(f[1]),
                        Mesh::Vertex_index(f[2])) == Mesh::null_face())
      throw std::runtime_error("CGAL::Surface_mesh refuses a face");
  return result;
}

kernel::TriangleMesh from_cgal(Mesh& mesh) {
  mesh.collect_garbage();  // numbers without gaps
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  for (const auto v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : mesh.faces()) {
    kernel::Triangle t;
    std::size_t k = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) t[k++] = v.idx();
    faces.push_back(t);
  }
  return {std::move(points), std::move(faces)};
}

}  // namespace

kernel::TriangleMesh decimated(const kernel::TriangleMesh& mesh) {
  namespace Simplification = CGAL::Surface_mesh_simplification;
  Mesh result = to_cgal(mesh);
  Simplification::edge_collapse(result, Simplification::Count_ratio_stop_predicate<Mesh>(0.5));
  return from_cgal(result);
}

kernel::TriangleMesh remeshed(const kernel::TriangleMesh& mesh) {
  namespace Processing = CGAL::Polygon_mesh_processing;
  Mesh result = to_cgal(mesh);
  Processing::isotropic_remeshing(result.faces(),
                                  sampling::mean_edge_length(mesh.points(), mesh.faces()), result,
                                  Processing::parameters::number_of_iterations(3));
  return from_cgal(result);
}

}  // namespace crest::experiments
