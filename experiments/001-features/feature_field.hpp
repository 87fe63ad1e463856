// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the feature experiments share: the field and CGAL's sharp edges.
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/feature_lines/feature_lines.hpp"
#include "algorithms/ridges/ridges.hpp"

namespace crest::experiments {

/// max(|k1|, |k2|) as `crest features --method METHOD` takes it: of the fitted Monge forms ("fit"),
/// or by a method of crest curvature.
inline std::vector<double> curvature_field(const kernel::TriangleMesh& mesh,
                                           const std::string& method = "fit") {
  std::vector<double> field;
  if (method != "fit") {
    curvature::Options options;
    options.method = curvature::method_of(method).value();
    for (const auto& c : curvature::estimate(mesh, options).vertices)
      field.push_back(std::max(std::fabs(c.k1), std::fabs(c.k2)));
    return field;
  }
  ridges::FitOptions options;
  for (const auto& form : ridges::fit_monge_forms(mesh, options).forms)
    field.push_back(std::max(std::fabs(form.k1), std::fabs(form.k2)));
  return field;
}

/// Edges whose faces' normals differ by more than `degrees` (CGAL detect_sharp_edges); on a mesh
/// with boundary CGAL counts the boundary edges too.
inline std::vector<std::array<kernel::Index, 2>> sharp_edges(const kernel::TriangleMesh& mesh,
                                                             double degrees) {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  Mesh m;
  for (const auto& p : mesh.points()) m.add_vertex(Point(p[0], p[1], p[2]));
  for (const auto& f : mesh.faces())
    m.add_face(Mesh::Vertex_index(f[0]), Mesh::Vertex_index(f[1]), Mesh::Vertex_index(f[2]));
  auto sharp = m.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(m, degrees, sharp);
  std::vector<std::array<kernel::Index, 2>> edges;
  for (const auto e : m.edges())
    if (sharp[e]) edges.push_back({m.vertex(e, 0).idx(), m.vertex(e, 1).idx()});
  return edges;
}

/// Vertices with exactly one of these edges.
inline int dangling_ends(const kernel::TriangleMesh& mesh,
                         const std::vector<std::array<kernel::Index, 2>>& edges) {
  std::vector<int> degree(mesh.vertex_count(), 0);
  for (const auto& [a, b] : edges) ++degree[a], ++degree[b];
  return static_cast<int>(std::count(degree.begin(), degree.end(), 1));
}

}  // namespace crest::experiments
